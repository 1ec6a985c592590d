#include "wizard/other_turn_box.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "acquisition/other_turn.h"
#include "form_parts.h"
#include "look/figures.h"
#include "session_controller.h"

namespace vantage {

OtherTurnBox::OtherTurnBox(SessionController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller), what_(makeLabel({})) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(what_);
  connect(&controller, &SessionController::stateChanged, this, &OtherTurnBox::refresh);
  connect(&controller, &SessionController::activityChanged, this, &OtherTurnBox::refresh);
  refresh();
}

void OtherTurnBox::refresh() {
  const SharedState& now = controller_.now();
  const bool refused = now && !now->scans.empty() && now->scans.back().status == ScanStatus::Rejected;
  if (refused)
    offer(now->scans.back().number, turnsThatFit(*now, now->scans.back()));
  else
    offer({}, {});
  for (std::size_t i = 0; i < turns_.size(); ++i)
    allow(*buttons_[i], controller_.permissions().whyNot(TakeAsFrom{*scan_, turns_[i]}));
  setVisible(!buttons_.empty() && controller_.idle());
}

// Buttons stay as long as they offer the same: nothing vanishes under somebody's mouse.
void OtherTurnBox::offer(std::optional<std::int64_t> scan, const std::vector<double>& turns) {
  if (scan == scan_ && turns == turns_) return;
  scan_ = scan;
  turns_ = turns;
  for (QPushButton* button : buttons_) {
    button->hide();
    button->deleteLater();
  }
  buttons_.clear();
  if (!scan) return;
  what_->setText(tr("Scan %1 fits another turn of the table than was said. If the table stood there:").arg(*scan));
  for (const double turn : turns) {
    const QString angle = figureText(turn, 1) + QStringLiteral("°");
    auto* button = makeButton(tr("It was taken at %1").arg(angle), QStringLiteral("takeAsFrom"),
                              tr("Take the scan as one with the table at %1, counter-clockwise from its first "
                                 "position, seen from above: there it fits.")
                                  .arg(angle));
    connect(button, &QPushButton::clicked, this, [this, scan = *scan, turn] { controller_.takeAsFrom(scan, turn); });
    layout()->addWidget(button);
    button->show();
    buttons_.push_back(button);
  }
}

}  // namespace vantage
