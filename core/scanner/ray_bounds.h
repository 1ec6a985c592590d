#pragma once

#include <vector>

#include "geometry/vectors.h"

namespace vantage {

class RayGrid;

/// The points with normal . p >= offset.
struct HalfSpace {
  Vec3 normal;
  double offset;  ///< [mm]

  [[nodiscard]] bool contains(const Vec3& p) const { return normal.dot(p) >= offset; }
};

/// Half-spaces that hold every ray of a grid, widened by half a cell: one in front of the scanner and one along each
/// side. What is outside of one of them is met by no ray. Tight for pinhole, linear and rotating stripe scanners;
/// none when the rays spread over more than a half-space.
[[nodiscard]] std::vector<HalfSpace> boundingHalfSpaces(const RayGrid& rays);

}  // namespace vantage
