#include "acquisition/stand_comparison.h"

#include <string>

#include "acquisition/may_do.h"
#include "acquisition/refusal_error.h"
#include "acquisition/stand_composites.h"
#include "acquisition/step_options.h"

namespace vantage {

PosePlaces StandComparison::placesAt(const Pose& T_object_stand, const Progress& progress) const {
  return vantage::placesAt(object, composite, T_object_stand, limits, progress);
}

StandComparison compareStand(const AcquisitionState& state, int stand, const Progress& progress) {
  if (const auto refusal = mayDo(state, AlignStand{stand})) throwRefusal(*refusal);
  const StepOptions options = stepOptionsFor(state);
  CompositeModel object(compositeForAligner(withObject(state), options), progress.part(0.0, 0.5));
  CompositeModel composite(compositeForAligner(withComposite(state, stand), options), progress.part(0.5, 1.0));
  const AlignmentLimits limits = limitsOf(object.scale(), composite.scale());
  return {stand, std::move(object), std::move(composite), limits};
}

}  // namespace vantage
