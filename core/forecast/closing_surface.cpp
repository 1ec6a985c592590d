#include "forecast/closing_surface.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/parallel.h"
#include "forecast/closing_field.h"
#include "scanner/sight.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 64;
constexpr double kOnModel = 0.5;      // surface this near to the model's is the model's [sides]
constexpr double kSightMargin = 0.6;  // of lines of sight, and in front of the surface [sides]

// Drops the faces that lie on the model.
void dropOnModel(LevelSurface& surface, const RayCaster& obstacles, double side, const Progress& progress) {
  std::vector<std::uint8_t> onModel(surface.faces.size(), 0);
  parallelChunks(onModel.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      onModel[f] = obstacles.closestPoint(surface.faces[f].centre, kOnModel * side) ? 1 : 0;
  });
  std::size_t kept = 0;
  for (std::size_t f = 0; f < onModel.size(); ++f) {
    if (onModel[f] != 0) continue;
    surface.faces[kept] = surface.faces[f];
    surface.mesh.triangles[2 * kept] = surface.mesh.triangles[2 * f];
    surface.mesh.triangles[2 * kept + 1] = surface.mesh.triangles[2 * f + 1];
    ++kept;
  }
  surface.faces.resize(kept);
  surface.mesh.triangles.resize(2 * kept);
}

// Per face whether a view should have sampled it.
std::vector<std::uint8_t> contradicted(const LevelSurface& surface, const RayCaster& obstacles,
                                       std::span<const View> views, const ScannerProfile& profile,
                                       const SightOptions& options, const Progress& progress) {
  const RayCaster itself(surface.mesh);
  const SightTest sight(profile, obstacles, options, &itself);
  std::vector<std::uint8_t> looked(surface.faces.size(), 0);
  parallelChunks(looked.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const LevelFace& face = surface.faces[f];
      looked[f] = std::any_of(views.begin(), views.end(), [&](const View& view) {
        return sight.look(view.T_object_scanner, face.centre, face.normal).visibility == Visibility::Seen;
      });
    }
  });
  return looked;
}

// Frees what is behind the faces that views should have sampled. @return whether anything was freed
bool carve(FreeSpace& space, const LevelSurface& surface, const std::vector<std::uint8_t>& looked) {
  bool any = false;
  for (std::size_t f = 0; f < looked.size(); ++f) {
    const std::size_t inside = surface.faces[f].inside;
    if (looked[f] == 0 || space.state[inside] != VoxelState::Unseen) continue;
    space.state[inside] = VoxelState::Free;
    space.level[inside] = 1.0F;
    any = true;
  }
  return any;
}

}  // namespace

ClosingSurface predictClosingSurface(const Mesh& model, const RayCaster& obstacles, std::span<const View> views,
                                     const ScannerProfile& profile, double spacing, const ClosingOptions& options,
                                     const Progress& progress) {
  FreeSpace space = carveFreeSpace(model, obstacles, views,
                                   {options.side * spacing, options.crossingAngle, options.silence, options.mostVoxels},
                                   progress.part(0.0, 0.5));
  const double side = space.grid.side;
  const SightOptions looking{std::max(0.0, profile.breakdownAngle - options.clearOfBreakdown), kSightMargin * side,
                             kSightMargin * side};
  relaxLevels(space, options.sweeps);
  LevelSurface surface;
  std::vector<std::uint8_t> looked;
  for (int look = 0; look <= std::max(0, options.mostLooks); ++look) {
    progress.checkpoint(0.5 + 0.5 * look / (1.0 + std::max(0, options.mostLooks)));
    if (look > 0) {
      if (!carve(space, surface, looked)) break;
      relaxLevels(space, options.sweeps / 4);
    }
    surface = levelSurface(space);
    dropOnModel(surface, obstacles, side, progress.part(0.5, 0.5));
    looked = contradicted(surface, obstacles, views, profile, looking, progress.part(0.5, 0.5));
  }
  ClosingSurface closing{{}, std::move(surface.mesh), side};
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    if (looked[f] == 0) closing.faces.push_back(surface.faces[f]);
  return closing;
}

}  // namespace vantage
