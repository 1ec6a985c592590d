#include "finishing/self_crossings.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "geometry/measures.h"

namespace vantage {
namespace {

constexpr std::uint32_t kLeafTriangles = 8;
constexpr std::size_t kGrain = 4096;

double side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  return (b - a).cross(c - a).dot(p - a);
}

// Whether a segment passes through the inside of a triangle.
bool passes(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  const double from = side(t[0], t[1], t[2], p);
  const double to = side(t[0], t[1], t[2], q);
  if (!((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0))) return false;
  const double u = side(p, q, t[0], t[1]);
  const double v = side(p, q, t[1], t[2]);
  const double w = side(p, q, t[2], t[0]);
  return (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
}

std::array<Vec3, 3> cornersOf(const Mesh& mesh, const Triangle& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

// Whether an edge of one triangle that does not end in the other passes through it.
bool edgePasses(const Mesh& mesh, const Triangle& edges, const Triangle& through) {
  const auto shared = [&](std::uint32_t v) { return std::find(through.begin(), through.end(), v) != through.end(); };
  const std::array<Vec3, 3> corners = cornersOf(mesh, through);
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t a = edges[k];
    const std::uint32_t b = edges[(k + 1) % 3];
    if (!shared(a) && !shared(b) && passes(mesh.vertices[a], mesh.vertices[b], corners)) return true;
  }
  return false;
}

bool cross(const Mesh& mesh, const Triangle& a, const Triangle& b) {
  int shared = 0;
  for (const std::uint32_t v : a) shared += std::find(b.begin(), b.end(), v) != b.end() ? 1 : 0;
  return shared < 2 && (edgePasses(mesh, a, b) || edgePasses(mesh, b, a));
}

BoundingBox boxOf(const Mesh& mesh, const Triangle& t) {
  BoundingBox box{mesh.vertices[t[0]], mesh.vertices[t[0]]};
  box.extend(mesh.vertices[t[1]]);
  box.extend(mesh.vertices[t[2]]);
  return box;
}

bool meet(const BoundingBox& a, const BoundingBox& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

// Boxes around boxes: node i has the children left and left + 1, or is a leaf of some triangles.
class BoxTree {
 public:
  explicit BoxTree(const Mesh& mesh) : order_(mesh.triangles.size()), boxes_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    for (std::size_t t = 0; t < boxes_.size(); ++t) boxes_[t] = boxOf(mesh, mesh.triangles[t]);
    nodes_.push_back({{}, 0, 0, static_cast<std::uint32_t>(order_.size())});
    for (std::size_t i = 0; i < nodes_.size(); ++i) grow(i);
  }

  // Calls visit(t) for the triangles whose boxes meet that of another.
  template <typename Visit>
  void near(std::uint32_t triangle, const Visit& visit) const {
    const BoundingBox& box = boxes_[triangle];
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (!meet(node.box, box)) continue;
      if (node.left != 0) {
        open.push_back(node.left);
        open.push_back(node.left + 1);
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i)
        if (meet(boxes_[order_[i]], box)) visit(order_[i]);
    }
  }

 private:
  struct Node {
    BoundingBox box;
    std::uint32_t left;  // 0: a leaf
    std::uint32_t begin;
    std::uint32_t end;
  };

  void grow(std::size_t i) {
    const std::uint32_t begin = nodes_[i].begin;
    const std::uint32_t end = nodes_[i].end;
    if (begin == end) return;
    BoundingBox box = boxes_[order_[begin]];
    for (std::uint32_t k = begin; k < end; ++k) {
      box.extend(boxes_[order_[k]].min);
      box.extend(boxes_[order_[k]].max);
    }
    nodes_[i].box = box;
    if (end - begin <= kLeafTriangles) return;
    int axis = 0;
    box.size().maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::uint32_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
      const double x = boxes_[a].centre()[axis];
      const double y = boxes_[b].centre()[axis];
      return x != y ? x < y : a < b;
    });
    nodes_[i].left = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, 0, begin, middle});
    nodes_.push_back({{}, 0, middle, end});
  }

  std::vector<std::uint32_t> order_;
  std::vector<BoundingBox> boxes_;
  std::vector<Node> nodes_;
};

}  // namespace

std::size_t countCrossings(const Mesh& mesh, const Progress& progress) {
  const std::vector<std::size_t> crossings = crossingsOf(mesh, 0, progress);
  return std::accumulate(crossings.begin(), crossings.end(), std::size_t{0}) / 2;
}

std::vector<std::size_t> crossingsOf(const Mesh& mesh, std::uint32_t first, const Progress& progress) {
  validate(mesh);
  progress.checkpoint(0.0);
  if (first >= mesh.triangles.size()) return {};
  const BoxTree tree(mesh);
  progress.checkpoint(0.2);
  std::vector<std::size_t> crossings(mesh.triangles.size() - first, 0);
  parallelChunks(crossings.size(), kGrain, progress.part(0.2, 1.0), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto t = static_cast<std::uint32_t>(first + i);
      tree.near(t, [&](std::uint32_t other) {
        if (other != t && cross(mesh, mesh.triangles[t], mesh.triangles[other])) ++crossings[i];
      });
    }
  });
  return crossings;
}

}  // namespace vantage
