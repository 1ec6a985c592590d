#include "screenshots/mug_session.h"

#include <algorithm>
#include <cmath>
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

Colour ringsAt(const Vec3& p) {
  const bool blue = static_cast<int>(std::floor(p.z() / 12.0)) % 2 == 0;
  const auto red = static_cast<std::uint8_t>(std::clamp(120.0 + 2.0 * p.y(), 0.0, 255.0));
  return blue ? Colour{red, 90, 200} : Colour{red, 170, 60};
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

SharedSnapshot paintedMug(std::size_t viewsWithout) {
  auto state = std::make_shared<AcquisitionState>(*mugFinished()->state);
  for (std::size_t k = viewsWithout; k < state->scans.size(); ++k) {
    View& view = state->scans[k].view;
    RangeImage image = *view.image;
    image.colours.assign(image.range.size(), Colour{});
    for (std::size_t i = 0; i < image.range.size(); ++i)
      if (image.valid(i)) image.colours[i] = ringsAt(view.T_object_scanner * image.point(i));
    view.image = std::make_shared<const RangeImage>(std::move(image));
  }
  return makeSnapshot(state);
}

}  // namespace vantage::testing
