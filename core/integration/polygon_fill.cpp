#include "integration/polygon_fill.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vantage {
namespace {

// The border edge that leaves the vertex, or kNoIndex.
std::uint32_t nextOnBorder(const ModelEditor& editor, std::uint32_t vertex) {
  std::uint32_t next = kNoIndex;
  editor.visitTriangles(vertex, [&](std::uint32_t t) {
    const Triangle& v = editor.triangle(t);
    const int k = v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2);
    if (editor.triangleAt(v[(k + 1) % 3], vertex) == kNoIndex) next = v[(k + 1) % 3];
  });
  return next;
}

// Dynamic programming over the stretches of the loop.
class PolygonFill {
 public:
  PolygonFill(const ModelEditor& editor, std::span<const std::uint32_t> loop, double maxChord, const FillTest& mayFill)
      : editor_(editor), loop_(loop), maxChord_(maxChord), mayFill_(mayFill) {}

  [[nodiscard]] std::vector<Triangle> triangles() {
    const std::size_t n = loop_.size();
    cost_.assign(n * n, 0.0);
    apex_.assign(n * n, 0);
    for (std::size_t span = 2; span < n; ++span)
      for (std::size_t i = 0; i + span < n; ++i) solve(i, i + span);
    std::vector<Triangle> result;
    if (cost_[n - 1] < std::numeric_limits<double>::infinity()) collect(0, n - 1, result);
    return result;
  }

 private:
  [[nodiscard]] bool chordAllowed(std::size_t a, std::size_t b) const {
    if (b == a + 1 || (a == 0 && b + 1 == loop_.size()) || std::isinf(maxChord_)) return true;
    return (editor_.position(loop_[a]) - editor_.position(loop_[b])).norm() <= maxChord_ &&
           editor_.triangleAt(loop_[a], loop_[b]) == kNoIndex && editor_.triangleAt(loop_[b], loop_[a]) == kNoIndex;
  }

  void solve(std::size_t i, std::size_t k) {
    const std::size_t n = loop_.size();
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t j = i + 1; j < k && chordAllowed(i, k); ++j) {
      const Triangle t{loop_[i], loop_[j], loop_[k]};
      const Vec3 area = 0.5 * areaVector(editor_.model().mesh, t);
      const double cost = cost_[i * n + j] + cost_[j * n + k] + area.norm();
      if (cost >= best || !mayFill_(t, area)) continue;
      best = cost;
      apex_[i * n + k] = j;
    }
    cost_[i * n + k] = best;
  }

  void collect(std::size_t i, std::size_t k, std::vector<Triangle>& result) const {
    if (k < i + 2) return;
    const std::size_t j = apex_[i * loop_.size() + k];
    result.push_back({loop_[i], loop_[j], loop_[k]});
    collect(i, j, result);
    collect(j, k, result);
  }

  const ModelEditor& editor_;
  std::span<const std::uint32_t> loop_;
  double maxChord_;
  const FillTest& mayFill_;
  std::vector<double> cost_;
  std::vector<std::size_t> apex_;
};

}  // namespace

std::vector<std::uint32_t> borderLoop(const ModelEditor& editor, std::uint32_t vertex, int maxEdges) {
  std::vector<std::uint32_t> loop;
  std::uint32_t at = vertex;
  if (!editor.onBoundary(vertex)) return loop;
  do {
    loop.push_back(at);
    at = nextOnBorder(editor, at);
    if (at == kNoIndex || loop.size() > static_cast<std::size_t>(maxEdges)) return {};
  } while (at != vertex);
  if (loop.size() < 3) return {};
  std::reverse(loop.begin(), loop.end());
  return loop;
}

std::vector<Triangle> fillPolygon(const ModelEditor& editor, std::span<const std::uint32_t> loop, double maxChord,
                                  const FillTest& mayFill) {
  return PolygonFill(editor, loop, maxChord, mayFill).triangles();
}

}  // namespace vantage
