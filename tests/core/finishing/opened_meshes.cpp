#include "opened_meshes.h"

#include <cmath>

#include "support/meshes.h"

namespace vantage::testing {

Mesh without(const Mesh& mesh, const std::function<bool(const Vec3&)>& region) {
  Mesh result;
  result.vertices = mesh.vertices;
  for (const Triangle& t : mesh.triangles)
    if (!region(triangleCentre(mesh, t))) result.triangles.push_back(t);
  return result;
}

Mesh openedSphere(double above) {
  return without(makeSphere(20.0, 60), [&](const Vec3& p) { return p.z() > above; });
}

Mesh tube() {
  constexpr int kAround = 60;
  constexpr int kUp = 30;
  Mesh mesh;
  for (int row = 0; row <= kUp; ++row)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * kPi * i / kAround;
      mesh.vertices.emplace_back(10.0 * std::cos(angle), 10.0 * std::sin(angle), row);
    }
  const auto at = [](int row, int i) { return static_cast<std::uint32_t>(row * kAround + i % kAround); };
  for (int row = 0; row < kUp; ++row)
    for (int i = 0; i < kAround; ++i) {
      mesh.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
      mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
    }
  return mesh;
}

}  // namespace vantage::testing
