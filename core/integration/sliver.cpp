#include "integration/sliver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace vantage {
namespace {

Vec3 unitNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

double roundness(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return sides > 0.0 ? 2.0 * std::numbers::sqrt3 * (b - a).cross(c - a).norm() / sides : 0.0;
}

std::vector<std::uint32_t> neighboursOf(const ModelEditor& editor, std::uint32_t vertex) {
  std::vector<std::uint32_t> result;
  editor.visitTriangles(vertex, [&](std::uint32_t t) {
    for (const std::uint32_t v : editor.triangle(t))
      if (v != vertex) result.push_back(v);
  });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

class EdgeSurgery {
 public:
  EdgeSurgery(ModelEditor& editor, const SliverOptions& options)
      : editor_(editor), options_(options), minTurnCosine_(std::cos(options.maxTurn)) {}

  // Moves all triangles of `gone` over to `kept`, if that leaves a manifold and turns no triangle over.
  bool collapse(std::uint32_t gone, std::uint32_t kept) {
    const std::uint32_t left = editor_.triangleAt(gone, kept);
    const std::uint32_t right = editor_.triangleAt(kept, gone);
    if (left == kNoIndex && right == kNoIndex) return false;
    const bool borderEdge = left == kNoIndex || right == kNoIndex;
    if (!borderEdge && editor_.onBoundary(gone)) return false;
    if (!linksAllow(gone, kept, (left != kNoIndex) + (right != kNoIndex))) return false;
    std::vector<Triangle> moved;
    std::vector<std::uint32_t> views;
    const std::vector<std::uint32_t> around = editor_.trianglesOf(gone);
    for (const std::uint32_t t : around) {
      if (t == left || t == right) continue;
      Triangle v = editor_.triangle(t);
      const Vec3 before = normalOf(v);
      std::replace(v.begin(), v.end(), gone, kept);
      if (normalOf(v).dot(before) < minTurnCosine_) return false;
      moved.push_back(v);
      views.push_back(editor_.model().triangleView[t]);
    }
    if (moved.empty()) return false;
    for (const std::uint32_t t : around) editor_.removeTriangle(t);
    for (std::size_t i = 0; i < moved.size(); ++i) editor_.addTriangle(moved[i], views[i]);
    return true;
  }

  // Replaces edge k of the triangle by the other diagonal, if that makes the flatter triangle rounder.
  bool flip(std::uint32_t t, int k) {
    const std::uint32_t other = editor_.neighbour(t, k);
    if (other == kNoIndex) return false;
    const std::uint32_t a = editor_.triangle(t)[k];
    const std::uint32_t b = editor_.triangle(t)[(k + 1) % 3];
    const std::uint32_t c = editor_.triangle(t)[(k + 2) % 3];
    const Triangle& o = editor_.triangle(other);
    const std::uint32_t d = o[0] != a && o[0] != b ? o[0] : (o[1] != a && o[1] != b ? o[1] : o[2]);
    const double before = std::min(roundnessOf({a, b, c}), roundnessOf({b, a, d}));
    const Triangle first{c, a, d};
    const Triangle second{d, b, c};
    if (before >= options_.minRoundness || std::min(roundnessOf(first), roundnessOf(second)) <= before) return false;
    if (editor_.triangleAt(c, d) != kNoIndex || editor_.triangleAt(d, c) != kNoIndex) return false;
    // A ridge along the edge would be cut off.
    if (normalOf({a, b, c}).dot(normalOf({b, a, d})) < minTurnCosine_) return false;
    const Vec3 whole =
        (areaVector(editor_.model().mesh, {a, b, c}) + areaVector(editor_.model().mesh, {b, a, d})).normalized();
    if (normalOf(first).dot(whole) < minTurnCosine_ || normalOf(second).dot(whole) < minTurnCosine_) return false;
    const std::uint32_t view = std::max(editor_.model().triangleView[t], editor_.model().triangleView[other]);
    editor_.removeTriangle(t);
    editor_.removeTriangle(other);
    editor_.addTriangle(first, view);
    editor_.addTriangle(second, view);
    return true;
  }

  [[nodiscard]] double length(std::uint32_t a, std::uint32_t b) const {
    return (editor_.position(a) - editor_.position(b)).norm();
  }

 private:
  // The ends of the edge have no neighbours in common but the corners opposite it.
  [[nodiscard]] bool linksAllow(std::uint32_t a, std::uint32_t b, int opposite) const {
    const auto nearA = neighboursOf(editor_, a);
    const auto nearB = neighboursOf(editor_, b);
    std::vector<std::uint32_t> common;
    std::set_intersection(nearA.begin(), nearA.end(), nearB.begin(), nearB.end(), std::back_inserter(common));
    return common.size() == static_cast<std::size_t>(opposite);
  }

  [[nodiscard]] Vec3 normalOf(const Triangle& t) const {
    return unitNormal(editor_.position(t[0]), editor_.position(t[1]), editor_.position(t[2]));
  }
  [[nodiscard]] double roundnessOf(const Triangle& t) const {
    return roundness(editor_.position(t[0]), editor_.position(t[1]), editor_.position(t[2]));
  }

  ModelEditor& editor_;
  const SliverOptions& options_;
  double minTurnCosine_;
};

}  // namespace

std::size_t removeSlivers(ModelEditor& editor, std::span<const std::uint32_t> vertices, const SliverOptions& options) {
  EdgeSurgery surgery(editor, options);
  std::size_t changed = 0;
  for (const std::uint32_t v : vertices) {
    for (const std::uint32_t w : neighboursOf(editor, v)) {
      if (surgery.length(v, w) >= options.shortestEdge) continue;
      const bool keepV = editor.model().confidence[v] >= editor.model().confidence[w];
      if (!surgery.collapse(keepV ? w : v, keepV ? v : w) && !surgery.collapse(keepV ? v : w, keepV ? w : v)) continue;
      ++changed;
      break;
    }
  }
  for (int round = 0; round < options.flipRounds; ++round)
    for (const std::uint32_t v : vertices)
      for (const std::uint32_t t : editor.trianglesOf(v))
        for (int k = 0; k < 3 && editor.alive(t); ++k) changed += surgery.flip(t, k) ? 1 : 0;
  return changed;
}

}  // namespace vantage
