#include "screenshots/mug_session.h"

#include <stdexcept>

#include "acquisition/automatic_run.h"
#include "io/mesh_reader.h"
#include "scanner/simulated_scanner.h"

namespace vantage::testing {
namespace {

std::shared_ptr<const PlanImages> imagesOf(const AcquisitionState& state, const ScannerImages& scannerImages) {
  const auto plan = state.records.back().plan;
  return std::make_shared<const PlanImages>(
      computePlanImages({*state.profile, scannerImages, *state.model, state.views, state.records.back().position},
                        *plan->voids, stepOptionsFor(state).planner, Progress()));
}

std::vector<SharedSnapshot> acquireMug() {
  AcquisitionState state;
  state.profile =
      std::make_shared<const ScannerProfile>(loadProfile(VANTAGE_SOURCE_DIR "/tests/screenshots/coarse_scanner.json"));
  state.settings.maxViews = 12;
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*state.profile));
  SimulatedScanner scanner(loadMesh(VANTAGE_SOURCE_DIR "/resources/objects/mug.ply").mesh, state.profile, {1, false});
  std::vector<SharedSnapshot> snapshots;
  const auto observe = [&](const Command&, const AcquisitionState& after) {
    const auto kept = std::make_shared<const AcquisitionState>(after);
    snapshots.push_back(makeSnapshot(kept, images, imagesOf(*kept, *images)));
  };
  const AcquisitionState last = acquire(state, countedScans(scanner), *images, observe, Progress().withThreads(2));
  if (last.termination != Termination::Finished) throw std::runtime_error("the mug was not finished in 12 views");
  return snapshots;
}

}  // namespace

const std::vector<SharedSnapshot>& mugSnapshots() {
  static const std::vector<SharedSnapshot> snapshots = acquireMug();
  return snapshots;
}

SharedSnapshot mugUnderWay() {
  return mugSnapshots().at(2);
}

SharedSnapshot mugFinished() {
  return mugSnapshots().back();
}

}  // namespace vantage::testing
