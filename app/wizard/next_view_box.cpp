#include "wizard/next_view_box.h"

#include <QHBoxLayout>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>

#include "form_parts.h"
#include "why_card.h"
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
      back_(makeButton(tr("&Proposal"), QStringLiteral("takeProposal"), tr("Go back to the proposed position."))) {
  other_->setObjectName(QStringLiteral("otherPosition"));
  other_->setAccessibleName(tr("Another position"));
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Other:")));
  row->addWidget(other_, 1);
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
  const double tilt = advice->turn.tilt;
  if (std::abs(tilt) > radians(0.05))
    text += tilt > 0 ? tr(" Raise the scanner by %1.").arg(angleText(tilt))
                     : tr(" Lower the scanner by %1.").arg(angleText(-tilt));
  return text;
}

void NextViewBox::refresh() {
  const std::optional<int> next = controller_.nextPosition();
  if (controller_.setUp() && controller_.setUp()->profile)
    other_->setMaximum(static_cast<int>(controller_.setUp()->profile->workspace.size()) - 1);
  const bool chosen = controller_.now() && controller_.now()->chosenPosition;
  const auto why = next ? controller_.explained(*next) : std::nullopt;
  if (!next)
    headline_->setText(tr("No further view is proposed."));
  else if (why)
    headline_->setText((chosen ? tr("Position %1, your choice: shows %2") : tr("Position %1, proposed: shows %2"))
                           .arg(QString::number(*next), areaText(why->promise)));
  else
    headline_->setText(tr("Position %1").arg(*next));
  const auto advice = next ? controller_.turnTo(*next) : std::nullopt;
  dial_->setVisible(assisted_ && advice.has_value());
  instruction_->setVisible(assisted_ && next.has_value());
  if (advice) dial_->show(advice->from, advice->to, advice->turn.angle);
  instruction_->setText(next ? instruction(*next) : QString());
  const QString whyNot = controller_.whyNot(ChoosePosition{other_->value()});
  other_->setEnabled(whyNot.isEmpty());
  allow(*take_, whyNot);
  allow(*back_, chosen ? controller_.whyNot(ChoosePosition{}) : tr("The proposed position is next already."));
  refreshCost();
}

void NextViewBox::refreshCost() {
  const auto plan = controller_.now() ? controller_.now()->plan : nullptr;
  const auto other = controller_.explained(other_->value());
  if (!plan || !other) return cost_->setText(tr("After the first scan every position is compared here."));
  if (!plan->position) return cost_->setText(tr("It would show %1.").arg(areaText(other->promise)));
  if (controller_.nextPosition() == other->position && plan->position != other->position)
    return cost_->setText(tr("The next scan is taken from here."));
  if (plan->position == other->position) return cost_->setText(tr("This is the proposed position."));
  const auto best = controller_.explained(*plan->position);
  const double lost = best->promise - other->promise;
  QString text = lost >= 0 ? tr("Shows %1 less than the proposal").arg(areaText(lost))
                           : tr("Shows %1 more than the proposal").arg(areaText(-lost));
  if (other->constraint == Constraint::OverlapShort)
    text += tr(", and its overlap is %1 short: registration may fail").arg(areaText(other->shortBy));
  if (other->constraint == Constraint::PoseUncertain) text += tr(", and its registration would be uncertain");
  cost_->setText(text + QLatin1Char('.'));
}

}  // namespace vantage
