#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/region.h"

namespace vantage {

/// A region made ready to be asked about many points. Immutable; any number of threads may ask it.
class RegionProbe {
 public:
  /// @throws InvalidInput for a region that is none, see `validate`
  explicit RegionProbe(Region region);

  [[nodiscard]] const Region& region() const { return region_; }

  /// Whether a point lies in the region, or no farther than `margin` from it [mm]. Beside a lasso whose lines of sight
  /// meet the margin is measured at the depth of the point.
  /// @pre margin >= 0
  [[nodiscard]] bool holds(const Vec3& p, double margin = 0.0) const;

 private:
  using Cell = std::array<std::int32_t, 3>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  [[nodiscard]] Cell cellOf(const Vec3& p) const;
  [[nodiscard]] bool isNear(const NearPoints& region, const Vec3& p, double margin) const;

  Region region_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;  // of points, as wide as their radius
};

}  // namespace vantage
