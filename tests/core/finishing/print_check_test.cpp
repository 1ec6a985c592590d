#include "finishing/print_check.h"

#include <gtest/gtest.h>

#include "opened_meshes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeBox;
using testing::makeSphere;

TEST(PrintCheck, AClosedBoxCanBePrinted) {
  const PrintCheck check = checkForPrint(makeBox(Vec3(0, 0, 0), Vec3(2, 3, 4), 3));
  EXPECT_TRUE(check.printable());
  ASSERT_TRUE(check.closed());
  EXPECT_NEAR(*check.volume, 24.0, 1e-9);
  EXPECT_EQ(check.pieces, 1U);
}

TEST(PrintCheck, NamesEveryFault) {
  EXPECT_EQ(checkForPrint({}).faults, (std::vector{PrintFault::Empty}));
  const PrintCheck open = checkForPrint(testing::tube());
  EXPECT_EQ(open.faults, (std::vector{PrintFault::Open}));
  EXPECT_EQ(open.openings, 2U);
  EXPECT_NEAR(open.widestOpening, 20.0, 1e-9);
  EXPECT_FALSE(open.closed());
  const Mesh box = makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_EQ(checkForPrint(joined(box, makeBox(Vec3(3, 0, 0), Vec3(4, 1, 1)))).faults,
            (std::vector{PrintFault::Pieces}));
  EXPECT_EQ(checkForPrint(joined(box, makeBox(Vec3(0.5, 0.2, 0.3), Vec3(4, 0.7, 0.8)))).faults,
            (std::vector{PrintFault::Crossings, PrintFault::Pieces}));
  Mesh inward = box;
  for (Triangle& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(checkForPrint(inward).faults, (std::vector{PrintFault::Inward}));
  Mesh turned = box;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_EQ(checkForPrint(turned).faults.front(), PrintFault::NonManifold);
  // Two boxes that share one corner.
  Mesh touching = joined(box, makeBox(Vec3(1, 1, 1), Vec3(2, 2, 2)));
  std::uint32_t top = 0;
  for (std::uint32_t v = 0; v < touching.vertices.size(); ++v)
    if (touching.vertices[v] == Vec3(1, 1, 1) && v < box.vertices.size()) top = v;
  for (Triangle& t : touching.triangles)
    for (std::uint32_t& v : t)
      if (touching.vertices[v] == Vec3(1, 1, 1)) v = top;
  EXPECT_EQ(checkForPrint(touching).faults, (std::vector{PrintFault::BowTies, PrintFault::Pieces}));
  const RepairedSurface apart = repairForPrint(touching);
  EXPECT_EQ(apart.split, 1U);
  EXPECT_EQ(checkForPrint(apart.mesh).faults, (std::vector{PrintFault::Pieces}));
}

TEST(PrintCheck, RepairTurnsSplitsAndDropsButInventsNothing) {
  Mesh mesh = makeSphere(10.0, 10);
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  mesh.triangles.push_back({1, 1, 2});
  const RepairedSurface repaired = repairForPrint(mesh);
  EXPECT_EQ(repaired.dropped, 1U);
  EXPECT_EQ(repaired.turned, mesh.triangles.size() - 2);
  EXPECT_TRUE(checkForPrint(repaired.mesh).printable());
  EXPECT_EQ(repaired.triangleOf.size(), repaired.mesh.triangles.size());
  EXPECT_EQ(repaired.vertexOf.size(), repaired.mesh.vertices.size());
}

TEST(PrintCheck, FaultsHaveNames) {
  EXPECT_EQ(name(PrintFault::Empty), "empty");
  EXPECT_EQ(name(PrintFault::Open), "open");
  EXPECT_EQ(name(PrintFault::NonManifold), "non_manifold");
  EXPECT_EQ(name(PrintFault::BowTies), "bow_ties");
  EXPECT_EQ(name(PrintFault::Inward), "inward");
  EXPECT_EQ(name(PrintFault::Crossings), "crossings");
  EXPECT_EQ(name(PrintFault::Pieces), "pieces");
}

}  // namespace
}  // namespace vantage
