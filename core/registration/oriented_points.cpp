#include "registration/oriented_points.h"

#include <numeric>

#include "base/random.h"

namespace vantage {
namespace {

constexpr std::uint64_t kThinningSeed = 0x7468696eULL;

}  // namespace

void OrientedPoints::append(const OrientedPoints& other, const Pose& T_this_other) {
  points.reserve(size() + other.size());
  normals.reserve(points.capacity());
  for (std::size_t i = 0; i < other.size(); ++i) {
    points.push_back(T_this_other * other.points[i]);
    normals.push_back(T_this_other.linear() * other.normals[i]);
  }
  confidence.insert(confidence.end(), other.confidence.begin(), other.confidence.end());
}

OrientedPoints thinnedPoints(const OrientedPoints& points, std::size_t count) {
  if (points.size() <= count) return points;
  OrientedPoints some;
  for (const std::uint32_t k : thinned(allIndices(points.size()), count)) {
    some.points.push_back(points.points[k]);
    some.normals.push_back(points.normals[k]);
    some.confidence.push_back(points.confidence[k]);
  }
  return some;
}

std::vector<std::uint32_t> allIndices(std::size_t size) {
  std::vector<std::uint32_t> all(size);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

std::vector<std::uint32_t> thinned(std::vector<std::uint32_t> indices, std::size_t count) {
  if (indices.size() <= count) return indices;
  const std::size_t all = indices.size();
  // A stream of its own per size, so that thinning twice does not ask the same hash again.
  std::erase_if(indices, [&](std::uint32_t i) { return Random(kThinningSeed + all, i).below(all) >= count; });
  return indices;
}

}  // namespace vantage
