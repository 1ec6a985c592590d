#include "report/wording.h"

#include <array>
#include <cstdio>

namespace vantage {
namespace {

std::string rounded(double value, int decimals) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string axisText(const Vec3& axis) {
  for (int k = 0; k < 3; ++k)
    if (axis == Vec3::Unit(k)) return std::string(1, "xyz"[k]);
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%.1f, %.1f, %.1f)", axis.x(), axis.y(), axis.z());
  return text.data();
}

std::string described(const ChangeSettings& /*command*/) {
  return "Set-up changed";
}
std::string described(const AddScan& command) {
  return "Scan " + std::to_string(command.scan) + " added";
}
std::string described(const ImportScans& command) {
  return std::to_string(command.scans.size()) + " recorded scans imported";
}
std::string described(const ChoosePosition& command) {
  return command.position ? "Position " + std::to_string(*command.position) + " chosen"
                          : "Proposed position taken again";
}
std::string described(const LeaveOutView& command) {
  return "Scan " + std::to_string(command.scan) + " left out";
}
std::string described(const TakeBackView& command) {
  return "Scan " + std::to_string(command.scan) + " taken back";
}
std::string described(const Finish& command) {
  return command.termination == Termination::Running ? "Opened again"
                                                     : "Ended: " + std::string(name(command.termination));
}
std::string described(const TakeOver& /*command*/) {
  return "Taken over from an earlier version";
}
std::string described(const TurnObject& /*command*/) {
  return "Object turned over";
}
std::string described(const PlaceStand& command) {
  return "Stand " + std::to_string(command.stand) + " placed";
}
std::string described(const ChangeMode& command) {
  return command.mode == Mode::Automatic ? "Automatic from here" : "Assisted from here";
}

}  // namespace

std::string describe(const WeakMotion& motion) {
  switch (motion.kind) {
    case WeakMotion::Kind::Slide:
      return "slides along " + axisText(motion.axis);
    case WeakMotion::Kind::Turn:
      return "turns about " + axisText(motion.axis);
    case WeakMotion::Kind::Free:
      break;
  }
  return "moves freely";
}

std::string describe(const WeakMotions& motions) {
  std::string text;
  for (const WeakMotion& motion : motions) text += (text.empty() ? "" : " and ") + describe(motion);
  return text;
}

std::string describe(const Finding& finding) {
  const double value = finding.value.value_or(0.0);
  switch (finding.reason) {
    case VerdictReason::NotRegistered:
      return "not registered";
    case VerdictReason::FirstView:
      return "the first view defines the frame";
    case VerdictReason::FirstImported:
      return "the first view is where the others go";
    case VerdictReason::EarlierVersion:
      return "registered by an earlier version";
    case VerdictReason::Inliers:
      return rounded(100.0 * value, 0) + " % of the expected overlap fits";
    case VerdictReason::FewInliers:
      return "only " + rounded(100.0 * value, 0) + " % of the expected overlap fits";
    case VerdictReason::FewPairs:
      return "only " + rounded(value, 0) + " points overlap with the model";
    case VerdictReason::Conflicts:
      return "the scanner looked through " + rounded(100.0 * value, 0) + " % of the model's surface";
    case VerdictReason::Residual:
      return "the surfaces differ " + rounded(value, 1) + " times as much as their noise explains";
    case VerdictReason::Motion:
      return "it moved " + rounded(value, 1) + " sigma away from where the mechanics put it";
    case VerdictReason::Rival:
      return "a pose " + rounded(value, 1) + " mm away fits as well";
    case VerdictReason::HeldByMechanics:
      return "the surface " + describe(finding.motions) + ": that part of the pose is the mechanics' word alone";
    case VerdictReason::NotSettled:
      return "the pose had not come to rest when the iterations ran out";
  }
  return {};
}

std::string describe(const Command& command) {
  return std::visit([](const auto& c) { return described(c); }, command);
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
