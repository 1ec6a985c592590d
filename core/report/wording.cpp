#include "report/wording.h"

#include <algorithm>
#include <string>
#include <utility>

#include "acquisition/other_turn.h"

namespace vantage {
namespace {

Phrase axisPhrase(const Vec3& axis) {
  for (int k = 0; k < 3; ++k)
    if (axis == Vec3::Unit(k)) return asIs(std::string(1, "xyz"[k]));
  return words("(%1, %2, %3)", {figure(axis.x(), 1), figure(axis.y(), 1), figure(axis.z(), 1)});
}

Phrase turnsPhrase(double factor) {
  if (factor < 0.0)
    return words("it fits if the turns go the other way, %1 times as far as listed", {figure(-factor, 2)});
  return words("it fits if every turn is %1 times what the list says", {figure(factor, 2)});
}

// "131.0 degrees", and what is as good.
Phrase anglesPhrase(const Finding& finding) {
  Phrase phrase = words("%1 degrees", {figure(inOneTurn(finding.value.value_or(0.0)), 1)});
  for (const double rival : finding.rivals)
    phrase = words("%1, and as well at %2 degrees", {std::move(phrase), figure(inOneTurn(rival), 1)});
  return phrase;
}

// One overload for each kind of command.
Phrase phraseFor(const ChangeSettings& /*command*/) {
  return words("Set-up changed");
}
Phrase phraseFor(const AddScan& command) {
  return words("Scan %1 added", {asIs(std::to_string(command.scan))});
}
Phrase phraseFor(const ImportScans& command) {
  return words("%1 recorded scans imported", {asIs(std::to_string(command.scans.size()))});
}
Phrase phraseFor(const ChoosePosition& command) {
  return command.position ? words("Position %1 chosen", {asIs(std::to_string(*command.position))})
                          : words("Proposed position taken again");
}
Phrase phraseFor(const LeaveOutView& command) {
  return words("Scan %1 left out", {asIs(std::to_string(command.scan))});
}
Phrase phraseFor(const TakeBackView& command) {
  return words("Scan %1 taken back", {asIs(std::to_string(command.scan))});
}
Phrase phraseFor(const TakeAsFrom& command) {
  return words("Scan %1 taken as from %2 degrees", {asIs(std::to_string(command.scan)), figure(command.tableDeg, 1)});
}
Phrase phraseFor(const Finish& command) {
  return command.termination == Termination::Running
             ? words("Opened again")
             : words("Ended: %1", {asIs(std::string(name(command.termination)))});
}
Phrase phraseFor(const TakeOver& /*command*/) {
  return words("Taken over from an earlier version");
}
Phrase phraseFor(const TurnObject& /*command*/) {
  return words("Object turned over");
}
Phrase phraseFor(const PlaceStand& command) {
  return words("Stand %1 placed", {asIs(std::to_string(command.stand))});
}
Phrase phraseFor(const AlignStand& command) {
  return words("Alignment of stand %1", {asIs(std::to_string(command.stand))});
}
Phrase phraseFor(const ChooseStandPose& command) {
  return words("Pose %1 chosen for stand %2",
               {asIs(std::to_string(command.pose)), asIs(std::to_string(command.stand))});
}
Phrase phraseFor(const TakeReference& command) {
  return words("Object known by stand %1", {asIs(std::to_string(command.stand))});
}
Phrase phraseFor(const EraseRegion& command) {
  if (std::holds_alternative<BelowPlane>(command.region)) return words("Erased below a plane");
  if (std::holds_alternative<OrientedBox>(command.region)) return words("Erased in a box");
  if (std::holds_alternative<Prism>(command.region)) return words("Erased in a lasso");
  return words("Erased pieces");
}
Phrase phraseFor(const TakeBackErasure& command) {
  return words("Erasure %1 taken back", {asIs(std::to_string(command.number))});
}
Phrase phraseFor(const ChangeMode& command) {
  return command.mode == Mode::Automatic ? words("Automatic from here") : words("Assisted from here");
}

}  // namespace

Phrase phraseOf(const WeakMotion& motion) {
  switch (motion.kind) {
    case WeakMotion::Kind::Slide:
      return words("slides along %1", {axisPhrase(motion.axis)});
    case WeakMotion::Kind::Turn:
      return words("turns about %1", {axisPhrase(motion.axis)});
    case WeakMotion::Kind::Free:
      break;
  }
  return words("moves freely");
}

Phrase phraseOf(const WeakMotions& motions) {
  if (motions.empty()) return words("");
  Phrase phrase = phraseOf(motions.front());
  for (std::size_t i = 1; i < motions.size(); ++i)
    phrase = words("%1 and %2", {std::move(phrase), phraseOf(motions[i])});
  return phrase;
}

Phrase phraseOf(const Finding& finding) {
  const double value = finding.value.value_or(0.0);
  switch (finding.reason) {
    case VerdictReason::NotRegistered:
      return words("not registered");
    case VerdictReason::FirstView:
      return words("the first view defines the frame");
    case VerdictReason::FirstImported:
      return words("the first view is where the others go");
    case VerdictReason::EarlierVersion:
      return words("registered by an earlier version");
    case VerdictReason::Inliers:
      return words("%1 % of the expected overlap fits", {figure(100.0 * value)});
    case VerdictReason::FewInliers:
      return words("only %1 % of the expected overlap fits", {figure(100.0 * value)});
    case VerdictReason::FewPairs:
      return words("only %1 points overlap with the model", {figure(value)});
    case VerdictReason::Conflicts:
      return words("the scanner looked through %1 % of the model's surface", {figure(100.0 * value)});
    case VerdictReason::Residual:
      return words("the surfaces differ %1 times as much as their noise explains", {figure(value, 1)});
    case VerdictReason::Motion:
      return words("it moved %1 sigma away from where the mechanics put it", {figure(value, 1)});
    case VerdictReason::Rival:
      return words("a pose %1 mm away fits as well", {figure(value, 1)});
    case VerdictReason::HeldByMechanics:
      return words("the surface %1: that part of the pose is the mechanics' word alone", {phraseOf(finding.motions)});
    case VerdictReason::NotSettled:
      return words("the pose had not come to rest when the iterations ran out");
    case VerdictReason::ContradictsOthers:
      return words("it contradicts what the other scans agree on, with %1 % of its points there",
                   {figure(100.0 * value)});
    case VerdictReason::NoPoseGiven:
      return words("no pose was given for it, and its surface alone does not say where it belongs");
    case VerdictReason::OtherPosition:
      return words("it does not fit the position that it was said to be of; it fits position %1", {figure(value)});
    case VerdictReason::TableSlipped:
      return words("it fits %1 degrees away from where the table says it is: did the table slip, or was it pushed?",
                   {figure(std::abs(value), 1)});
    case VerdictReason::OtherTurn:
      return words("it does not fit where it was said to be taken; it fits where the table stands at %1",
                   {anglesPhrase(finding)});
    case VerdictReason::TakenElsewhere:
      return words("it was taken as from %1 degrees of the table, where it fits", {figure(inOneTurn(value), 1)});
    case VerdictReason::OtherTurns:
      return turnsPhrase(value);
    case VerdictReason::InverseList:
      return words("it fits if the list has the inverse of every pose");
    case VerdictReason::OtherUnit:
      return words("it fits if positions in the list are taken times %1: another unit",
                   {figure(value, value < 1.0 ? 4 : 1)});
    case VerdictReason::OtherFrame:
      return words("it fits if the scanner's other axes than %1 point the other way",
                   {asIs(std::string(1, "xyz"[std::clamp(static_cast<int>(value), 1, 3) - 1]))});
    case VerdictReason::AxisBeside:
      return words("it fits if the axis is %1 mm beside where the list has it", {figure(value, 1)});
    case VerdictReason::TableAlone:
      return words("only %1 points overlap with the model: the table alone says where it belongs", {figure(value)});
    case VerdictReason::HeldByAll:
      return words("all scans together hold it");
    case VerdictReason::OnDoubtful:
      return words("it fits only scans whose own place is doubtful");
    case VerdictReason::HeldByFew:
      return words("too little holds it to the scans that hold each other");
    case VerdictReason::TableInDoubt:
      return words("the table alone says where it belongs, and the scan before it fits another turn of the table");
  }
  return words("");
}

Phrase phraseOf(const StandAlignment& alignment) {
  const double value = alignment.value.value_or(0.0);
  switch (alignment.reason) {
    case AlignmentReason::OnePose:
      return words("one pose is possible, with %1 % of the surface in common", {figure(100.0 * value)});
    case AlignmentReason::Slides:
      return words("the surfaces slide along each other");
    case AlignmentReason::SeveralPoses:
      return alignment.sameSurface ? words("%1 poses are possible, and all leave the same surface", {figure(value)})
                                   : words("%1 poses are possible", {figure(value)});
    case AlignmentReason::Contradiction:
      return words("%1 % of the surface cannot be there in the best pose, or should have been seen and was not",
                   {figure(100.0 * value, 1)});
    case AlignmentReason::TooLittleOverlap:
      return words("only %1 % of the surface is in common", {figure(100.0 * value)});
    case AlignmentReason::BentComposite:
      return words("it does not fit in one piece: views moved %1 sigma away from where the mechanics put them",
                   {figure(value, 1)});
    case AlignmentReason::OtherObject:
      return words("no pose fits");
  }
  return words("");
}

Phrase phraseOf(const Command& command) {
  return std::visit([](const auto& c) { return phraseFor(c); }, command);
}

std::string thinningText(int everyNth) {
  if (everyNth <= 1) return "every row and column";
  const int last = everyNth % 100 / 10 == 1 ? 0 : everyNth % 10;
  const char* ending = last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th";
  return "every " + std::to_string(everyNth) + ending + " row and column";
}

std::string_view sentenceOf(Termination termination) {
  switch (termination) {
    case Termination::Running:
      return "The acquisition goes on.";
    case Termination::Finished:
      return "Finished: no position would show more than the termination threshold.";
    case Termination::NoOverlap:
      return "Ended: void is left, but no position that shows it overlaps the model enough.";
    case Termination::MaxViews:
      return "Ended: the greatest number of views was taken.";
    case Termination::RegistrationFailed:
      return "Ended: scans could not be registered with the model.";
    case Termination::Cancelled:
      return "The run was stopped; it can be resumed.";
    case Termination::EndedByOperator:
      return "Ended by the operator.";
    case Termination::Imported:
      return "Recorded scans, put together; nothing was planned.";
  }
  return {};
}

std::string_view sentenceOf(EdgeReason reason, PlanOutcome outcome) {
  switch (reason) {
    case EdgeReason::OutOfReach:
      return "No ranging ray of any position reaches it.";
    case EdgeReason::TooSteep:
      return "Every ray that reaches it meets it more steeply than the breakdown angle.";
    case EdgeReason::LightBlocked:
      return "The object itself blocks the light from every position.";
    case EdgeReason::ReceiverBlocked:
      return "Light reaches it, but the object hides it from every receiver.";
    case EdgeReason::BelowThreshold:
      return outcome == PlanOutcome::Found ? "Not scanned yet: a view would still have shown more."
                                           : "It could be seen, but one view would add less than the threshold.";
    case EdgeReason::Answered:
      return "Views looked at it and found no surface there.";
    case EdgeReason::Erased:
      return "What lies beyond it was erased by the operator: it is not the object.";
  }
  return {};
}

std::string_view titleOf(Phase phase) {
  switch (phase) {
    case Phase::Scan:
      return "Scan";
    case Phase::Register:
      return "Register";
    case Phase::Integrate:
      return "Integrate";
    case Phase::VoidPatches:
      return "Void patches";
    case Phase::ProjectVoid:
      return "Form P_v";
    case Phase::ProjectSeen:
      return "Form P_s";
    case Phase::Choose:
      return "Choose";
  }
  return {};
}

}  // namespace vantage
