#include "set_up.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.h"
#include "io/placement.h"
#include "positional_space/scanner_images_cache.h"
#include "report/memory_note.h"
#include "scanner/profile_size.h"

namespace vantage {
namespace {

void requireFirstView(int position, std::size_t positions) {
  if (positions > 0 && position >= static_cast<int>(positions))
    throw InvalidInput("the first view is to be taken from position " + std::to_string(position) +
                       ", but the scanner has the positions 0 to " + std::to_string(positions - 1));
}

}  // namespace

ObjectOnTable measured(std::shared_ptr<const Mesh> mesh, const ViewingVolume& volume) {
  ObjectOnTable object;
  object.insideVolume = isInside(*mesh, volume);
  object.lowest = mesh->vertices.empty() ? 0.0 : mesh->vertices.front().z();
  for (const Vec3& p : mesh->vertices) {
    object.radius = std::max(object.radius, std::hypot(p.x(), p.y()));
    object.height = std::max(object.height, p.z());
    object.lowest = std::min(object.lowest, p.z());
  }
  object.mesh = std::move(mesh);
  return object;
}

void placeObject(SetUp& setUp, std::shared_ptr<const Mesh> mesh) {
  const AcquisitionSettings& settings = setUp.choice.settings;
  HandTable::AskPerson ask;
  if (turnedByHand(setUp)) ask = [](int, const Progress&) {};
  setUp.devices = Simulated{mesh, setUp.profile, {settings.simulation.seed, settings.simulation.ideal}, ask};
  setUp.object = measured(std::move(mesh), setUp.profile->viewingVolume);
}

void connectDevices(SetUp& setUp) {
  setUp.devices = RealDevices{setUp.choice.rig, setUp.profile, [](int, const Progress&) {}};
}

bool turnedByHand(const SetUp& setUp) {
  return std::holds_alternative<HandTableDevice>(setUp.choice.rig.table);
}

bool operator==(const SetUpChoice& a, const SetUpChoice& b) {
  return a.rig == b.rig && a.scanner == b.scanner && a.folder == b.folder && a.settings == b.settings;
}

std::optional<Phrase> memoryNoteOf(const SetUpChoice& choice) {
  RigDescription rig = choice.rig;
  rig.scanner = choice.scanner;
  return memoryNote(raysSaidBy(profileOf(rig)), choice.settings.thinning);
}

SharedSetUp prepareSetUp(const SetUpChoice& choice, const std::string& cacheFolder, const Progress& progress) {
  auto setUp = std::make_shared<SetUp>();
  setUp->choice = choice;
  progress.part(0.0, 0.05, "read profile").checkpoint(0.0);
  RigDescription rig = choice.rig;
  rig.scanner = choice.scanner;
  setUp->source = profileOf(rig);
  setUp->profile = std::make_shared<const ScannerProfile>(parseProfile(setUp->source));
  requireFirstView(choice.settings.firstView, setUp->profile->workspace.size());
  if (!isSimulated(choice.rig)) {
    connectDevices(*setUp);
  } else if (!choice.settings.simulation.object.empty()) {
    const SimulationSettings& simulation = choice.settings.simulation;
    const PlacementOptions placement{simulation.placement, simulation.unit};
    PlacedMesh loaded = loadPlacedMesh(simulation.object, placement, setUp->profile->viewingVolume,
                                       progress.part(0.05, 0.4, "read object"));
    requireClearUnit(simulation.object, placement, loaded.mesh, *setUp->profile);
    setUp->notes = describe(loaded.repair);
    placeObject(*setUp, std::make_shared<const Mesh>(std::move(loaded.mesh)));
  }
  setUp->images = std::make_shared<const ScannerImages>(
      loadScannerImages(*setUp->profile, cacheFolder, progress.part(0.4, 1.0, "positional space of the scanner")));
  return setUp;
}

}  // namespace vantage
