#include "planning/void_extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

#include "base/errors.h"

namespace vantage {
namespace {

using Cell = std::array<std::int64_t, 3>;

Cell cellOf(const Vec3& p, double size) {
  return {static_cast<std::int64_t>(std::floor(p.x() / size)), static_cast<std::int64_t>(std::floor(p.y() / size)),
          static_cast<std::int64_t>(std::floor(p.z() / size))};
}

// Middle of the patch's edge, and the direction in which the patch leaves it.
struct Front {
  Vec3 place;
  Vec3 ahead;
};

Front frontOf(const VoidPatch& patch) {
  const Vec3 place = 0.5 * (patch.corners[0] + patch.corners[1]);
  return {place, (0.5 * (patch.corners[2] + patch.corners[3]) - place).normalized()};
}

bool facing(const Front& a, const Front& b, double distance, double minCosine) {
  const Vec3 across = (b.place - a.place) / distance;
  return across.dot(a.ahead) > minCosine && -across.dot(b.ahead) > minCosine;
}

}  // namespace

std::vector<double> voidExtents(std::span<const VoidPatch> patches, const VoidExtentOptions& options) {
  if (!(options.reach > 0.0) || !(options.farthest > 0.0))
    throw InvalidInput("void patches reach " + std::to_string(options.reach) + " mm ahead and " +
                       std::to_string(options.farthest) + " mm across, expected more than 0");
  std::vector<Front> fronts;
  std::map<Cell, std::vector<std::uint32_t>> cells;
  for (const VoidPatch& patch : patches) {
    cells[cellOf(frontOf(patch).place, options.farthest)].push_back(static_cast<std::uint32_t>(fronts.size()));
    fronts.push_back(frontOf(patch));
  }
  const double minCosine = std::cos(options.facingAngle);
  std::vector<double> extents;
  extents.reserve(patches.size());
  for (const Front& front : fronts) {
    std::optional<double> width;
    const Cell middle = cellOf(front.place, options.farthest);
    for (int k = 0; k < 27; ++k) {
      const auto cell = cells.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
      if (cell == cells.end()) continue;
      for (const std::uint32_t other : cell->second) {
        const double distance = (fronts[other].place - front.place).norm();
        if (distance > 0.0 && distance < width.value_or(options.farthest) &&
            facing(front, fronts[other], distance, minCosine))
          width = distance;
      }
    }
    extents.push_back(width ? 0.5 * *width / options.reach : 1.0);
  }
  return extents;
}

}  // namespace vantage
