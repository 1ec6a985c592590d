#include "layers/view_snapshot.h"

#include "acquisition/next_scan.h"

namespace vantage {

SharedSnapshot makeSnapshot(std::shared_ptr<const AcquisitionState> state,
                            std::shared_ptr<const ScannerImages> scannerImages,
                            std::shared_ptr<const PlanImages> planImages) {
  auto snapshot = std::make_shared<ViewSnapshot>();
  if (state) {
    snapshot->plan = state->plan;
    snapshot->views = viewsOf(*state);
    if (!state->scans.empty()) snapshot->table = state->scans.back().station().position;
    if (state->plan) snapshot->next = nextPosition(*state);
  }
  snapshot->state = std::move(state);
  snapshot->scannerImages = std::move(scannerImages);
  snapshot->planImages = std::move(planImages);
  return snapshot;
}

}  // namespace vantage
