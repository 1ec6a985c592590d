#include "erase/erase_bar.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include "form_parts.h"
#include "help/help_topic.h"
#include "views/region_drawing.h"
#include "why_card.h"
#include "window/flow_layout.h"

namespace vantage {
namespace {

QDoubleSpinBox* makeNumber(const QString& name, const QString& unit, double most, double value, double step) {
  auto* box = new QDoubleSpinBox;
  box->setRange(0.0, most);
  box->setDecimals(1);
  box->setSingleStep(step);
  box->setValue(value);
  box->setSuffix(unit);
  box->setToolTip(name);
  box->setAccessibleName(name);
  return box;
}

}  // namespace

EraseBar::EraseBar(EraseDesk& desk, ModelView& view, QWidget* pane)
    : QWidget(pane),
      desk_(desk),
      drawing_(new RegionDrawing(view)),
      height_(makeNumber(tr("How far above the table"), tr(" mm"), 1000.0, 5.0, 0.5)),
      largest_(makeNumber(tr("How large a piece may be"), tr(" mm²"), 1e6, 100.0, 50.0)),
      front_(new QCheckBox(tr("Only the near side"))),
      said_(makeLabel({}, "muted")),
      escape_(new QShortcut(QKeySequence(Qt::Key_Escape), pane)) {
  setObjectName(QStringLiteral("eraseBar"));
  setHelpTopic(*this, QStringLiteral("erase"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->setSpacing(4);
  auto* row = new FlowLayout(6);
  const std::pair<QString, QString> tools[kEraseTools] = {
      {tr("Lasso"), tr("Draw around it, in any shape")},
      {tr("Box"), tr("Draw a rectangle around it")},
      {tr("Below a plane"), tr("All that lies lower than a height above the table")},
      {tr("Loose pieces"), tr("Pieces that hang together with nothing else; the largest one stays")}};
  const char* const names[kEraseTools] = {"eraseLasso", "eraseBox", "eraseBelow", "eraseLoosePieces"};
  for (int i = 0; i < kEraseTools; ++i) {
    auto* button = new QToolButton;
    button->setText(tools[i].first);
    button->setToolTip(tools[i].second);
    button->setAccessibleDescription(tools[i].second);
    button->setObjectName(QLatin1String(names[i]));
    button->setCheckable(true);
    button->setAutoExclusive(true);
    button->setProperty("layer", true);
    connect(button, &QToolButton::clicked, this, [this, i] { begin(static_cast<EraseTool>(i)); });
    tools_ << button;
    row->addWidget(button);
  }
  height_->setObjectName(QStringLiteral("eraseHeight"));
  largest_->setObjectName(QStringLiteral("eraseLargest"));
  front_->setObjectName(QStringLiteral("eraseFront"));
  front_->setToolTip(tr("What lies behind it, after a gap, stays"));
  front_->setChecked(true);
  said_->setObjectName(QStringLiteral("erasePreview"));
  erase_ = makeButton(tr("Erase"), QStringLiteral("eraseNow"), tr("Erase what is marked; Undo takes it back"), true);
  end_ = makeButton(tr("Done (Esc)"), QStringLiteral("eraseEnd"), tr("Erase nothing more"));
  for (QWidget* part : {static_cast<QWidget*>(height_), static_cast<QWidget*>(largest_), static_cast<QWidget*>(front_),
                        static_cast<QWidget*>(erase_), static_cast<QWidget*>(end_)})
    row->addWidget(part);
  column->addLayout(row);
  column->addWidget(said_);
  connect(height_, &QDoubleSpinBox::valueChanged, this, &EraseBar::ask);
  connect(largest_, &QDoubleSpinBox::valueChanged, this, &EraseBar::ask);
  connect(front_, &QCheckBox::toggled, this, &EraseBar::ask);
  connect(drawing_, &RegionDrawing::closed, this, &EraseBar::ask);
  connect(drawing_, &RegionDrawing::cancelled, this, &EraseBar::end);
  // The line no longer lies over what it was drawn around; what it covers stays marked.
  connect(&view, &SceneView::cameraChanged, drawing_, &RegionDrawing::clear);
  connect(erase_, &QPushButton::clicked, &desk, &EraseDesk::erase);
  connect(end_, &QPushButton::clicked, this, &EraseBar::end);
  connect(&desk, &EraseDesk::changed, this, &EraseBar::refresh);
  connect(&desk, &EraseDesk::modelChanged, this, [this] {
    drawing_->clear();
    ask();
  });
  // Also while the view below has the keyboard.
  escape_->setContext(Qt::WidgetWithChildrenShortcut);
  escape_->setEnabled(false);
  connect(escape_, &QShortcut::activated, this, &EraseBar::end);
  hide();
}

void EraseBar::begin(EraseTool tool) {
  tool_ = tool;
  tools_[static_cast<int>(tool)]->setChecked(true);
  desk_.forget();
  height_->setVisible(tool == EraseTool::Below);
  largest_->setVisible(tool == EraseTool::LoosePieces);
  const bool draws = tool == EraseTool::Lasso || tool == EraseTool::Box;
  front_->setVisible(draws);
  show();
  escape_->setEnabled(true);
  if (draws) {
    drawing_->begin(tool == EraseTool::Lasso ? DrawnShape::Lasso : DrawnShape::Rectangle);
  } else {
    drawing_->end();
    (tool == EraseTool::Below ? height_ : largest_)->setFocus(Qt::OtherFocusReason);
    ask();
  }
  refresh();
}

void EraseBar::end() {
  if (!isVisible()) return;
  drawing_->end();
  desk_.forget();
  escape_->setEnabled(false);
  hide();
}

void EraseBar::ask() {
  if (!isVisible()) return;
  if (tool_ == EraseTool::Below) return desk_.askBelow(height_->value());
  if (tool_ == EraseTool::LoosePieces) return desk_.askLoosePieces(largest_->value());
  if (!drawing_->drawn().isEmpty()) desk_.askDrawn(drawing_->drawn(), front_->isChecked());
}

QString EraseBar::howTo() const {
  switch (tool_) {
    case EraseTool::Lasso:
      return tr(
          "Draw around what is not the object with the left button held. By keys: arrows, space for a corner, "
          "Enter.");
    case EraseTool::Box:
      return tr(
          "Draw a rectangle around what is not the object with the left button held. By keys: arrows, space, "
          "arrows, Enter.");
    case EraseTool::Below:
    case EraseTool::LoosePieces:
      break;
  }
  return {};
}

QString EraseBar::answer() const {
  if (const QString why = desk_.whyNot(); !why.isEmpty()) return why;
  if (desk_.asking()) return tr("Looking for it…");
  if (!desk_.failure().isEmpty()) return desk_.failure();
  if (!desk_.preview()) return howTo();
  const ErasePreview& preview = *desk_.preview();
  if (preview.samples == 0)
    return tool_ == EraseTool::LoosePieces ? tr("The model has no loose piece of that size.")
                                           : tr("Nothing of the model lies there.");
  const QString area = areaText(preview.area);
  return preview.pieces == 1 ? tr("The marked piece would go, %1.").arg(area)
                             : tr("The %1 marked pieces would go, %2 together.").arg(preview.pieces).arg(area);
}

void EraseBar::refresh() {
  if (!isVisible()) return;
  const QString text = answer();
  said_->setText(text);
  said_->setVisible(!text.isEmpty());
  const bool goes = desk_.preview() && desk_.preview()->samples > 0;
  const QString why = desk_.whyNot();
  allow(*erase_, !why.isEmpty() ? why : goes ? QString() : tr("Nothing is marked that could be erased."));
}

}  // namespace vantage
