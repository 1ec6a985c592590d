#include "support/sample_objects/polygonize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/mesh_topology.h"

namespace vantage::testing {
namespace {

using Cell = std::array<int, 3>;

// The cube as six tetrahedra along its diagonal: every order of the three axes is a way from corner 000 to corner 111.
constexpr std::array<std::array<int, 3>, 6> kOrders{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

class Marching {
 public:
  Marching(const std::function<double(const Vec3&)>& field, const BoundingBox& box, double spacing)
      : origin_(box.min), spacing_(spacing) {
    for (int k = 0; k < 3; ++k)
      count_[static_cast<std::size_t>(k)] = static_cast<int>(std::ceil(box.size()[k] / spacing)) + 1;
    values_.resize(static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
                   static_cast<std::size_t>(count_[2]));
    for (int z = 0; z < count_[2]; ++z)
      for (int y = 0; y < count_[1]; ++y)
        for (int x = 0; x < count_[0]; ++x) values_[index({x, y, z})] = field(place({x, y, z}));
    // One vertex at most on each of the seven edges that leave a grid point in positive directions.
    vertexOnEdge_.assign(8 * values_.size(), kNoIndex);
  }

  Mesh run() {
    for (int z = 0; z + 1 < count_[2]; ++z)
      for (int y = 0; y + 1 < count_[1]; ++y)
        for (int x = 0; x + 1 < count_[0]; ++x) marchCell({x, y, z});
    return std::move(mesh_);
  }

 private:
  std::size_t index(const Cell& c) const {
    return (static_cast<std::size_t>(c[2]) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(c[1])) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(c[0]);
  }
  Vec3 place(const Cell& c) const { return origin_ + spacing_ * Vec3(c[0], c[1], c[2]); }
  bool isInside(const Cell& c) const { return values_[index(c)] < 0.0; }

  void marchCell(const Cell& cell) {
    for (const auto& order : kOrders) {
      std::array<Cell, 4> corner;
      corner.fill(cell);
      for (std::size_t step = 1; step < 4; ++step) {
        corner[step] = corner[step - 1];
        ++corner[step][static_cast<std::size_t>(order[step - 1])];
      }
      marchTetrahedron(corner);
    }
  }

  void marchTetrahedron(std::array<Cell, 4> corner) {
    const auto outside =
        std::stable_partition(corner.begin(), corner.end(), [this](const Cell& c) { return isInside(c); });
    const auto inside = outside - corner.begin();
    if (inside == 0 || inside == 4) return;
    if (inside == 1) {
      addTriangle({vertex(corner[0], corner[1]), vertex(corner[0], corner[2]), vertex(corner[0], corner[3])}, corner[0],
                  corner[1]);
    } else if (inside == 3) {
      addTriangle({vertex(corner[3], corner[0]), vertex(corner[3], corner[1]), vertex(corner[3], corner[2])}, corner[0],
                  corner[3]);
    } else {
      const std::uint32_t a = vertex(corner[0], corner[2]);
      const std::uint32_t b = vertex(corner[0], corner[3]);
      const std::uint32_t c = vertex(corner[1], corner[3]);
      const std::uint32_t d = vertex(corner[1], corner[2]);
      const bool turned = facesAway({a, b, c}, corner[0], corner[2]);
      push({a, b, c}, turned);
      push({a, c, d}, turned);
    }
  }

  // Where the field is zero between two grid points; a little away from both, so that no triangle loses its area.
  std::uint32_t vertex(const Cell& a, const Cell& b) {
    const bool forward = a[0] <= b[0] && a[1] <= b[1] && a[2] <= b[2];
    const Cell& low = forward ? a : b;
    const Cell& high = forward ? b : a;
    const int direction = (high[0] - low[0]) + 2 * (high[1] - low[1]) + 4 * (high[2] - low[2]);
    std::uint32_t& slot = vertexOnEdge_[8 * index(low) + static_cast<std::size_t>(direction)];
    if (slot == kNoIndex) {
      const double from = values_[index(low)];
      const double to = values_[index(high)];
      const double t = std::clamp(from / (from - to), 0.01, 0.99);
      slot = static_cast<std::uint32_t>(mesh_.vertices.size());
      mesh_.vertices.push_back((1.0 - t) * place(low) + t * place(high));
    }
    return slot;
  }

  bool facesAway(const Triangle& t, const Cell& inside, const Cell& outside) const {
    return areaVector(mesh_, t).dot(place(outside) - place(inside)) < 0.0;
  }
  void addTriangle(const Triangle& t, const Cell& inside, const Cell& outside) {
    push(t, facesAway(t, inside, outside));
  }
  void push(const Triangle& t, bool turned) { mesh_.triangles.push_back(turned ? Triangle{t[0], t[2], t[1]} : t); }

  Vec3 origin_;
  double spacing_;
  Cell count_{};
  std::vector<double> values_;
  std::vector<std::uint32_t> vertexOnEdge_;
  Mesh mesh_;
};

// The longest side of a triangle, and how far the opposite corner is from it.
struct LongestSide {
  int k = 0;
  double height = 0.0;
};

LongestSide longestSide(const Mesh& mesh, const Triangle& t) {
  LongestSide side;
  double longest = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double length = (mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]]).norm();
    if (length <= longest) continue;
    longest = length;
    side.k = k;
  }
  side.height = longest > 0.0 ? areaVector(mesh, t).norm() / longest : 0.0;
  return side;
}

bool areLinked(const MeshTopology& topology, const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  const auto around = topology.trianglesOf(a);
  return std::any_of(around.begin(), around.end(), [&](std::uint32_t t) {
    return std::find(mesh.triangles[t].begin(), mesh.triangles[t].end(), b) != mesh.triangles[t].end();
  });
}

// One round; triangles that share an edge with one that was changed wait for the next.
bool flipOnce(Mesh& mesh, double height) {
  const MeshTopology topology(mesh);
  std::vector<std::uint8_t> changed(mesh.triangles.size(), 0);
  bool any = false;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const LongestSide side = longestSide(mesh, mesh.triangles[t]);
    const std::uint32_t other = topology.neighbour(t, side.k);
    if (side.height > height || changed[t] != 0 || other == kNoIndex || changed[other] != 0) continue;
    const std::uint32_t a = mesh.triangles[t][side.k];
    const std::uint32_t b = mesh.triangles[t][(side.k + 1) % 3];
    const std::uint32_t tip = mesh.triangles[t][(side.k + 2) % 3];
    std::uint32_t beyond = kNoIndex;
    for (const std::uint32_t v : mesh.triangles[other])
      if (v != a && v != b) beyond = v;
    if (beyond == kNoIndex || areLinked(topology, mesh, tip, beyond)) continue;
    mesh.triangles[t] = {a, beyond, tip};
    mesh.triangles[other] = {beyond, b, tip};
    changed[t] = changed[other] = 1;
    any = true;
  }
  return any;
}

}  // namespace

void flipFlatTriangles(Mesh& mesh, double height) {
  constexpr int kMostRounds = 20;
  for (int round = 0; round < kMostRounds && flipOnce(mesh, height); ++round) {
  }
}

Mesh polygonize(const std::function<double(const Vec3&)>& field, const BoundingBox& box, double spacing) {
  return Marching(field, box, spacing).run();
}

}  // namespace vantage::testing
