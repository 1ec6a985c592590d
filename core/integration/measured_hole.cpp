#include "integration/measured_hole.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "integration/manifold.h"
#include "integration/polygon_fill.h"

namespace vantage {
namespace {

constexpr int kMostEdges = 100;
constexpr int kMostEdgesWidened = 160;  // once the triangles around it are gone
constexpr int kMostRings = 3;
constexpr std::size_t kSquare = 4;        // edges of an opening that no sample lies in
constexpr double kLeastSeen = 0.9;        // of the opening
constexpr double kMostRefuted = 0.02;     // of opening and filling
constexpr double kNegligibleArea = 0.01;  // [squares of the sample spacing] what faces anywhere does no harm
const double kLeastFacing = std::cos(radians(85.0));
const double kMostTurned = std::cos(radians(162.0));

using Loop = std::vector<std::uint32_t>;

void sortUnique(std::vector<std::uint32_t>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

class HoleMender {
 public:
  HoleMender(ModelEditor& editor, const Witnesses& witnesses, const ZipperOptions& options)
      : editor_(editor),
        witnesses_(witnesses),
        maxChordRatio_(options.discontinuityFactor / std::cos(options.breakdownAngle)) {}

  // @return the vertices that it touched; none when the hole stays.
  std::vector<std::uint32_t> close(const Loop& loop) {
    const Testimony opening = ask(leastArea(loop));
    if (loop.size() > kSquare && opening.seen < kLeastSeen * opening.whole) return {};
    if (opening.refuted > kMostRefuted * opening.whole) return {};
    if (auto touched = replace(loop, {}, opening); !touched.empty()) return touched;
    for (const bool nearOthers : {true, false})
      for (int rings = 1; rings <= kMostRings; ++rings)
        if (auto touched = replace(loop, ringsAround(loop, rings, nearOthers), opening); !touched.empty())
          return touched;
    return {};
  }

 private:
  [[nodiscard]] std::vector<Triangle> leastArea(const Loop& loop) const {
    return fillPolygon(editor_, loop, std::numeric_limits<double>::infinity(),
                       [](const Triangle&, const Vec3&) { return true; });
  }
  [[nodiscard]] Testimony ask(const std::vector<Triangle>& triangles) const {
    return witnesses_.ask(editor_.model(), triangles);
  }

  // Fills the opening once rings of triangles around it are gone, or leaves everything as it was.
  std::vector<std::uint32_t> replace(const Loop& loop, const std::vector<std::uint32_t>& rings,
                                     const Testimony& opening) {
    std::vector<std::uint32_t> touched = loop;
    std::vector<std::uint32_t> removed;
    for (const std::uint32_t t : rings) remove(t, removed, touched);
    removeBowTies(removed, touched);
    sortUnique(touched);
    std::vector<std::uint32_t> added;
    const std::vector<Loop> loops = loopsThrough(touched);
    const auto filled = [&](const Loop& l) { return fill(l, opening, added); };
    if (!loops.empty() && std::all_of(loops.begin(), loops.end(), filled)) return touched;
    for (const std::uint32_t t : added) editor_.removeTriangle(t);
    for (const std::uint32_t t : removed) editor_.restoreTriangle(t);
    return {};
  }

  void remove(std::uint32_t t, std::vector<std::uint32_t>& removed, std::vector<std::uint32_t>& touched) {
    removed.push_back(t);
    touched.insert(touched.end(), editor_.triangle(t).begin(), editor_.triangle(t).end());
    editor_.removeTriangle(t);
  }

  // So many rings of triangles, those at other borders among them or not.
  [[nodiscard]] std::vector<std::uint32_t> ringsAround(const Loop& loop, int rings, bool nearOthers) const {
    std::vector<std::uint32_t> front = loop;
    std::vector<std::uint32_t> found;
    for (int ring = 0; ring < rings; ++ring) {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t v : front)
        editor_.visitTriangles(v, [&](std::uint32_t t) {
          if (!nearOthers && isAtOtherBorder(t, loop)) return;
          found.push_back(t);
          next.insert(next.end(), editor_.triangle(t).begin(), editor_.triangle(t).end());
        });
      sortUnique(next);
      front = std::move(next);
    }
    sortUnique(found);
    return found;
  }

  [[nodiscard]] bool isAtOtherBorder(std::uint32_t t, const Loop& loop) const {
    const Triangle& corners = editor_.triangle(t);
    return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
      return editor_.onBoundary(v) && std::find(loop.begin(), loop.end(), v) == loop.end();
    });
  }

  // Where what is left hangs together at a vertex only, the triangles at it go, too.
  void removeBowTies(std::vector<std::uint32_t>& removed, std::vector<std::uint32_t>& touched) {
    if (removed.empty()) return;
    for (std::size_t i = 0; i < touched.size(); ++i) {
      const std::uint32_t v = touched[i];
      if (isSingleFan(editor_, v)) continue;
      for (const std::uint32_t t : editor_.trianglesOf(v)) remove(t, removed, touched);
    }
  }

  // The borders at the vertices; none when one has too many edges.
  [[nodiscard]] std::vector<Loop> loopsThrough(const std::vector<std::uint32_t>& vertices) const {
    std::vector<Loop> loops;
    std::vector<std::uint32_t> done;
    for (const std::uint32_t v : vertices) {
      if (!editor_.onBoundary(v) || std::find(done.begin(), done.end(), v) != done.end()) continue;
      loops.push_back(borderLoop(editor_, v, kMostEdgesWidened));
      if (loops.back().empty()) return {};
      done.insert(done.end(), loops.back().begin(), loops.back().end());
    }
    return loops;
  }

  bool fill(const Loop& loop, const Testimony& opening, std::vector<std::uint32_t>& added) {
    double spacing = 0.0;
    for (const std::uint32_t v : loop) spacing = std::max(spacing, spacingAt(v));
    const std::vector<Triangle> triangles = fillPolygon(
        editor_, loop, maxChordRatio_ * spacing, [&](const Triangle& t, const Vec3& area) { return faces(t, area); });
    if (triangles.empty() || !isMeasured(ask(triangles), opening)) return false;
    const auto& view = editor_.model().vertexView;
    for (const Triangle& t : triangles) {
      if (!editor_.addTriangle(t, std::max({view[t[0]], view[t[1]], view[t[2]]}))) return false;
      added.push_back(editor_.triangleCount() - 1);
    }
    return true;
  }

  // What takes the place of surface that goes is measured, too: no more is unseen than of the opening.
  [[nodiscard]] static bool isMeasured(const Testimony& filling, const Testimony& opening) {
    return filling.refuted <= kMostRefuted * filling.whole &&
           filling.whole - filling.seen <= opening.whole - opening.seen + kMostRefuted * filling.whole;
  }

  [[nodiscard]] double spacingAt(std::uint32_t v) const { return witnesses_.spacing(editor_.model().vertexView[v]); }

  // Whether a triangle faces the way that was measured at its corners: one at least, and none of them from behind.
  [[nodiscard]] bool faces(const Triangle& t, const Vec3& area) const {
    const double size = area.norm();
    const double spacing = spacingAt(t[0]);
    if (size <= kNegligibleArea * spacing * spacing) return true;
    double best = -size;
    double worst = size;
    for (const std::uint32_t v : t) {
      const double along = area.dot(witnesses_.normal(editor_.model().vertexView[v], editor_.model().vertexSample[v]));
      best = std::max(best, along);
      worst = std::min(worst, along);
    }
    return best >= kLeastFacing * size && worst >= kMostTurned * size;
  }

  ModelEditor& editor_;
  const Witnesses& witnesses_;
  double maxChordRatio_;
};

}  // namespace

ClosedHoles closeMeasuredHoles(ModelEditor& editor, const Witnesses& witnesses, const ZipperOptions& options,
                               const Progress& progress) {
  HoleMender mender(editor, witnesses, options);
  ClosedHoles result;
  std::vector<std::uint8_t> tried(editor.vertexCount(), 0);
  for (std::uint32_t v = 0; v < editor.vertexCount(); ++v) {
    if (tried[v] || !editor.onBoundary(v)) continue;
    progress.checkpoint(static_cast<double>(v) / editor.vertexCount());
    const Loop loop = borderLoop(editor, v, kMostEdges);
    for (const std::uint32_t w : loop) tried[w] = 1;
    if (loop.empty()) continue;
    const std::vector<std::uint32_t> touched = mender.close(loop);
    if (touched.empty()) continue;
    ++result.count;
    result.vertices.insert(result.vertices.end(), touched.begin(), touched.end());
  }
  sortUnique(result.vertices);
  return result;
}

}  // namespace vantage
