#include "forecast/level_surface.h"

#include <array>
#include <cstdint>
#include <utility>

namespace vantage {
namespace {

using Place = std::array<int, 3>;

class SurfaceNets {
 public:
  explicit SurfaceNets(const FreeSpace& space)
      : space_(space), grid_(space.grid), vertexOf_(space.grid.size(), kNoIndex) {}

  // The face between a voxel and its neighbour along an axis, where there is one.
  void addFace(const Place& place, std::size_t axis) {
    Place next = place;
    if (++next[axis] >= grid_.counts[axis]) return;
    const std::size_t a = at(place);
    const std::size_t b = at(next);
    const bool aInside = space_.level[a] < 0.0F;
    if (aInside == (space_.level[b] < 0.0F)) return;
    if (space_.state[a] == VoxelState::Surface && space_.state[b] == VoxelState::Surface) return;
    std::array<std::uint32_t, 4> corners{};
    constexpr std::array<std::array<int, 2>, 4> kAround{{{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}};
    for (std::size_t k = 0; k < 4; ++k) {
      Place cell = place;
      cell[(axis + 1) % 3] += kAround[k][0];
      cell[(axis + 2) % 3] += kAround[k][1];
      corners[k] = vertexIn(cell);
      if (corners[k] == kNoIndex) return;
    }
    if (!aInside) std::swap(corners[1], corners[3]);
    append(corners, aInside ? a : b);
  }

  LevelSurface take() { return std::move(surface_); }

 private:
  [[nodiscard]] std::size_t at(const Place& p) const { return grid_.index(p[0], p[1], p[2]); }

  // The vertex of the cell of which the voxel is the lowest corner.
  std::uint32_t vertexIn(const Place& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (cell[axis] < 0 || cell[axis] + 1 >= grid_.counts[axis]) return kNoIndex;
    std::uint32_t& vertex = vertexOf_[at(cell)];
    if (vertex != kNoIndex) return vertex;
    Vec3 sum = Vec3::Zero();
    int crossings = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 4; ++k) {
        Place from = cell;
        from[(axis + 1) % 3] += k % 2;
        from[(axis + 2) % 3] += k / 2;
        Place to = from;
        ++to[axis];
        const auto a = static_cast<double>(space_.level[at(from)]);
        const auto b = static_cast<double>(space_.level[at(to)]);
        if ((a < 0.0) == (b < 0.0)) continue;
        const double t = a / (a - b);
        sum += (1.0 - t) * grid_.centre(from[0], from[1], from[2]) + t * grid_.centre(to[0], to[1], to[2]);
        ++crossings;
      }
    if (crossings == 0) return kNoIndex;
    vertex = static_cast<std::uint32_t>(surface_.mesh.vertices.size());
    surface_.mesh.vertices.emplace_back(sum / crossings);
    return vertex;
  }

  void append(const std::array<std::uint32_t, 4>& c, std::size_t inside) {
    const std::vector<Vec3>& v = surface_.mesh.vertices;
    const Vec3 areas = 0.5 * (v[c[2]] - v[c[0]]).cross(v[c[3]] - v[c[1]]);
    const double area = areas.norm();
    if (!(area > 0.0)) return;
    surface_.faces.push_back({0.25 * (v[c[0]] + v[c[1]] + v[c[2]] + v[c[3]]), areas / area, area, inside});
    surface_.mesh.triangles.push_back({c[0], c[1], c[2]});
    surface_.mesh.triangles.push_back({c[0], c[2], c[3]});
  }

  const FreeSpace& space_;
  const VoxelGrid& grid_;
  std::vector<std::uint32_t> vertexOf_;  // per voxel: of the cell of which it is the lowest corner
  LevelSurface surface_;
};

}  // namespace

LevelSurface levelSurface(const FreeSpace& space) {
  SurfaceNets nets(space);
  for (int z = 0; z < space.grid.counts[2]; ++z)
    for (int y = 0; y < space.grid.counts[1]; ++y)
      for (int x = 0; x < space.grid.counts[0]; ++x)
        for (std::size_t axis = 0; axis < 3; ++axis) nets.addFace({x, y, z}, axis);
  return nets.take();
}

}  // namespace vantage
