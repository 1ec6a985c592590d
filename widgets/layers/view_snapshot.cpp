#include "layers/view_snapshot.h"

#include <algorithm>

#include "acquisition/further_scan.h"

namespace vantage {

std::vector<int> standsOf(const std::vector<View>& views) {
  std::vector<int> stands;
  for (const View& view : views) stands.push_back(view.image->station.stand);
  return stands;
}

bool haveStands(const std::vector<View>& views) {
  return std::any_of(views.begin(), views.end(),
                     [&](const View& v) { return v.image->station.stand != views.front().image->station.stand; });
}

SharedSnapshot makeSnapshot(std::shared_ptr<const AcquisitionState> state,
                            std::shared_ptr<const ScannerImages> scannerImages,
                            std::shared_ptr<const PlanImages> planImages) {
  auto snapshot = std::make_shared<ViewSnapshot>();
  if (state) {
    snapshot->plan = state->plan;
    snapshot->views = viewsOf(*state);
    if (!state->scans.empty()) snapshot->table = state->scans.back().station().position;
    if (state->plan) {
      const auto further = furtherScan(*state);
      snapshot->next = nextPosition(*state);
      if (!snapshot->next && further) snapshot->further = further->position;
    }
    snapshot->operatorsChoice = snapshot->next && state->chosenPosition.has_value();
  }
  snapshot->state = std::move(state);
  snapshot->scannerImages = std::move(scannerImages);
  snapshot->planImages = std::move(planImages);
  return snapshot;
}

}  // namespace vantage
