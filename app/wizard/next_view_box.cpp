#include "wizard/next_view_box.h"

#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>

#include "form_parts.h"
#include "why_card.h"
#include "window/flow_layout.h"
#include "wizard/turn_dial.h"

namespace vantage {

NextViewBox::NextViewBox(SessionController& controller, QWidget* parent)
    : QGroupBox(tr("Next view"), parent),
      controller_(controller),
      headline_(makeLabel({}, "section")),
      dial_(new TurnDial),
      instruction_(makeLabel({})),
      other_(new QSpinBox),
      cost_(makeLabel({}, "muted")),
      take_(makeButton(tr("T&ake it"), QStringLiteral("takeOther"), tr("Scan from this position next."))),
      back_(makeButton(tr("Proposa&l"), QStringLiteral("takeProposal"), tr("Go back to the proposed position."))) {
  other_->setObjectName(QStringLiteral("otherPosition"));
  other_->setAccessibleName(tr("Another position"));
  auto* row = new FlowLayout(6);
  row->addWidget(new QLabel(tr("Other:")));
  row->addWidget(other_);
  row->addWidget(take_);
  row->addWidget(back_);
  auto* column = new QVBoxLayout(this);
  column->addWidget(headline_);
  column->addWidget(dial_);
  column->addWidget(instruction_);
  column->addLayout(row);
  column->addWidget(cost_);
  connect(other_, &QSpinBox::valueChanged, this, [this](int position) {
    refreshCost();
    emit considered(position);
  });
  connect(take_, &QPushButton::clicked, this, [this] { controller_.choosePosition(other_->value()); });
  connect(back_, &QPushButton::clicked, this, [this] { controller_.choosePosition({}); });
  connect(&controller, &SessionController::stateChanged, this, &NextViewBox::refresh);
  connect(&controller, &SessionController::setUpChanged, this, &NextViewBox::refresh);
  connect(&controller, &SessionController::activityChanged, this, &NextViewBox::refresh);
  connect(&controller, &SessionController::shownChanged, this, &NextViewBox::refreshCost);
  setAssisted(false);
}

void NextViewBox::setAssisted(bool assisted) {
  assisted_ = assisted;
  refresh();
}

void NextViewBox::offer(int position) {
  other_->setValue(position);
}

QString NextViewBox::instruction(int position) const {
  const auto advice = controller_.turnTo(position);
  if (!advice) return tr("Put the scanner at position %1.").arg(position);
  const double angle = advice->turn.angle;
  QString text = std::abs(angle) < radians(0.05) ? tr("Leave the table as it stands.")
                 : angle > 0 ? tr("Turn the table %1 counter-clockwise, seen from above.").arg(angleText(angle))
                             : tr("Turn the table %1 clockwise, seen from above.").arg(angleText(-angle));
  // The whole way, so that a turn that was not quite right does not add to the next one.
  const double mark = std::fmod(degrees(advice->to) + 720.0, 360.0);
  text += tr(" Then the scanner looks at the mark %1° of the table.").arg(figureText(mark > 359.95 ? 0.0 : mark, 1));
  const double tilt = advice->turn.tilt;
  if (std::abs(tilt) > radians(0.05))
    text += tilt > 0 ? tr(" Raise the scanner by %1.").arg(angleText(tilt))
                     : tr(" Lower the scanner by %1.").arg(angleText(-tilt));
  return text;
}

// Also of an acquisition that has ended: what would come if it went on.
QString NextViewBox::headline() const {
  const SharedState& now = controller_.now();
  if (now && !now->profile) return tr("Recorded scans have no next view.");
  const std::optional<int> position = controller_.present().furtherPosition();
  if (!position) return tr("No further view is proposed.");
  const auto why = controller_.present().explained(*position);
  if (!why) return tr("Position %1").arg(*position);
  const QString text = !controller_.present().nextPosition() ? tr("If you go on: position %1 shows %2")
                       : now->chosenPosition                 ? tr("Position %1, your choice: shows %2")
                                                             : tr("Position %1, proposed: shows %2");
  return text.arg(QString::number(*position), areaText(why->promise));
}

void NextViewBox::refresh() {
  const std::optional<int> next = controller_.present().furtherPosition();
  if (controller_.setUp() && controller_.setUp()->profile)
    other_->setMaximum(static_cast<int>(controller_.setUp()->profile->workspace.size()) - 1);
  headline_->setText(headline());
  const auto advice = next ? controller_.turnTo(*next) : std::nullopt;
  dial_->setVisible(assisted_ && advice.has_value());
  instruction_->setVisible(assisted_ && next.has_value());
  if (advice) dial_->show(advice->from, advice->to, advice->turn.angle);
  instruction_->setText(next ? instruction(*next) : QString());
  const QString whyNot = controller_.permissions().whyNot(ChoosePosition{other_->value()});
  allow(*other_, whyNot);
  allow(*take_, whyNot);
  const bool chosen = controller_.now() && controller_.now()->chosenPosition;
  allow(*back_, chosen ? controller_.permissions().whyNot(ChoosePosition{}) : tr("No other position was taken."));
  refreshCost();
}

void NextViewBox::refreshCost() {
  cost_->setText(cost(other_->value()));
}

// What another position than the proposed one costs.
QString NextViewBox::cost(int position) const {
  const SharedState& now = controller_.now();
  if (now && !now->profile) return controller_.permissions().whyNot(ChoosePosition{position});
  if (!controller_.showsNow())
    return tr("An earlier moment is shown; a choice holds for now.") + QLatin1Char('\n') + costNow(position);
  return costNow(position);
}

QString NextViewBox::costNow(int position) const {
  const SharedState& now = controller_.now();
  const auto other = controller_.present().explained(position);
  if (!other) return tr("After the first scan every position is compared here.");
  const std::optional<int> proposed = controller_.present().proposedPosition();
  const QString taken = now->chosenPosition == position ? tr("The next scan is taken from here. ") : QString();
  if (!proposed) return taken + tr("It would show %1.").arg(areaText(other->promise));
  if (*proposed == position) return taken + tr("This is the proposed position.");
  const double lost = controller_.present().explained(*proposed)->promise - other->promise;
  QString text = lost >= 0 ? tr("Shows %1 less than the proposal").arg(areaText(lost))
                           : tr("Shows %1 more than the proposal").arg(areaText(-lost));
  if (other->constraint == Constraint::OverlapShort)
    text += tr(", and its overlap is %1 short: registration may fail").arg(areaText(other->shortBy));
  if (other->constraint == Constraint::BelowThreshold && other->overlapArea <= other->leastOverlap)
    text += tr(", and it overlaps the model too little: registration would fail");
  if (other->constraint == Constraint::PoseUncertain) text += tr(", and its registration would be uncertain");
  return taken + text + QLatin1Char('.');
}

}  // namespace vantage
