#include "acquisition/stand_commands.h"

#include <utility>

#include "acquisition/command_tools.h"
#include "acquisition/step_options.h"
#include "acquisition/steps.h"

namespace vantage {

std::optional<Refusal> TurnObject::mayDo(const AcquisitionState& state) const {
  if (!state.profile) return Refusal{RefusalReason::NoProfile, {}};
  if (!state.model) return Refusal{RefusalReason::NothingScanned, {}};
  return {};
}

AcquisitionState TurnObject::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  AcquisitionState next = state;
  next.stands.push_back({T_object_table});
  next.chosenPosition.reset();
  next.termination = Termination::Running;
  return tools.replanned(std::move(next));
}

std::optional<Refusal> PlaceStand::mayDo(const AcquisitionState& state) const {
  if (stand < 0 || stand > state.stand()) return Refusal{RefusalReason::NoSuchStand, stand};
  if (state.stands[static_cast<std::size_t>(stand)].T_object_table) return Refusal{RefusalReason::StandKnown, stand};
  return {};
}

AcquisitionState PlaceStand::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  return tools.replanned(placeStand(state, stand, T_object_table, stepOptionsFor(state), tools.firstHalf()));
}

}  // namespace vantage
