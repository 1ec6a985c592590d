#include "measuring/plane_section.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace vantage {
namespace {

constexpr std::size_t kTrianglesPerCheckpoint = 65536;

// The plane cuts an edge of the mesh; lines go from cut edge to cut edge.
using EdgeKey = std::uint64_t;

EdgeKey keyOf(std::uint32_t a, std::uint32_t b) {
  return static_cast<EdgeKey>(std::min(a, b)) << 32 | std::max(a, b);
}

struct Piece {
  EdgeKey from;
  EdgeKey to;
};

class Cutter {
 public:
  Cutter(const Mesh& mesh, const SurfacePlane& plane) : mesh_(mesh) {
    height_.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) height_.push_back(plane.distance(v));
  }

  // The piece of a triangle, so that the material is on its left seen from the front.
  void cut(const Triangle& t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t alone = t[k];
      const std::uint32_t next = t[(k + 1) % 3];
      const std::uint32_t last = t[(k + 2) % 3];
      if (before(alone) == before(next) || before(alone) == before(last)) continue;
      const EdgeKey out = keyOf(alone, next);
      const EdgeKey in = keyOf(last, alone);
      pieces_.push_back(before(alone) ? Piece{out, in} : Piece{in, out});
      return;
    }
  }

  [[nodiscard]] std::vector<SectionLine> lines() const {
    std::unordered_multimap<EdgeKey, std::size_t> leaving;
    std::unordered_map<EdgeKey, int> arriving;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      leaving.emplace(pieces_[i].from, i);
      ++arriving[pieces_[i].to];
    }
    std::vector<std::uint8_t> passed(pieces_.size(), 0);
    std::vector<SectionLine> lines;
    // Lines with ends first, from where nothing arrives.
    for (const bool open : {true, false})
      for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (passed[i] == 0 && (!open || !arriving.contains(pieces_[i].from)))
          lines.push_back(follow(i, leaving, passed));
    return lines;
  }

 private:
  [[nodiscard]] bool before(std::uint32_t v) const { return height_[v] >= 0.0; }

  [[nodiscard]] Vec3 pointOf(EdgeKey key) const {
    const auto a = static_cast<std::uint32_t>(key >> 32);
    const auto b = static_cast<std::uint32_t>(key & 0xffffffffU);
    const double share = height_[a] / (height_[a] - height_[b]);
    return mesh_.vertices[a] + share * (mesh_.vertices[b] - mesh_.vertices[a]);
  }

  [[nodiscard]] SectionLine follow(std::size_t first, const std::unordered_multimap<EdgeKey, std::size_t>& leaving,
                                   std::vector<std::uint8_t>& passed) const {
    SectionLine line;
    line.points.push_back(pointOf(pieces_[first].from));
    std::size_t at = first;
    for (;;) {
      passed[at] = 1;
      const EdgeKey to = pieces_[at].to;
      if (to == pieces_[first].from) {
        line.closed = true;
        break;
      }
      line.points.push_back(pointOf(to));
      // Of several the lowest, whatever their order in the table.
      std::size_t next = pieces_.size();
      const auto range = leaving.equal_range(to);
      for (auto it = range.first; it != range.second; ++it)
        if (passed[it->second] == 0) next = std::min(next, it->second);
      if (next == pieces_.size()) break;
      at = next;
    }
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
      line.length += (line.points[i + 1] - line.points[i]).norm();
    if (line.closed) line.length += (line.points.front() - line.points.back()).norm();
    return line;
  }

  const Mesh& mesh_;
  std::vector<double> height_;
  std::vector<Piece> pieces_;
};

// Of the polygon, counter-clockwise about the normal positive [mm^2].
double signedArea(const SectionLine& line, const Vec3& normal) {
  Vec3 sum = Vec3::Zero();
  const Vec3& origin = line.points.front();
  for (std::size_t i = 1; i + 1 < line.points.size(); ++i)
    sum += (line.points[i] - origin).cross(line.points[i + 1] - origin);
  return 0.5 * sum.dot(normal);
}

}  // namespace

PlaneSection sectionOf(const Mesh& mesh, const SurfacePlane& plane, const Progress& progress) {
  progress.checkpoint(0.0);
  validate(mesh);
  Cutter cutter(mesh, plane);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % kTrianglesPerCheckpoint == 0)
      progress.checkpoint(0.8 * static_cast<double>(t) / static_cast<double>(mesh.triangles.size()));
    cutter.cut(mesh.triangles[t]);
  }
  PlaneSection section;
  section.lines = cutter.lines();
  double area = 0.0;
  bool closed = !section.lines.empty();
  for (const SectionLine& line : section.lines) {
    section.length += line.length;
    closed = closed && line.closed;
    area += signedArea(line, plane.normal);
  }
  if (closed) section.area = area;
  progress.checkpoint(1.0);
  return section;
}

}  // namespace vantage
