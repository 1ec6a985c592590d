#include "finishing/loop_triangulation.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace vantage {
namespace {

// A polygon of so many vertices is cut up in one go: time grows with the third power.
constexpr std::size_t kMostVertices = 200;

struct Weight {
  double angle = std::numeric_limits<double>::infinity();  // 1 - cos of the greatest angle between neighbours
  double area = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool possible() const { return angle < std::numeric_limits<double>::infinity(); }
  bool operator<(const Weight& other) const { return angle != other.angle ? angle < other.angle : area < other.area; }
};

// Dynamic programming over the part of a polygon from place i to place k, for all i < k.
class PolygonCutter {
 public:
  PolygonCutter(std::span<const Vec3> points, std::span<const std::size_t> places, const LoopSurroundings& surroundings)
      : points_(points),
        places_(places),
        surroundings_(surroundings),
        n_(places.size()),
        best_(n_ * n_),
        via_(n_ * n_, 0) {}

  // @param outer normal beside the edge from the last vertex to the first
  std::vector<Triangle> cut(const Vec3& outer, const Progress& progress) {
    for (std::size_t i = 0; i + 1 < n_; ++i)
      if (mayJoin(i, i + 1)) best_[at(i, i + 1)] = {0.0, 0.0};
    for (std::size_t span = 2; span < n_; ++span) {
      progress.checkpoint(static_cast<double>(span) / static_cast<double>(n_));
      for (std::size_t i = 0; i + span < n_; ++i) decide(i, i + span, outer);
    }
    std::vector<Triangle> triangles;
    if (n_ < 3 || !best_[at(0, n_ - 1)].possible()) return triangles;
    collect(triangles);
    return triangles;
  }

 private:
  [[nodiscard]] std::size_t at(std::size_t i, std::size_t k) const { return i * n_ + k; }
  [[nodiscard]] const Vec3& point(std::size_t i) const { return points_[places_[i]]; }

  // Twice the area vector.
  [[nodiscard]] Vec3 vectorOf(std::size_t i, std::size_t m, std::size_t k) const {
    return (point(m) - point(i)).cross(point(k) - point(i));
  }

  // Of the surface across the edge from place i to k > i: the triangle there, or what is beside the polygon.
  [[nodiscard]] Vec3 normalAcross(std::size_t i, std::size_t k) const {
    if (k > i + 1) return vectorOf(i, via_[at(i, k)], k).normalized();
    const bool edge = (places_[i] + 1) % points_.size() == places_[k];
    return edge && !surroundings_.normals.empty() ? surroundings_.normals[places_[i]] : Vec3(Vec3::Zero());
  }

  [[nodiscard]] static double bend(const Vec3& normal, const Vec3& other) {
    return other.isZero(0.0) ? 0.0 : 1.0 - normal.dot(other);
  }

  [[nodiscard]] bool mayJoin(std::size_t i, std::size_t k) const {
    const std::size_t a = places_[i];
    const std::size_t b = places_[k];
    if ((a + 1) % points_.size() == b || (b + 1) % points_.size() == a) return true;
    return !surroundings_.joined || !surroundings_.joined(a, b);
  }

  void decide(std::size_t i, std::size_t k, const Vec3& outer) {
    if (!mayJoin(i, k)) return;
    Weight& best = best_[at(i, k)];
    for (std::size_t m = i + 1; m < k; ++m) {
      const Weight& left = best_[at(i, m)];
      const Weight& right = best_[at(m, k)];
      if (!left.possible() || !right.possible()) continue;
      Weight weight{std::max(left.angle, right.angle), left.area + right.area};
      if (best < weight) continue;
      const Vec3 vector = vectorOf(i, m, k);
      const double length = vector.norm();
      weight.area += 0.5 * length;
      if (length > 0.0) {
        const Vec3 normal = vector / length;
        weight.angle = std::max({weight.angle, bend(normal, normalAcross(i, m)), bend(normal, normalAcross(m, k))});
        if (i == 0 && k == n_ - 1) weight.angle = std::max(weight.angle, bend(normal, outer));
      } else {
        weight.angle = std::max(weight.angle, 2.0);  // no surface
      }
      if (weight < best) {
        best = weight;
        via_[at(i, k)] = static_cast<std::uint32_t>(m);
      }
    }
  }

  void collect(std::vector<Triangle>& triangles) const {
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k < i + 2) continue;
      const std::size_t m = via_[at(i, k)];
      triangles.push_back({static_cast<std::uint32_t>(places_[i]), static_cast<std::uint32_t>(places_[m]),
                           static_cast<std::uint32_t>(places_[k])});
      open.emplace_back(i, m);
      open.emplace_back(m, k);
    }
  }

  std::span<const Vec3> points_;
  std::span<const std::size_t> places_;
  const LoopSurroundings& surroundings_;
  std::size_t n_;
  std::vector<Weight> best_;
  std::vector<std::uint32_t> via_;
};

std::vector<Triangle> cutPlaces(std::span<const Vec3> points, std::span<const std::size_t> places,
                                const LoopSurroundings& surroundings, const Vec3& outer, const Progress& progress) {
  return PolygonCutter(points, places, surroundings).cut(outer, progress);
}

// Between evenly taken vertices first, then every chain between two of them.
std::vector<Triangle> cutLong(std::span<const Vec3> points, const LoopSurroundings& surroundings,
                              const Progress& progress) {
  const std::size_t count = points.size();
  std::vector<std::size_t> taken(kMostVertices);
  for (std::size_t i = 0; i < kMostVertices; ++i) taken[i] = i * count / kMostVertices;
  LoopSurroundings coarse = surroundings;
  coarse.normals.clear();
  std::vector<Triangle> triangles = cutPlaces(points, taken, coarse, Vec3::Zero(), progress.part(0.0, 0.5));
  if (triangles.empty()) return triangles;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    const std::size_t end = i + 1 < taken.size() ? taken[i + 1] : count;
    std::vector<std::size_t> chain(end - taken[i] + 1);
    std::iota(chain.begin(), chain.end(), taken[i]);
    chain.back() %= count;
    if (chain.size() < 3) continue;
    // The last chain ends in the first vertex of the polygon.
    std::vector<Vec3> part;
    for (const std::size_t place : chain) part.push_back(points[place]);
    LoopSurroundings inner;
    inner.normals.assign(part.size(), Vec3::Zero());
    for (std::size_t k = 0; k + 1 < chain.size() && !surroundings.normals.empty(); ++k)
      inner.normals[k] = surroundings.normals[chain[k]];
    if (surroundings.joined)
      inner.joined = [&](std::size_t a, std::size_t b) { return surroundings.joined(chain[a], chain[b]); };
    std::vector<Triangle> filled = triangulateLoop(part, inner, progress.part(0.5, 1.0));
    if (filled.empty()) return {};
    for (Triangle& t : filled)
      triangles.push_back({static_cast<std::uint32_t>(chain[t[0]]), static_cast<std::uint32_t>(chain[t[1]]),
                           static_cast<std::uint32_t>(chain[t[2]])});
  }
  return triangles;
}

}  // namespace

std::vector<Triangle> triangulateLoop(std::span<const Vec3> points, const LoopSurroundings& surroundings,
                                      const Progress& progress) {
  if (points.size() < 3) return {};
  if (points.size() > kMostVertices) return cutLong(points, surroundings, progress);
  std::vector<std::size_t> places(points.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  const Vec3 outer = surroundings.normals.empty() ? Vec3(Vec3::Zero()) : surroundings.normals.back();
  return cutPlaces(points, places, surroundings, outer, progress);
}

}  // namespace vantage
