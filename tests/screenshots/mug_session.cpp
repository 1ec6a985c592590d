#include "screenshots/mug_session.h"

#include <stdexcept>

#include "acquisition/acquisition.h"
#include "acquisition/memory_journal.h"
#include "acquisition/steps.h"
#include "io/mesh_reader.h"
#include "support/simulation.h"

namespace vantage::testing {
namespace {

std::shared_ptr<const PlanImages> imagesOf(const AcquisitionState& state, const ScannerImages& scannerImages) {
  const PlanningScene scene(planInputOf(state), state.plan->voids, stepOptionsFor(state).planner, {});
  return std::make_shared<const PlanImages>(computePlanImages(scene, scannerImages, {}));
}

std::vector<SharedSnapshot> acquireMug() {
  const auto profile =
      std::make_shared<const ScannerProfile>(loadProfile(VANTAGE_SOURCE_DIR "/tests/screenshots/coarse_scanner.json"));
  AcquisitionSettings settings;
  settings.maxViews = 12;
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*profile));
  const Rig rig = simulation(loadMesh(VANTAGE_SOURCE_DIR "/resources/objects/mug.ply").mesh, profile);
  std::vector<SharedSnapshot> snapshots;
  const auto observe = [&](const Command&, const AcquisitionState&, const AcquisitionState& after) {
    const auto kept = std::make_shared<const AcquisitionState>(after);
    snapshots.push_back(makeSnapshot(kept, images, imagesOf(*kept, *images)));
  };
  MemoryJournal journal(profile, settings);
  const Termination end = Acquisition(journal, {rig, images}, observe).runUntilTheEnd(Progress().withThreads(2));
  if (end != Termination::Finished) throw std::runtime_error("the mug was not finished in 12 views");
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
