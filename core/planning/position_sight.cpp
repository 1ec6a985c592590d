#include "planning/position_sight.h"

#include "base/errors.h"
#include "base/parallel.h"
#include "geometry/ray_caster.h"
#include "planning/patch_promise.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 64;

// Shares of the sample spacing, the same as in planning.
constexpr double kOffset = 0.25;
constexpr double kMargin = 0.5;

class Looking {
 public:
  Looking(const Pose& T_object_scanner, const Model& model, const ScannerProfile& profile, double spacing)
      : T_object_scanner_(T_object_scanner),
        profile_(profile),
        options_{profile.breakdownAngle, kOffset * spacing, kMargin * spacing},
        obstacles_(model.mesh),
        sight_(profile, obstacles_, options_) {}

  [[nodiscard]] PatchSight at(const VoidPatch& patch) const {
    const Sight seen = lookAt(sight_, T_object_scanner_, patch, options_.breakdownAngle);
    PatchSight result{seen.visibility, seen.cosine, kNoIndex};
    const Vec3 start = patch.centre + options_.offset * patch.normal;
    if (seen.visibility == Visibility::LightBlocked) result.blocker = firstBetween(start, seen.direction);
    if (seen.visibility == Visibility::ReceiverBlocked) result.blocker = beforeReceiver(patch.centre, start);
    return result;
  }

 private:
  [[nodiscard]] std::uint32_t firstBetween(const Vec3& start, const Vec3& direction) const {
    const auto hit = obstacles_.intersect(start, direction, options_.margin);
    return hit ? hit->triangle : kNoIndex;
  }

  [[nodiscard]] std::uint32_t beforeReceiver(const Vec3& point, const Vec3& start) const {
    const auto place = profile_.rays->locate(T_object_scanner_.inverse() * point);
    if (!place) return kNoIndex;
    const auto receivers = profile_.rays->receivers(profile_.rays->nearest(*place));
    if (receivers.empty()) return kNoIndex;
    return firstBetween(start, (T_object_scanner_ * receivers.front() - start).normalized());
  }

  Pose T_object_scanner_;
  const ScannerProfile& profile_;
  SightOptions options_;
  RayCaster obstacles_;
  SightTest sight_;
};

}  // namespace

PositionSight lookFrom(const Pose& T_object_scanner, std::span<const VoidPatch> patches, const Model& model,
                       const ScannerProfile& profile, double spacing, const Progress& progress) {
  if (!(spacing > 0.0))
    throw InvalidInput("the sample spacing is " + std::to_string(spacing) + " mm, expected more than 0");
  progress.checkpoint(0.0);
  const Looking looking(T_object_scanner, model, profile, spacing);
  PositionSight result;
  result.patches.resize(patches.size());
  parallelChunks(patches.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) result.patches[p] = looking.at(patches[p]);
  });
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto v = static_cast<std::size_t>(result.patches[p].visibility);
    ++result.counts[v];
    result.areas[v] += patches[p].weight;
  }
  return result;
}

}  // namespace vantage
