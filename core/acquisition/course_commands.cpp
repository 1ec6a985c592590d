#include "acquisition/course_commands.h"

#include <utility>

#include "acquisition/command_tools.h"
#include "acquisition/next_scan.h"

namespace vantage {
namespace {

using Answer = std::optional<Refusal>;

Answer positionAnswer(const AcquisitionState& state, int position) {
  if (!state.profile) return Refusal{RefusalReason::NoProfile, {}};
  const bool exists = position >= 0 && position < static_cast<int>(state.profile->workspace.size());
  return exists ? Answer() : Refusal{RefusalReason::NoSuchPosition, position};
}

Answer openAgain(const AcquisitionState& state) {
  if (state.termination == Termination::Running) return Refusal{RefusalReason::NotEnded, {}};
  AcquisitionState open = state;
  open.termination = Termination::Running;
  switch (terminationOf(nextScan(open))) {
    case Termination::Finished:
    case Termination::NoOverlap:
    case Termination::RegistrationFailed:
      return Refusal{RefusalReason::NothingLeft, {}};
    case Termination::MaxViews:
      return Refusal{RefusalReason::LimitReached, state.settings.maxViews};
    default:
      return {};
  }
}

}  // namespace

Answer ChangeSettings::mayDo(const AcquisitionState& state) const {
  if (!agree(settings)) return Refusal{RefusalReason::Contradiction, {}};
  if (!state.scans.empty() && !mayFollow(state.settings, settings)) return Refusal{RefusalReason::MeshesMade, {}};
  return state.profile ? positionAnswer(state, settings.firstView) : Answer();
}

AcquisitionState ChangeSettings::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  AcquisitionState next = state;
  next.settings = settings;
  return tools.replanned(std::move(next));
}

Answer ChoosePosition::mayDo(const AcquisitionState& state) const {
  return position ? positionAnswer(state, *position) : Answer();
}

AcquisitionState ChoosePosition::carriedOut(const AcquisitionState& state, const CommandTools& /*tools*/) const {
  AcquisitionState next = state;
  next.chosenPosition = position;
  if (position) next.termination = Termination::Running;
  return CommandTools::judged(std::move(next));
}

Answer Finish::mayDo(const AcquisitionState& state) const {
  if (termination == Termination::Running) return openAgain(state);
  return state.termination == Termination::Running ? Answer() : Refusal{RefusalReason::AlreadyEnded, {}};
}

AcquisitionState Finish::carriedOut(const AcquisitionState& state, const CommandTools& /*tools*/) const {
  AcquisitionState next = state;
  next.termination = termination;
  return next;
}

Answer ChangeMode::mayDo(const AcquisitionState& state) const {
  return state.profile ? Answer() : Refusal{RefusalReason::NoProfile, {}};
}

AcquisitionState ChangeMode::carriedOut(const AcquisitionState& state, const CommandTools& /*tools*/) const {
  AcquisitionState next = state;
  next.mode = mode;
  return next;
}

}  // namespace vantage
