#include "screenshots/mug_session.h"

#include <stdexcept>

#include "acquisition/automatic_run.h"
#include "io/mesh_reader.h"
#include "scanner/simulated_scanner.h"

namespace vantage::testing {
namespace {

// About 3 mm between samples: a run takes seconds.
const char* const kProfile = R"({
  "name": "Coarse scanner",
  "scanner": { "type": "rotating_stripe", "position": [300, 0, 75], "stripe_height_mm": 150, "samples_per_stripe": 61,
    "stripes": 91, "sweep_deg": 40, "receivers": [[60, 0, 0]], "breakdown_angle_deg": 60, "range_mm": [100, 500],
    "noise": { "range_sigma_mm": 0.05, "dropout": 0.0 } },
  "workspace": { "type": "turntable", "steps": 60 },
  "viewing_volume": { "radius_mm": 90, "height_mm": 150 },
  "positional_space": { "surface": "cylinder", "rows": 12, "columns": 60 },
  "mechanics": { "angle_sigma_deg": 0.2, "position_sigma_mm": 0.2 } })";

std::shared_ptr<const PlanImages> imagesOf(const AcquisitionState& state, const ScannerImages& scannerImages) {
  const auto plan = state.records.back().plan;
  return std::make_shared<const PlanImages>(
      computePlanImages({*state.profile, scannerImages, *state.model, state.views, state.records.back().position},
                        *plan->voids, stepOptionsFor(state).planner, Progress()));
}

std::vector<SharedSnapshot> acquireMug() {
  AcquisitionState state;
  state.profile = std::make_shared<const ScannerProfile>(parseProfile({"coarse.json", kProfile, {}}));
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
