#include "support/meshes.h"

#include <cmath>
#include <map>

namespace vantage::testing {

Mesh makeGrid(int columns, int rows, double spacing) {
  Mesh mesh;
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) mesh.vertices.emplace_back(c * spacing, r * spacing, 0.0);
  auto at = [&](int r, int c) { return static_cast<std::uint32_t>(r * (columns + 1) + c); };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      mesh.triangles.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
      mesh.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
    }
  }
  return mesh;
}

Mesh makeSphere(double radius, int rings, const Vec3& centre) {
  Mesh mesh;
  const int columns = 2 * rings;
  for (int r = 1; r < rings; ++r) {
    const double polar = kPi * r / rings;
    for (int c = 0; c < columns; ++c) {
      const double azimuth = 2.0 * kPi * c / columns;
      mesh.vertices.push_back(centre + radius * Vec3(std::sin(polar) * std::cos(azimuth),
                                                     std::sin(polar) * std::sin(azimuth), std::cos(polar)));
    }
  }
  const auto north = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(centre + Vec3(0, 0, radius));
  mesh.vertices.push_back(centre - Vec3(0, 0, radius));
  auto at = [&](int r, int c) { return static_cast<std::uint32_t>((r - 1) * columns + c % columns); };
  for (int c = 0; c < columns; ++c) {
    mesh.triangles.push_back({north, at(1, c), at(1, c + 1)});
    mesh.triangles.push_back({north + 1, at(rings - 1, c + 1), at(rings - 1, c)});
    for (int r = 1; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
      mesh.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
    }
  }
  return mesh;
}

Mesh makeBox(const Vec3& min, const Vec3& max, int cells) {
  Mesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> ids;
  auto at = [&](const std::array<int, 3>& g) {
    const auto [it, added] = ids.try_emplace(g, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (added) {
      const Vec3 f = Vec3(g[0], g[1], g[2]) / cells;
      mesh.vertices.push_back(min + f.cwiseProduct(max - min));
    }
    return it->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const int side : {0, cells}) {
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
          auto corner = [&](int du, int dv) {
            std::array<int, 3> g{};
            g[axis] = side;
            g[u] = i + du;
            g[v] = j + dv;
            return at(g);
          };
          const std::uint32_t a = corner(0, 0);
          const std::uint32_t b = corner(1, 0);
          const std::uint32_t c = corner(1, 1);
          const std::uint32_t d = corner(0, 1);
          if (side == cells) {
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
          } else {
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({a, d, c});
          }
        }
      }
    }
  }
  return mesh;
}

Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh mesh = a;
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return mesh;
}

}  // namespace vantage::testing
