#include "stands/pose_chooser.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "form_parts.h"
#include "stands/pose_words.h"
#include "views/composite_view.h"

namespace vantage {
namespace {

constexpr QSize kIcon(132, 100);
constexpr int kListWidth = 400;

// Its colours stay as they are when it is chosen.
QIcon iconOf(const QPixmap& pixmap) {
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);
  return icon;
}

QIcon emptyIcon(const Theme& theme) {
  QPixmap pixmap(kIcon);
  pixmap.fill(theme.backgroundTop);
  return iconOf(pixmap);
}

}  // namespace

PoseChooser::PoseChooser(const SurfaceMaker& surfaces, const Theme& theme, NavigationScheme navigation, QWidget* parent)
    : QWidget(parent),
      theme_(theme),
      view_(new CompositeView(surfaces, tr("Object and stand over each other"))),
      list_(new QListWidget),
      use_(makeButton(tr("&Use this one"), QStringLiteral("usePose"),
                      tr("The stand becomes part of the model in this pose. It can be undone."), true)) {
  view_->setTheme(theme);
  view_->setNavigation(navigation);
  build();
  connect(list_, &QListWidget::currentRowChanged, this, &PoseChooser::showCurrent);
  connect(use_, &QPushButton::clicked, this, [this] {
    if (const auto pose = current())
      emit useRequested(*pose, !alignment_->candidates[static_cast<std::size_t>(*pose)].possible);
  });
  refreshUse();
}

void PoseChooser::build() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  auto* column = new QVBoxLayout;
  list_->setObjectName(QStringLiteral("poses"));
  list_->setAccessibleName(tr("Poses that were found"));
  list_->setIconSize(kIcon);
  list_->setFixedWidth(kListWidth);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  column->addWidget(list_, 1);
  column->addWidget(use_);
  row->addLayout(column);
  row->addWidget(view_, 1);
}

void PoseChooser::showSurfaces(const ComparedStand& stand) {
  view_->showSurfaces(stand.object, stand.stand);
  showCurrent();
}

void PoseChooser::setAlignment(const std::shared_ptr<const StandAlignment>& alignment) {
  const QSignalBlocker quiet(list_);
  alignment_ = alignment;
  looks_.clear();
  list_->clear();
  const std::size_t count = alignment ? alignment->candidates.size() : 0;
  looks_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const StandPose& pose = alignment->candidates[i];
    QString text = poseTitle(static_cast<int>(i), pose);
    if (alignment->used == static_cast<int>(i)) text += tr(", in use");
    auto* item = new QListWidgetItem(emptyIcon(theme_), text + QLatin1Char('\n') + poseFigures(pose));
    list_->addItem(item);
  }
  if (count > 0) list_->setCurrentRow(alignment->used.value_or(0));
  showCurrent();
  view_->lookFrom(CameraPreset::Fit);
}

void PoseChooser::setLook(int pose, const PoseLook& look) {
  if (pose < 0 || pose >= static_cast<int>(looks_.size())) return;
  looks_[static_cast<std::size_t>(pose)] = look;
  list_->item(pose)->setIcon(iconOf(QPixmap::fromImage(look.picture)));
  if (current() == pose) showCurrent();
}

void PoseChooser::setWhyNot(const QString& whyNot) {
  whyNot_ = whyNot;
  refreshUse();
}

std::optional<int> PoseChooser::current() const {
  const int row = list_->currentRow();
  return alignment_ && row >= 0 && row < static_cast<int>(looks_.size()) ? std::optional(row) : std::nullopt;
}

void PoseChooser::showCurrent() {
  const auto pose = current();
  view_->setTitle(pose ? poseTitle(*pose, alignment_->candidates[static_cast<std::size_t>(*pose)])
                       : tr("As each of them stands on the table"));
  if (pose)
    view_->setPose(alignment_->candidates[static_cast<std::size_t>(*pose)].T_object_stand,
                   looks_[static_cast<std::size_t>(*pose)].places);
  else
    view_->setPose(Pose::Identity(), nullptr);
  refreshUse();
}

void PoseChooser::refreshUse() {
  const auto pose = current();
  const bool despite = pose && !alignment_->candidates[static_cast<std::size_t>(*pose)].possible;
  use_->setText(despite ? tr("&Use it all the same") : tr("&Use this one"));
  use_->setAccessibleName(QString(use_->text()).remove(QLatin1Char('&')));
  setHelp(*use_, despite ? tr("The stand becomes part of the model although something speaks against this pose. The "
                              "report says so. It can be undone.")
                         : tr("The stand becomes part of the model in this pose. It can be undone."));
  allow(*use_, pose || !whyNot_.isEmpty() ? whyNot_ : tr("No pose was found yet."));
}

}  // namespace vantage
