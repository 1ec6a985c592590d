#include "registration/pair_finding.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 2048;
// Points that face away from the ray by less than this cosine are not seen from the scanner.
constexpr double kFacing = 0.1;
// A normal this much along the ray of a point nearby faces away from its own ray too: no need to look it up.
constexpr double kSurelyAway = 0.8;
// A partner may lie this many gates to the side: steep rays slide along the surface.
constexpr double kAside = 3.0;

Pair judgePair(const Vec3& p, const Vec3& normal, float confidence, const SurfaceSample& sample,
               const PairGates& gates) {
  Pair pair;
  pair.point = sample.point;
  if (normal.dot(sample.direction) > -kFacing) return pair;
  const Vec3 offset = p - sample.point;
  const double agreement = normal.dot(sample.normal);
  pair.normal = agreement > -0.9 ? Vec3((normal + sample.normal).normalized()) : sample.normal;
  pair.distance = pair.normal.dot(offset);
  pair.normalSpread = 2.0 - 2.0 * agreement;
  pair.weight = std::sqrt(confidence * sample.confidence);

  const double depth = offset.dot(sample.direction);
  if (std::abs(pair.distance) > gates.distance || std::abs(depth) > kAside * gates.distance) {
    if (depth > gates.depth) return pair;
    pair.state = !sample.inside ? PairState::Border : depth > 0.0 ? PairState::Behind : PairState::InFront;
    return pair;
  }
  pair.state = !sample.inside                      ? PairState::Border
               : agreement < std::cos(gates.angle) ? PairState::Turned
                                                   : PairState::Paired;
  return pair;
}

template <typename Points>
void lookUp(const Points& points, std::span<const std::uint32_t> ids, const Pose& T_scanner_points,
            const ViewSurface& surface, const PairGates& gates, std::span<std::optional<GridPosition>> positions,
            const Progress& progress, std::span<Pair> pairs) {
  parallelChunks(ids.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    std::optional<GridPosition> last;
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = ids[k];
      pairs[k] = {};
      const Vec3 normal = T_scanner_points.linear() * points.normalAt(i);
      if (!positions[k]) positions[k] = last;
      if (positions[k] && normal.dot(surface.directionAt(*positions[k])) > kSurelyAway) continue;
      const Vec3 p = T_scanner_points * points.pointAt(i);
      const auto sample = surface.sample(p, positions[k]);
      if (positions[k]) last = positions[k];
      if (sample) pairs[k] = judgePair(p, normal, points.confidenceAt(i), *sample, gates);
    }
  });
}

}  // namespace

void findPairs(const OrientedPoints& points, std::span<const std::uint32_t> ids, const Pose& T_scanner_points,
               const ViewSurface& surface, const PairGates& gates, std::span<std::optional<GridPosition>> positions,
               const Progress& progress, std::span<Pair> pairs) {
  lookUp(points, ids, T_scanner_points, surface, gates, positions, progress, pairs);
}

void findPairs(const OrientedVertices& points, std::span<const std::uint32_t> ids, const Pose& T_scanner_points,
               const ViewSurface& surface, const PairGates& gates, std::span<std::optional<GridPosition>> positions,
               const Progress& progress, std::span<Pair> pairs) {
  lookUp(points, ids, T_scanner_points, surface, gates, positions, progress, pairs);
}

double medianDistance(std::span<const Pair> pairs) {
  std::vector<double> distances;
  distances.reserve(pairs.size());
  for (const Pair& pair : pairs)
    if (pair.state == PairState::Paired) distances.push_back(std::abs(pair.distance));
  if (distances.empty()) return 0.0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace vantage
