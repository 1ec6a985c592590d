#include "acquisition/erase_commands.h"

#include <algorithm>
#include <utility>

#include "acquisition/command_tools.h"
#include "acquisition/erased_regions.h"
#include "acquisition/stand_composites.h"
#include "acquisition/step_options.h"
#include "acquisition/steps.h"
#include "base/errors.h"

namespace vantage {
namespace {

bool isErasedIn(const Stand& stand, int number) {
  return std::any_of(stand.erased.begin(), stand.erased.end(),
                     [&](const ErasedRegion& erased) { return erased.number == number; });
}

}  // namespace

std::optional<Refusal> EraseRegion::mayDo(const AcquisitionState& state) const {
  if (stand < 0 || stand > state.stand()) return Refusal{RefusalReason::NoSuchStand, stand};
  if (!state.model) return Refusal{RefusalReason::NothingScanned, {}};
  const bool inWork = compositeOf(state, stand) == compositeInWork(state);
  return inWork ? std::nullopt : std::optional(Refusal{RefusalReason::StandNotInWork, stand});
}

AcquisitionState EraseRegion::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  const ErasedSpace space = spaceOf(state, {stand, region, alone});
  AcquisitionState next = state;
  const int number = nextErasure(state.stands);
  for (const ErasedSpace::Placed& placed : space.regions())
    next.stands[static_cast<std::size_t>(placed.stand)].erased.push_back({number, placed.region});
  const Progress progress = tools.firstHalf();
  next.model = std::make_shared<const Model>(withoutErased(*state.model, viewsOf(state), space, progress));
  if (next.model->mesh.triangles.empty())
    throw InvalidInput("the whole model lies in what is to be erased, so nothing of the object would be left");
  return tools.replanned(std::move(next));
}

std::optional<Refusal> TakeBackErasure::mayDo(const AcquisitionState& state) const {
  bool isThere = false;
  for (int stand = 0; stand <= state.stand(); ++stand) {
    if (!isErasedIn(state.stands[static_cast<std::size_t>(stand)], number)) continue;
    isThere = true;
    if (compositeOf(state, stand) != compositeInWork(state)) return Refusal{RefusalReason::StandNotInWork, stand};
  }
  return isThere ? std::nullopt : std::optional(Refusal{RefusalReason::NotErased, number});
}

AcquisitionState TakeBackErasure::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  AcquisitionState next = state;
  for (Stand& stand : next.stands)
    std::erase_if(stand.erased, [&](const ErasedRegion& erased) { return erased.number == number; });
  next.model = integrateViews(viewsOf(next), next.stands, stepOptionsFor(next), tools.firstHalf());
  return tools.replanned(std::move(next));
}

}  // namespace vantage
