#include "wording.h"

#include <QCoreApplication>

#include "why_card.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Wording)
};

QString axisText(const Vec3& axis) {
  for (int k = 0; k < 3; ++k)
    if (axis == Vec3::Unit(k)) return QString(QLatin1Char("xyz"[k]));
  return QStringLiteral("(%1, %2, %3)").arg(figureText(axis.x(), 1), figureText(axis.y(), 1), figureText(axis.z(), 1));
}

QString weakMotionText(const WeakMotion& motion) {
  switch (motion.kind) {
    case WeakMotion::Kind::Slide:
      return Text::tr("slides along %1").arg(axisText(motion.axis));
    case WeakMotion::Kind::Turn:
      return Text::tr("turns about %1").arg(axisText(motion.axis));
    case WeakMotion::Kind::Free:
      break;
  }
  return Text::tr("moves freely");
}

QString textOf(const ChangeSettings& /*command*/) {
  return Text::tr("Set-up changed");
}
QString textOf(const AddScan& command) {
  return Text::tr("Scan %1 added").arg(command.scan);
}
QString textOf(const ImportScans& command) {
  return Text::tr("%1 recorded scans imported").arg(command.scans.size());
}
QString textOf(const ChoosePosition& command) {
  return command.position ? Text::tr("Position %1 chosen").arg(*command.position)
                          : Text::tr("Proposed position taken again");
}
QString textOf(const LeaveOutView& command) {
  return Text::tr("Scan %1 left out").arg(command.scan);
}
QString textOf(const TakeBackView& command) {
  return Text::tr("Scan %1 taken back").arg(command.scan);
}
QString textOf(const Finish& command) {
  return command.termination == Termination::Running ? Text::tr("Opened again") : terminationText(command.termination);
}
QString textOf(const TakeOver& /*command*/) {
  return Text::tr("Taken over from an earlier version");
}
QString textOf(const TurnObject& /*command*/) {
  return Text::tr("Object turned over");
}
QString textOf(const PlaceStand& command) {
  return Text::tr("Stand %1 placed").arg(command.stand);
}
QString textOf(const ChangeMode& command) {
  return command.mode == Mode::Automatic ? Text::tr("Automatic from here") : Text::tr("Assisted from here");
}

}  // namespace

QString weakMotionsText(const WeakMotions& motions) {
  QString text;
  for (const WeakMotion& motion : motions)
    text = text.isEmpty() ? weakMotionText(motion) : Text::tr("%1 and %2").arg(text, weakMotionText(motion));
  return text;
}

QString findingText(const Finding& finding) {
  const double value = finding.value.value_or(0.0);
  switch (finding.reason) {
    case VerdictReason::NotRegistered:
      return Text::tr("not registered");
    case VerdictReason::FirstView:
      return Text::tr("the first view defines the frame");
    case VerdictReason::FirstImported:
      return Text::tr("the first view is where the others go");
    case VerdictReason::EarlierVersion:
      return Text::tr("registered by an earlier version");
    case VerdictReason::Inliers:
      return Text::tr("%1 % of the expected overlap fits").arg(figureText(100.0 * value));
    case VerdictReason::FewInliers:
      return Text::tr("only %1 % of the expected overlap fits").arg(figureText(100.0 * value));
    case VerdictReason::FewPairs:
      return Text::tr("only %1 points overlap with the model").arg(figureText(value));
    case VerdictReason::Conflicts:
      return Text::tr("the scanner looked through %1 % of the model's surface").arg(figureText(100.0 * value));
    case VerdictReason::Residual:
      return Text::tr("the surfaces differ %1 times as much as their noise explains").arg(figureText(value, 1));
    case VerdictReason::Motion:
      return Text::tr("it moved %1 sigma away from where the mechanics put it").arg(figureText(value, 1));
    case VerdictReason::Rival:
      return Text::tr("a pose %1 mm away fits as well").arg(figureText(value, 1));
    case VerdictReason::HeldByMechanics:
      return Text::tr("the surface %1: that part of the pose is the mechanics' word alone")
          .arg(weakMotionsText(finding.motions));
    case VerdictReason::NotSettled:
      return Text::tr("the pose had not come to rest when the iterations ran out");
  }
  return {};
}

QString commandText(const Command& command) {
  return std::visit([](const auto& c) { return textOf(c); }, command);
}

QString terminationText(Termination termination) {
  switch (termination) {
    case Termination::Running:
      return Text::tr("The acquisition is not ended yet.");
    case Termination::Finished:
      return Text::tr("Ended: no position would show more than is worth a scan.");
    case Termination::NoOverlap:
      return Text::tr("Ended: what is left overlaps the model too little from every position.");
    case Termination::MaxViews:
      return Text::tr("Ended: the greatest number of views was taken.");
    case Termination::RegistrationFailed:
      return Text::tr("Ended: scans could not be registered.");
    case Termination::Cancelled:
      return Text::tr("The run was stopped.");
    case Termination::EndedByOperator:
      return Text::tr("Ended by you.");
    case Termination::Imported:
      return Text::tr("Recorded scans, put together. No view was planned, so nothing is known of what is left.");
  }
  return {};
}

QString edgeReasonText(EdgeReason reason, PlanOutcome outcome) {
  switch (reason) {
    case EdgeReason::OutOfReach:
      return Text::tr("No ray reaches it");
    case EdgeReason::TooSteep:
      return Text::tr("Too steep from everywhere");
    case EdgeReason::LightBlocked:
      return Text::tr("Light always blocked");
    case EdgeReason::ReceiverBlocked:
      return Text::tr("Receiver always blocked");
    case EdgeReason::BelowThreshold:
      return outcome == PlanOutcome::Found ? Text::tr("Not scanned yet") : Text::tr("Too little to be worth it");
    case EdgeReason::Answered:
      return Text::tr("Looked at, no surface");
  }
  return {};
}

QString edgeClassText(EdgeClass edgeClass) {
  switch (edgeClass) {
    case EdgeClass::OuterJump:
      return Text::tr("outer jumps");
    case EdgeClass::InnerJump:
      return Text::tr("inner jumps");
    case EdgeClass::LineOfSightJump:
      return Text::tr("line-of-sight jumps");
    case EdgeClass::Regular:
      return Text::tr("regular");
    case EdgeClass::Rim:
      return Text::tr("rim");
  }
  return {};
}

}  // namespace vantage
