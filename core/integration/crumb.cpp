#include "integration/crumb.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace vantage {
namespace {

constexpr int kTrustedRings = 4;
constexpr double kSmallestShare = 1e-3;  // of the largest piece's area

// The pieces of a model, numbered, and what decides over them.
class Pieces {
 public:
  explicit Pieces(const ModelEditor& editor) : editor_(editor), pieceOf_(editor.vertexCount(), kNoIndex) {
    for (std::uint32_t t = 0; t < editor.triangleCount(); ++t) {
      if (!editor.alive(t)) continue;
      if (pieceOf(t) == kNoIndex) flood(editor.triangle(t)[0]);
      area_[pieceOf(t)] += triangleArea(editor.model().mesh, editor.triangle(t));
    }
    for (const double area : area_) largest_ = std::max(largest_, area);
    measureDepth();
  }

  [[nodiscard]] bool isCrumb(std::uint32_t triangle) const {
    const std::uint32_t piece = pieceOf(triangle);
    return depth_[piece] < kTrustedRings && area_[piece] < kSmallestShare * largest_;
  }

 private:
  [[nodiscard]] std::uint32_t pieceOf(std::uint32_t triangle) const { return pieceOf_[editor_.triangle(triangle)[0]]; }

  void flood(std::uint32_t start) {
    const auto piece = static_cast<std::uint32_t>(area_.size());
    area_.push_back(0.0);
    std::vector<std::uint32_t> stack{start};
    pieceOf_[start] = piece;
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      visitNeighbours(v, [&](std::uint32_t w) {
        if (pieceOf_[w] != kNoIndex) return;
        pieceOf_[w] = piece;
        stack.push_back(w);
      });
    }
  }

  // Edges from the border to the vertex farthest inside, counted up to kTrustedRings.
  void measureDepth() {
    std::vector<int> rings(pieceOf_.size(), kTrustedRings);
    std::vector<std::uint32_t> queue;
    for (std::uint32_t v = 0; v < rings.size(); ++v)
      if (editor_.onBoundary(v)) {
        rings[v] = 0;
        queue.push_back(v);
      }
    for (std::size_t i = 0; i < queue.size(); ++i)
      visitNeighbours(queue[i], [&](std::uint32_t w) {
        if (rings[w] <= rings[queue[i]] + 1) return;
        rings[w] = rings[queue[i]] + 1;
        queue.push_back(w);
      });
    depth_.assign(area_.size(), 0);
    for (std::uint32_t v = 0; v < rings.size(); ++v)
      if (pieceOf_[v] != kNoIndex) depth_[pieceOf_[v]] = std::max(depth_[pieceOf_[v]], rings[v]);
  }

  template <typename Visit>
  void visitNeighbours(std::uint32_t vertex, const Visit& visit) const {
    editor_.visitTriangles(vertex, [&](std::uint32_t t) {
      for (const std::uint32_t w : editor_.triangle(t)) visit(w);
    });
  }

  const ModelEditor& editor_;
  std::vector<std::uint32_t> pieceOf_;  // per vertex
  std::vector<double> area_;
  std::vector<int> depth_;
  double largest_ = 0.0;
};

}  // namespace

std::size_t removeCrumbs(ModelEditor& editor) {
  const Pieces pieces(editor);
  std::size_t removed = 0;
  for (std::uint32_t t = 0; t < editor.triangleCount(); ++t) {
    if (!editor.alive(t) || !pieces.isCrumb(t)) continue;
    editor.removeTriangle(t);
    ++removed;
  }
  return removed;
}

}  // namespace vantage
