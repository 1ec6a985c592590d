#include "acquisition/command_tools.h"

#include <utility>

#include "acquisition/next_scan.h"
#include "acquisition/stand_composites.h"
#include "acquisition/step_options.h"
#include "acquisition/steps.h"

namespace vantage {

AcquisitionState CommandTools::planned(AcquisitionState next, const Progress& progress) const {
  next.plan = nullptr;
  const bool needed = next.settings.strategy.kind == Strategy::Kind::PositionalSpace;
  const bool possible = input_.images != nullptr && next.profile && next.model &&
                        compositeInWork(next) == compositeOf(next, next.stand());
  if (needed && possible)
    next.plan = std::make_shared<const Plan>(planAfter(next, *input_.images, stepOptionsFor(next), progress));
  return next;
}

AcquisitionState CommandTools::judged(AcquisitionState next) {
  if (next.profile) next.termination = terminationOf(nextScan(next));
  return next;
}

AcquisitionState CommandTools::replanned(AcquisitionState next) const {
  return judged(planned(std::move(next), progress_.part(0.5, 1.0)));
}

}  // namespace vantage
