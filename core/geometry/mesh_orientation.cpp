#include "geometry/mesh_orientation.h"

#include <algorithm>
#include <vector>

namespace vantage {
namespace {

constexpr double kShortBoundary = 0.1;

// Across the k-th edge of a triangle: the other triangle, and whether the two disagree as they are.
struct Link {
  std::uint32_t triangle = kNoIndex;
  bool disagrees = false;
};

struct EdgeUse {
  std::uint64_t key;
  std::uint32_t corner;  // 3 * triangle + k
};

std::vector<Link> linkTriangles(const Mesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint64_t a = mesh.triangles[t][k];
      const std::uint64_t b = mesh.triangles[t][(k + 1) % 3];
      uses.push_back({std::min(a, b) << 32 | std::max(a, b), 3 * t + k});
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const EdgeUse& a, const EdgeUse& b) { return a.key != b.key ? a.key < b.key : a.corner < b.corner; });
  std::vector<Link> links(uses.size());
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i + 1;
    while (end < uses.size() && uses[end].key == uses[i].key) ++end;
    if (end - i == 2) {
      const std::uint32_t a = uses[i].corner;
      const std::uint32_t b = uses[i + 1].corner;
      const bool same = mesh.triangles[a / 3][a % 3] == mesh.triangles[b / 3][b % 3];
      links[a] = {b / 3, same};
      links[b] = {a / 3, same};
    }
    i = end;
  }
  return links;
}

// One piece of the surface, grown from its first triangle, and which of its triangles must be turned to agree with
// that.
class Piece {
 public:
  Piece(const Mesh& mesh, const std::vector<Link>& links) : mesh_(mesh), links_(links) {}

  // turned: -1 for triangles that belong to no piece yet.
  void grow(std::uint32_t seed, std::vector<std::int8_t>& turned) {
    members_.assign(1, seed);
    turned[seed] = 0;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const Link& link = links_[3 * members_[i] + k];
        if (link.triangle == kNoIndex || turned[link.triangle] >= 0) continue;
        turned[link.triangle] = static_cast<std::int8_t>(turned[members_[i]] ^ static_cast<int>(link.disagrees));
        members_.push_back(link.triangle);
      }
    }
  }

  [[nodiscard]] bool mustTurnRound(const std::vector<std::int8_t>& turned) const {
    // Volume about a point of the piece: far from the origin the sum would cancel.
    const Vec3& origin = mesh_.vertices[mesh_.triangles[members_[0]][0]];
    double volume = 0.0;
    double area = 0.0;
    double turnedArea = 0.0;
    double boundary = 0.0;
    for (const std::uint32_t t : members_) {
      const Triangle& corners = mesh_.triangles[t];
      const Vec3 normal = areaVector(mesh_, corners);
      const double sign = turned[t] != 0 ? -1.0 : 1.0;
      volume += sign * normal.dot(mesh_.vertices[corners[0]] - origin);
      area += 0.5 * normal.norm();
      if (turned[t] != 0) turnedArea += 0.5 * normal.norm();
      for (std::uint32_t k = 0; k < 3; ++k)
        if (links_[3 * t + k].triangle == kNoIndex)
          boundary += (mesh_.vertices[corners[k]] - mesh_.vertices[corners[(k + 1) % 3]]).norm();
    }
    const bool closed = boundary * boundary < kShortBoundary * area;
    return closed && volume != 0.0 ? volume < 0.0 : turnedArea > 0.5 * area;
  }

  [[nodiscard]] const std::vector<std::uint32_t>& members() const { return members_; }

 private:
  const Mesh& mesh_;
  const std::vector<Link>& links_;
  std::vector<std::uint32_t> members_;
};

}  // namespace

OrientationResult orientOutward(Mesh& mesh) {
  OrientationResult result;
  const std::vector<Link> links = linkTriangles(mesh);
  std::vector<std::int8_t> turned(mesh.triangles.size(), -1);
  Piece piece(mesh, links);
  for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (turned[seed] >= 0) continue;
    piece.grow(seed, turned);
    if (!piece.mustTurnRound(turned)) continue;
    for (const std::uint32_t t : piece.members()) turned[t] ^= 1;
  }
  for (std::uint32_t corner = 0; corner < links.size(); ++corner) {
    const Link& link = links[corner];
    if (link.triangle == kNoIndex || link.triangle < corner / 3) continue;
    if (link.disagrees != (turned[link.triangle] != turned[corner / 3])) ++result.openSeams;
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (turned[t] != 1) continue;
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    ++result.flippedTriangles;
  }
  return result;
}

}  // namespace vantage
