#include "layers/view_snapshot.h"

namespace vantage {

SharedSnapshot makeSnapshot(std::shared_ptr<const AcquisitionState> state,
                            std::shared_ptr<const ScannerImages> scannerImages,
                            std::shared_ptr<const PlanImages> planImages) {
  auto snapshot = std::make_shared<ViewSnapshot>();
  if (state && !state->records.empty()) snapshot->plan = state->records.back().plan;
  snapshot->state = std::move(state);
  snapshot->scannerImages = std::move(scannerImages);
  snapshot->planImages = std::move(planImages);
  return snapshot;
}

}  // namespace vantage
