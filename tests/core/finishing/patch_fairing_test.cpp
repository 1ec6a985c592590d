#include "finishing/patch_fairing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/meshes.h"

namespace vantage {
namespace {

// A square sheet of which the middle may move, the two rings outside of the seam are the surface around it.
FairedPart sheet(const std::function<double(double, double)>& height) {
  constexpr int kCells = 16;
  FairedPart part;
  part.mesh = testing::makeGrid(kCells, kCells, 1.0);
  for (Vec3& v : part.mesh.vertices) {
    const double inside = std::min({v.x(), v.y(), kCells - v.x(), kCells - v.y()});
    part.mayMove.push_back(inside > 2.5 ? 1 : 0);
    part.onSeam.push_back(inside > 1.5 && inside < 2.5 ? 1 : 0);
    v.z() = inside > 2.5 ? 5.0 : height(v.x(), v.y());
  }
  return part;
}

TEST(PatchFairing, ContinuesAPlaneAsAPlaneWithAnyReach) {
  for (const double reach : {0.0, 3.0, 100.0}) {
    FairedPart part = sheet([](double x, double y) { return 0.3 * x - 0.2 * y + 1.0; });
    ASSERT_TRUE(fairPatch(part, reach));
    // Vertices also move within the plane: the border of a grid has other neighbours than its inside.
    for (const Vec3& v : part.mesh.vertices) EXPECT_NEAR(v.z(), 0.3 * v.x() - 0.2 * v.y() + 1.0, 1e-6) << reach;
  }
}

TEST(PatchFairing, AThinPlateGoesOnWhereASoapFilmCutsShort) {
  // A dome: its top is 4 mm above the seam's corners.
  const auto dome = [](double x, double y) { return 8.0 - 0.06 * ((x - 8) * (x - 8) + (y - 8) * (y - 8)); };
  FairedPart plate = sheet(dome);
  FairedPart film = sheet(dome);
  // The cliff that they begin with has other angles than the dome.
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(fairPatch(plate, 100.0));
    ASSERT_TRUE(fairPatch(film, 0.0));
  }
  const std::size_t middle = 8 * 17 + 8;
  EXPECT_NEAR(plate.mesh.vertices[middle].z(), 8.0, 0.4);
  EXPECT_LT(film.mesh.vertices[middle].z(), 6.5);
  for (std::size_t v = 0; v < plate.mesh.vertices.size(); ++v)
    if (plate.mayMove[v] == 0) {
      EXPECT_EQ(plate.mesh.vertices[v], film.mesh.vertices[v]);
    }
}

TEST(PatchFairing, WithNothingToMoveNothingMoves) {
  FairedPart part = sheet([](double, double) { return 0.0; });
  part.mayMove.assign(part.mayMove.size(), 0);
  const Mesh before = part.mesh;
  EXPECT_TRUE(fairPatch(part, 10.0));
  EXPECT_EQ(part.mesh.vertices, before.vertices);
}

}  // namespace
}  // namespace vantage
