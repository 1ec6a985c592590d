#include "finishing/patch_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace vantage {
namespace {

constexpr double kLong = 1.4;
// Passes over all edges. Every pass halves what is too long, and a patch gets no finer than 2^-30 of its size.
constexpr int kMostSplitPasses = 60;
constexpr int kTurnsPerSplit = 4;
constexpr int kMostTurnPasses = 40;
// Rounds in which inner vertices move amid their neighbours and edges are turned: splitting leaves them uneven.
constexpr int kEvenings = 5;
// An edge turns only where that helps by more than rounding.
constexpr double kAngleSlack = 1e-9;

// An edge inside of the patch with its two triangles: `corner` is 3 t + k for the edge from vertex k to k + 1 of t.
struct InnerEdge {
  std::uint32_t a;
  std::uint32_t b;
  std::uint32_t corner;
  std::uint32_t opposite;
  double squared;
};

std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

std::vector<InnerEdge> innerEdges(const Mesh& patch) {
  struct Use {
    std::uint64_t key;
    std::uint32_t corner;
  };
  std::vector<Use> uses;
  uses.reserve(3 * patch.triangles.size());
  for (std::uint32_t t = 0; t < patch.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      uses.push_back({keyOf(patch.triangles[t][k], patch.triangles[t][(k + 1) % 3]), 3 * t + k});
  std::sort(uses.begin(), uses.end(),
            [](const Use& x, const Use& y) { return x.key != y.key ? x.key < y.key : x.corner < y.corner; });
  std::vector<InnerEdge> edges;
  for (std::size_t i = 0; i + 1 < uses.size(); ++i) {
    if (uses[i].key != uses[i + 1].key) continue;
    const Triangle& t = patch.triangles[uses[i].corner / 3];
    const std::uint32_t a = t[uses[i].corner % 3];
    const std::uint32_t b = t[(uses[i].corner + 1) % 3];
    edges.push_back({a, b, uses[i].corner, uses[i + 1].corner, (patch.vertices[a] - patch.vertices[b]).squaredNorm()});
  }
  return edges;
}

std::uint32_t apex(const Mesh& patch, std::uint32_t corner) {
  return patch.triangles[corner / 3][(corner % 3 + 2) % 3];
}

double angleAt(const Vec3& p, const Vec3& a, const Vec3& b) {
  return std::atan2((a - p).cross(b - p).norm(), (a - p).dot(b - p));
}

// One pass of changes that do not touch each other's triangles, in a fixed order. @return how many were made
template <typename Change>
std::size_t changeApart(Mesh& patch, const std::vector<InnerEdge>& edges, const Change& change) {
  std::vector<std::uint8_t> touched(patch.triangles.size(), 0);
  std::size_t changes = 0;
  for (const InnerEdge& edge : edges) {
    const std::uint32_t one = edge.corner / 3;
    const std::uint32_t other = edge.opposite / 3;
    if (touched[one] != 0 || touched[other] != 0 || !change(edge)) continue;
    touched[one] = touched[other] = 1;
    ++changes;
  }
  return changes;
}

std::size_t splitLong(Mesh& patch, double limit) {
  std::vector<InnerEdge> edges = innerEdges(patch);
  std::erase_if(edges, [&](const InnerEdge& e) { return e.squared <= limit * limit; });
  std::stable_sort(edges.begin(), edges.end(),
                   [](const InnerEdge& x, const InnerEdge& y) { return x.squared > y.squared; });
  return changeApart(patch, edges, [&](const InnerEdge& e) {
    const auto middle = static_cast<std::uint32_t>(patch.vertices.size());
    const std::uint32_t c = apex(patch, e.corner);
    const std::uint32_t d = apex(patch, e.opposite);
    patch.vertices.emplace_back(0.5 * (patch.vertices[e.a] + patch.vertices[e.b]));
    patch.triangles[e.corner / 3] = {e.a, middle, c};
    patch.triangles[e.opposite / 3] = {e.b, middle, d};
    patch.triangles.push_back({middle, e.b, c});
    patch.triangles.push_back({middle, e.a, d});
    return true;
  });
}

// Whether the diagonal of two triangles should be the other one, and may be.
class EdgeTurner {
 public:
  EdgeTurner(Mesh& patch, const JoinedOutside& joined, const std::vector<InnerEdge>& edges)
      : patch_(patch), joined_(joined), edges_(edges) {
    for (const Triangle& t : patch.triangles)
      for (int k = 0; k < 3; ++k) known_.insert(keyOf(t[k], t[(k + 1) % 3]));
  }

  std::size_t pass() {
    return changeApart(patch_, edges_, [&](const InnerEdge& e) { return turn(e); });
  }

 private:
  bool turn(const InnerEdge& e) {
    const std::uint32_t c = apex(patch_, e.corner);
    const std::uint32_t d = apex(patch_, e.opposite);
    const Vec3& a = patch_.vertices[e.a];
    const Vec3& b = patch_.vertices[e.b];
    const Vec3& pc = patch_.vertices[c];
    const Vec3& pd = patch_.vertices[d];
    if (angleAt(pc, a, b) + angleAt(pd, a, b) <= kPi + kAngleSlack) return false;
    if (known_.contains(keyOf(c, d)) || (joined_ && joined_(c, d))) return false;
    // Neither of the new triangles may fold over.
    const Vec3 before = (b - a).cross(pc - a) + (a - b).cross(pd - b);
    if ((pd - pc).cross(b - pc).dot(before) <= 0.0 || (pc - pd).cross(a - pd).dot(before) <= 0.0) return false;
    patch_.triangles[e.corner / 3] = {c, d, e.b};
    patch_.triangles[e.opposite / 3] = {d, c, e.a};
    known_.erase(keyOf(e.a, e.b));
    known_.insert(keyOf(c, d));
    return true;
  }

  Mesh& patch_;
  const JoinedOutside& joined_;
  const std::vector<InnerEdge>& edges_;
  std::unordered_set<std::uint64_t> known_;
};

bool turnPass(Mesh& patch, const JoinedOutside& joined) {
  const std::vector<InnerEdge> edges = innerEdges(patch);
  return EdgeTurner(patch, joined, edges).pass() > 0;
}

// Moves vertices that are not on the border amid their neighbours.
void even(Mesh& patch, std::size_t border) {
  std::vector<Vec3> sum(patch.vertices.size(), Vec3::Zero());
  std::vector<int> count(patch.vertices.size(), 0);
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      sum[t[k]] += patch.vertices[t[(k + 1) % 3]] + patch.vertices[t[(k + 2) % 3]];
      count[t[k]] += 2;
    }
  }
  for (std::size_t v = border; v < patch.vertices.size(); ++v)
    if (count[v] > 0) patch.vertices[v] = sum[v] / count[v];
}

}  // namespace

void turnEdges(Mesh& patch, const JoinedOutside& joined, const Progress& progress) {
  for (int pass = 0; pass < kMostTurnPasses; ++pass) {
    progress.checkpoint(static_cast<double>(pass) / kMostTurnPasses);
    if (!turnPass(patch, joined)) return;
  }
}

void refinePatch(Mesh& patch, double edgeLength, const JoinedOutside& joined, const Progress& progress) {
  const std::size_t border = patch.vertices.size();
  turnEdges(patch, joined, progress.part(0.0, 0.1));
  for (int pass = 0; pass < kMostSplitPasses; ++pass) {
    progress.checkpoint(0.1 + 0.8 * static_cast<double>(pass) / kMostSplitPasses);
    if (splitLong(patch, kLong * edgeLength) == 0) break;
    for (int turns = 0; turns < kTurnsPerSplit; ++turns)
      if (!turnPass(patch, joined)) break;
  }
  for (int round = 0; round < kEvenings; ++round) {
    even(patch, border);
    turnEdges(patch, joined, progress.part(0.9, 1.0));
  }
}

}  // namespace vantage
