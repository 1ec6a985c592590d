#include "acquisition/may_do.h"

#include <algorithm>
#include <array>

#include "acquisition/next_scan.h"

namespace vantage {
namespace {

using Answer = std::optional<Refusal>;

Answer refuse(RefusalReason reason, std::optional<std::int64_t> number = {}) {
  return Refusal{reason, number};
}

Answer positionAnswer(const AcquisitionState& state, int position) {
  if (!state.profile) return refuse(RefusalReason::NoProfile);
  const bool exists = position >= 0 && position < static_cast<int>(state.profile->workspace.size());
  return exists ? Answer() : refuse(RefusalReason::NoSuchPosition, position);
}

Answer openAgain(const AcquisitionState& state) {
  if (state.termination == Termination::Running) return refuse(RefusalReason::NotEnded);
  AcquisitionState open = state;
  open.termination = Termination::Running;
  switch (terminationOf(nextScan(open))) {
    case Termination::Finished:
    case Termination::NoOverlap:
    case Termination::RegistrationFailed:
      return refuse(RefusalReason::NothingLeft);
    case Termination::MaxViews:
      return refuse(RefusalReason::LimitReached, state.settings.maxViews);
    default:
      return {};
  }
}

// Answers for one kind of command each.
class Judge {
 public:
  explicit Judge(const AcquisitionState& state) : state_(state) {}

  Answer operator()(const ChangeSettings& command) const {
    if (!agree(command.settings)) return refuse(RefusalReason::Contradiction);
    if (!state_.scans.empty() && !mayFollow(state_.settings, command.settings))
      return refuse(RefusalReason::MeshesMade);
    return state_.profile ? positionAnswer(state_, command.settings.firstView) : Answer();
  }

  Answer operator()(const AddScan& command) const {
    if (findScan(state_, command.scan) != nullptr) return refuse(RefusalReason::ScanUsed, command.scan);
    return state_.profile ? Answer() : refuse(RefusalReason::NoProfile);
  }

  Answer operator()(const ImportScans& command) const {
    if (!state_.scans.empty()) return refuse(RefusalReason::ScansBefore);
    return command.scans.empty() ? refuse(RefusalReason::NoScans) : Answer();
  }

  Answer operator()(const ChoosePosition& command) const {
    return command.position ? positionAnswer(state_, *command.position) : Answer();
  }

  Answer operator()(const LeaveOutView& command) const {
    const KeptScan* scan = findScan(state_, command.scan);
    if (scan == nullptr || scan->status != ScanStatus::In) return refuse(RefusalReason::NotAView, command.scan);
    return countScans(state_, ScanStatus::In) == 1 ? refuse(RefusalReason::OnlyView, command.scan) : Answer();
  }

  Answer operator()(const TakeBackView& command) const {
    const KeptScan* scan = findScan(state_, command.scan);
    const bool out = scan != nullptr && scan->status == ScanStatus::LeftOut;
    return out ? Answer() : refuse(RefusalReason::NotLeftOut, command.scan);
  }

  Answer operator()(const Finish& command) const {
    if (command.termination == Termination::Running) return openAgain(state_);
    return state_.termination == Termination::Running ? Answer() : refuse(RefusalReason::AlreadyEnded);
  }

  Answer operator()(const TakeOver& /*command*/) const { return refuse(RefusalReason::NotReplayable); }

  Answer operator()(const TurnObject& /*command*/) const {
    if (!state_.profile) return refuse(RefusalReason::NoProfile);
    return state_.model ? Answer() : refuse(RefusalReason::NothingScanned);
  }

  Answer operator()(const PlaceStand& command) const {
    if (command.stand < 0 || command.stand > state_.stand()) return refuse(RefusalReason::NoSuchStand, command.stand);
    const bool known = state_.stands[static_cast<std::size_t>(command.stand)].T_object_table.has_value();
    return known ? refuse(RefusalReason::StandKnown, command.stand) : Answer();
  }

  Answer operator()(const ChangeMode& /*command*/) const {
    return state_.profile ? Answer() : refuse(RefusalReason::NoProfile);
  }

 private:
  const AcquisitionState& state_;
};

}  // namespace

std::string_view name(RefusalReason reason) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastRefusalReason) + 1> kNames{
      "no_profile",      "no_such_position", "no_such_stand",        "stand_known",  "not_a_view",    "only_view",
      "not_left_out",    "scan_used",        "scans_before",         "no_scans",     "already_ended", "not_ended",
      "nothing_left",    "limit_reached",    "nothing_scanned",      "meshes_made",  "contradiction", "not_replayable",
      "nothing_to_undo", "nothing_to_redo",  "nothing_to_scan_with", "stand_unknown"};
  return kNames[static_cast<std::size_t>(reason)];
}

std::optional<Refusal> mayDo(const AcquisitionState& state, const Command& command) {
  return std::visit(Judge(state), command);
}

std::optional<Refusal> mayScan(const AcquisitionState& state) {
  if (!state.profile) return refuse(RefusalReason::NoProfile);
  const NextScan next = nextScan(state);
  if (std::holds_alternative<PlaceFirst>(next)) return refuse(RefusalReason::StandUnknown, state.stand());
  switch (terminationOf(next)) {
    case Termination::Running:
      return {};
    case Termination::MaxViews:
      return refuse(RefusalReason::LimitReached, state.settings.maxViews);
    case Termination::EndedByOperator:
    case Termination::Imported:
      return refuse(RefusalReason::AlreadyEnded);
    default:
      return refuse(RefusalReason::NothingLeft);
  }
}

}  // namespace vantage
