#include "registration/oriented_points.h"

#include <numeric>
#include <utility>

#include "base/random.h"

namespace vantage {
namespace {

constexpr std::uint64_t kThinningSeed = 0x7468696eULL;

template <typename Points>
OrientedPoints chosen(const Points& points, const std::vector<std::uint32_t>& ids) {
  OrientedPoints some;
  some.points.reserve(ids.size());
  some.normals.reserve(ids.size());
  some.confidence.reserve(ids.size());
  for (const std::uint32_t k : ids) {
    some.points.push_back(points.pointAt(k));
    some.normals.push_back(points.normalAt(k));
    some.confidence.push_back(points.confidenceAt(k));
  }
  return some;
}

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

OrientedVertices::OrientedVertices(const std::vector<Vec3>& positions, std::shared_ptr<const std::vector<Vec3>> normals,
                                   const std::vector<float>& confidence, std::vector<std::uint32_t> vertices)
    : positions_(&positions),
      normals_(std::move(normals)),
      confidence_(&confidence),
      vertices_(std::make_shared<const std::vector<std::uint32_t>>(std::move(vertices))) {}

OrientedPoints thinnedPoints(const OrientedPoints& points, std::size_t count) {
  if (points.size() <= count) return points;
  return chosen(points, thinned(allIndices(points.size()), count));
}

OrientedPoints thinnedPoints(const OrientedVertices& points, std::size_t count) {
  return chosen(points, thinned(allIndices(points.size()), count));
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
