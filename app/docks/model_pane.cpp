#include "docks/model_pane.h"

#include <QComboBox>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "integration/colouring.h"
#include "window/flow_layout.h"

namespace vantage {
ModelPane::ModelPane(const SurfaceMaker& surfaces, const std::shared_ptr<GeometryStore>& store, QWidget* parent)
    : QWidget(parent),
      view_(new ModelView(surfaces, nullptr, store)),
      notice_(new QToolButton),
      column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(0);
  auto* bar = new FlowLayout(6);
  bar->setContentsMargins(6, 4, 6, 4);
  colouring_ = addChoice(*bar, tr("Colour of the surface"), {tr("Plain"), tr("Confidence"), tr("View"), tr("Age")},
                         [this](ModelViewOptions& o, int i) {
                           o.colouring = static_cast<ModelColouring>(colouring_->itemData(i).toInt());
                         });
  for (int i = 0; i < colouring_->count(); ++i) colouring_->setItemData(i, i);  // as ModelColouring has them
  colouring_->setObjectName(QStringLiteral("colouring"));
  addChoice(*bar, tr("Colour of the unseen edges"), {tr("Edges by kind"), tr("Edges by state")},
            [](ModelViewOptions& o, int i) { o.voidColouring = static_cast<VoidColouring>(i); });
  addSwitch(*bar, tr("Unseen"), tr("Unseen edges: where the model ends and the unseen begins (void patches)"),
            &ModelViewOptions::voidPatches);
  addSwitch(*bar, tr("Last rays"), tr("Rays of the last view"), &ModelViewOptions::currentRays);
  addSwitch(*bar, tr("Next rays"), tr("Rays of the proposed view, or of the position asked about"),
            &ModelViewOptions::proposedRays);
  addSwitch(*bar, tr("Table"), tr("Turntable with its scale"), &ModelViewOptions::turntable);
  addCamera(*bar);
  addErase(*bar);
  column_->addLayout(bar);
  notice_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  notice_->setObjectName(QStringLiteral("notice"));
  notice_->hide();
  column_->addWidget(notice_);
  column_->addWidget(view_, 1);
  connect(notice_, &QToolButton::clicked, this, &ModelPane::noticeClicked);
}

void ModelPane::setSnapshot(const SharedSnapshot& snapshot) {
  const QSignalBlocker quiet(colouring_);
  offer(ModelColouring::Colours, tr("Colours"), snapshot && haveColours(snapshot->views));
  offer(ModelColouring::Stand, tr("Stand"), snapshot && haveStands(snapshot->views));
  showColouring();
  view_->setSnapshot(snapshot);
}

// Choices that not every model has are the last.
void ModelPane::offer(ModelColouring colouring, const QString& text, bool offered) {
  const int index = colouring_->findData(static_cast<int>(colouring));
  if (offered && index < 0) colouring_->addItem(text, static_cast<int>(colouring));
  if (!offered && index >= 0) colouring_->removeItem(index);
}

// Colours are chosen by themselves as long as nobody has chosen another.
void ModelPane::showColouring() {
  const ModelColouring wanted = view_->options().colouring.value_or(ModelColouring::Colours);
  colouring_->setCurrentIndex(std::max(colouring_->findData(static_cast<int>(wanted)), 0));
}

QComboBox* ModelPane::addChoice(QLayout& bar, const QString& name, const QStringList& options,
                                const std::function<void(ModelViewOptions&, int)>& apply) {
  auto* box = new QComboBox;
  box->addItems(options);
  box->setToolTip(name);
  box->setAccessibleName(name);
  connect(box, &QComboBox::currentIndexChanged, this, [this, apply](int index) {
    ModelViewOptions changed = view_->options();
    apply(changed, index);
    view_->setOptions(changed);
  });
  bar.addWidget(box);
  return box;
}

void ModelPane::addSwitch(QLayout& bar, const QString& text, const QString& help, bool ModelViewOptions::*value) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setToolTip(help);
  button->setAccessibleName(help);
  button->setCheckable(true);
  button->setProperty("layer", true);
  button->setChecked(view_->options().*value);
  connect(button, &QToolButton::toggled, this, [this, value](bool on) {
    ModelViewOptions changed = view_->options();
    changed.*value = on;
    view_->setOptions(changed);
  });
  bar.addWidget(button);
}

void ModelPane::addCamera(QLayout& bar) {
  auto* button = new QToolButton;
  button->setText(tr("Camera"));
  button->setAccessibleName(tr("Camera"));
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  const std::pair<QString, CameraPreset> presets[] = {{tr("Fit"), CameraPreset::Fit},
                                                      {tr("Front"), CameraPreset::Front},
                                                      {tr("Top"), CameraPreset::Top},
                                                      {tr("Scanner's eye"), CameraPreset::ScannersEye},
                                                      {tr("Oblique"), CameraPreset::Oblique}};
  for (const auto& [text, preset] : presets)
    connect(menu->addAction(text), &QAction::triggered, this, [this, chosen = preset] { view_->lookFrom(chosen); });
  button->setMenu(menu);
  bar.addWidget(button);
}

void ModelPane::addErase(QLayout& bar) {
  auto* button = new QToolButton;
  button->setText(tr("Erase…"));
  button->setObjectName(QStringLiteral("erase"));
  button->setToolTip(tr("Erase what is not the object: putty, a clamp, the table, loose pieces"));
  button->setAccessibleName(button->toolTip());
  connect(button, &QToolButton::clicked, this, &ModelPane::eraseWanted);
  bar.addWidget(button);
}

void ModelPane::addRow(QWidget& row) {
  column_->insertWidget(column_->indexOf(view_), &row);
}

void ModelPane::setNotice(const QString& text) {
  notice_->setText(text);
  notice_->setAccessibleName(text);
  notice_->setVisible(!text.isEmpty());
}

}  // namespace vantage
