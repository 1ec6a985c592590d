#include "set_up.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "io/placement.h"
#include "positional_space/scanner_images_cache.h"

namespace vantage {
namespace {

void placeObject(SetUp& setUp, const Progress& progress) {
  const AcquisitionSettings& settings = setUp.choice.settings;
  PlacedMesh loaded = loadPlacedMesh(settings.object, settings.placement, setUp.profile->viewingVolume, progress);
  setUp.notes = describe(loaded.repair);
  auto object = std::make_shared<const Mesh>(std::move(loaded.mesh));
  setUp.insideVolume = isInside(*object, setUp.profile->viewingVolume);
  setUp.lowest = object->vertices.empty() ? 0.0 : object->vertices.front().z();
  for (const Vec3& p : object->vertices) {
    setUp.radius = std::max(setUp.radius, std::hypot(p.x(), p.y()));
    setUp.height = std::max(setUp.height, p.z());
    setUp.lowest = std::min(setUp.lowest, p.z());
  }
  setUp.object = std::move(object);
}

}  // namespace

bool operator==(const SetUpChoice& a, const SetUpChoice& b) {
  const auto values = [](const SetUpChoice& c) {
    const AcquisitionSettings& s = c.settings;
    return std::make_tuple(c.scanner, c.folder, s.object, s.placement, s.seed, s.ideal, s.firstView, s.maxViews,
                           s.tolerance, name(s.strategy));
  };
  return values(a) == values(b);
}

SharedSetUp prepareSetUp(const SetUpChoice& choice, const std::string& cacheFolder, const Progress& progress) {
  auto setUp = std::make_shared<SetUp>();
  setUp->choice = choice;
  progress.part(0.0, 0.05, "read profile").checkpoint(0.0);
  setUp->source = readProfileSource(choice.scanner);
  setUp->profile = std::make_shared<const ScannerProfile>(parseProfile(setUp->source));
  if (!choice.settings.object.empty()) placeObject(*setUp, progress.part(0.05, 0.4, "read object"));
  setUp->images = std::make_shared<const ScannerImages>(
      loadScannerImages(*setUp->profile, cacheFolder, progress.part(0.4, 1.0, "positional space of the scanner")));
  return setUp;
}

}  // namespace vantage
