#include "planning/position_sight.h"

#include "base/parallel.h"
#include "planning/patch_promise.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 64;

std::uint32_t firstBetween(const PlanningScene& scene, const Vec3& start, const Vec3& direction) {
  const auto hit = scene.obstacles().intersect(start, direction, scene.sight().options().margin);
  return hit ? hit->triangle : kNoIndex;
}

std::uint32_t beforeReceiver(const PlanningScene& scene, const Pose& T_table_scanner, const Vec3& point,
                             const Vec3& start) {
  const RayGrid& rays = *scene.profile().rays;
  const auto place = rays.locate(T_table_scanner.inverse() * point);
  if (!place) return kNoIndex;
  const auto receivers = rays.receivers(rays.nearest(*place));
  if (receivers.empty()) return kNoIndex;
  return firstBetween(scene, start, (T_table_scanner * receivers.front() - start).normalized());
}

PatchSight patchSight(const PlanningScene& scene, const Pose& T_table_scanner, std::size_t p) {
  const VoidPatch& patch = scene.patches()[p];
  const Sight seen = sightOf(scene, T_table_scanner, p);
  PatchSight result{seen.visibility, seen.cosine, kNoIndex};
  const Vec3 start = patch.centre + scene.sight().options().offset * patch.normal;
  if (seen.visibility == Visibility::LightBlocked) result.blocker = firstBetween(scene, start, seen.direction);
  if (seen.visibility == Visibility::ReceiverBlocked)
    result.blocker = beforeReceiver(scene, T_table_scanner, patch.centre, start);
  return result;
}

}  // namespace

PositionSight computePositionSight(const PlanningScene& scene, int position, const Progress& progress) {
  const Pose& T_table_scanner = scene.pose(position);
  PositionSight result;
  result.patches.resize(scene.patches().size());
  parallelChunks(result.patches.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) result.patches[p] = patchSight(scene, T_table_scanner, p);
  });
  for (std::size_t p = 0; p < result.patches.size(); ++p) {
    const auto v = static_cast<std::size_t>(result.patches[p].visibility);
    ++result.counts[v];
    result.areas[v] += scene.patches()[p].weight;
  }
  return result;
}

}  // namespace vantage
