#include "integration/erasing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/errors.h"
#include "core/integration/scenes.h"
#include "geometry/geometry_hash.h"
#include "geometry/measures.h"
#include "geometry/mesh_topology.h"
#include "integration/zipper.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::around;
using testing::countBowTies;
using testing::scanFrom;

OrientedBox boxAt(const Vec3& centre, double side) {
  OrientedBox box;
  box.T_region_box.translation() = centre;
  box.size = Vec3::Constant(side);
  return box;
}

ErasedSpace spaceWith(int stand, const Region& region, const Pose& T_object_table = Pose::Identity()) {
  ErasedSpace space;
  space.add(stand, std::make_shared<const RegionProbe>(region), T_object_table);
  return space;
}

// A model of two views of a ball of 20 mm.
class Erasing : public ::testing::Test {
 protected:
  Erasing() : views_(scanFrom(testing::makeSphere(20, 24), around(3), 0.02)) {
    views_.resize(2);
    model_ = zipper(views_, {}).model;
  }

  // The same view as if it had been taken in another stand.
  static View inStand(View view, int stand) {
    auto image = std::make_shared<RangeImage>(*view.image);
    image->station.stand = stand;
    view.image = std::move(image);
    return view;
  }

  std::vector<View> views_;
  Model model_;
};

TEST_F(Erasing, NothingOfTheModelIsLeftInTheRegionAndTheRestIsTheSameBytes) {
  const ErasedSpace space = spaceWith(0, boxAt({20, 0, 0}, 15));
  const Model left = withoutErased(model_, views_, space);
  EXPECT_LT(left.mesh.triangles.size(), model_.mesh.triangles.size() - 50);
  EXPECT_GT(left.mesh.triangles.size(), model_.mesh.triangles.size() / 2);
  for (const Vec3& v : left.mesh.vertices) EXPECT_FALSE(space.holds(0, v));
  // In order, every vertex and triangle that is left is one of those that were there.
  std::vector<std::uint32_t> before;
  std::uint32_t at = 0;
  for (std::size_t v = 0; v < left.mesh.vertices.size(); ++v) {
    while (model_.mesh.vertices[at] != left.mesh.vertices[v]) ASSERT_LT(++at, model_.mesh.vertices.size());
    EXPECT_EQ(left.confidence[v], model_.confidence[at]);
    EXPECT_EQ(left.vertexView[v], model_.vertexView[at]);
    EXPECT_EQ(left.vertexSample[v], model_.vertexSample[at]);
    before.push_back(at++);
  }
  std::size_t t = 0;
  for (Triangle triangle : left.mesh.triangles) {
    for (std::uint32_t& v : triangle) v = before[v];
    while (model_.mesh.triangles[t] != triangle) ASSERT_LT(++t, model_.mesh.triangles.size());
    ++t;
  }
  const auto marked = erasedTriangles(model_, views_, space);
  const auto count = static_cast<std::size_t>(std::count(marked.begin(), marked.end(), 1));
  EXPECT_LE(count, model_.mesh.triangles.size() - left.mesh.triangles.size());
  EXPECT_LT(model_.mesh.triangles.size() - left.mesh.triangles.size(), count + 10) << "no more than single fans beside";
  EXPECT_EQ(countBowTies(left.mesh), 0U);
  EXPECT_EQ(MeshTopology(left.mesh).nonManifoldEdges(), 0U);
}

TEST_F(Erasing, WhereNothingIsErasedTheModelIsTheSame) {
  const std::uint64_t before = contentHash(model_.mesh);
  EXPECT_EQ(contentHash(withoutErased(model_, views_, {}).mesh), before);
  EXPECT_EQ(contentHash(withoutErased(model_, views_, spaceWith(0, boxAt({200, 0, 0}, 15))).mesh), before);
  EXPECT_EQ(contentHash(withoutErased(model_, views_, spaceWith(1, boxAt({20, 0, 0}, 15))).mesh), before)
      << "what is erased in one stand says nothing of what was seen in another";
}

TEST_F(Erasing, GoesWithTheTableOfItsStand) {
  Pose T_object_table = Pose::Identity();
  T_object_table.translate(Vec3(20, 0, 0));
  const ErasedSpace space = spaceWith(0, boxAt(Vec3::Zero(), 15), T_object_table);
  EXPECT_EQ(contentHash(withoutErased(model_, views_, space).mesh),
            contentHash(withoutErased(model_, views_, spaceWith(0, boxAt({20, 0, 0}, 15))).mesh));
}

TEST_F(Erasing, OnlySamplesOfItsStandGo) {
  const std::vector<View> views{views_[0], inStand(views_[1], 1)};
  const ErasedSpace space = spaceWith(1, BelowPlane{Vec3(0, 0, 1000), Vec3::UnitZ()});
  const Model left = withoutErased(model_, views, space);
  EXPECT_FALSE(left.mesh.empty());
  for (const std::uint32_t view : left.vertexView) EXPECT_EQ(view, 0U);
}

TEST_F(Erasing, AViewLosesTheSurfaceAndKeepsItsImage) {
  const ErasedSpace space = spaceWith(0, BelowPlane{Vec3::Zero(), Vec3::UnitZ()});
  const View left = withoutErased(views_[0], space);
  EXPECT_EQ(left.image, views_[0].image);
  ASSERT_LT(left.mesh->mesh.vertices.size(), views_[0].mesh->mesh.vertices.size());
  ASSERT_FALSE(left.mesh->mesh.empty());
  for (std::uint32_t v = 0; v < left.mesh->mesh.vertices.size(); ++v) {
    EXPECT_GT((left.T_object_scanner * left.mesh->mesh.vertices[v]).z(), 0.0);
    EXPECT_EQ(left.mesh->vertexOfSample[left.mesh->sample[v]], v);
    const std::uint32_t before = views_[0].mesh->vertexOfSample[left.mesh->sample[v]];
    EXPECT_EQ(views_[0].mesh->mesh.vertices[before], left.mesh->mesh.vertices[v]);
    EXPECT_EQ(views_[0].mesh->confidence[before], left.mesh->confidence[v]);
  }
  EXPECT_EQ(left.mesh->normals.size(), left.mesh->mesh.vertices.size());
  EXPECT_EQ(left.mesh->onBoundary.size(), left.mesh->mesh.vertices.size());
  EXPECT_EQ(withoutErased(views_[0], spaceWith(1, BelowPlane{})).mesh, views_[0].mesh);
}

TEST_F(Erasing, WhatIsErasedIsThereAllTheSame) {
  const ErasedSpace space = spaceWith(0, BelowPlane{Vec3::Zero(), Vec3::UnitZ()});
  std::vector<float> confidence;
  const Mesh erased = erasedSurface(views_, 0, space, &confidence);
  EXPECT_EQ(confidence.size(), erased.vertices.size());
  double whole = 0.0;
  double left = 0.0;
  for (const View& view : views_) {
    whole += area(view.mesh->mesh);
    left += area(withoutErased(view, space).mesh->mesh);
  }
  EXPECT_NEAR(area(erased), whole - left, 1e-6 * whole);
  EXPECT_TRUE(erasedSurface(views_, 1, space).empty());
}

TEST_F(Erasing, ItsBorderIsToldFromThatOfTheScans) {
  const ErasedSpace space = spaceWith(0, boxAt({20, 0, 0}, 15));
  const auto atAll = erasedBorder(model_, views_, 0, spaceWith(0, boxAt({200, 0, 0}, 15)));
  EXPECT_EQ(std::count(atAll.begin(), atAll.end(), 1), 0);
  const Model left = withoutErased(model_, views_, space);
  const auto border = erasedBorder(left, views_, 0, space);
  ASSERT_EQ(border.size(), left.mesh.vertices.size());
  std::set<std::array<double, 3>> before;
  const std::vector<std::uint8_t> onBorder = MeshTopology(model_.mesh).onBoundary();
  for (std::size_t v = 0; v < onBorder.size(); ++v)
    if (onBorder[v] != 0)
      before.insert({model_.mesh.vertices[v].x(), model_.mesh.vertices[v].y(), model_.mesh.vertices[v].z()});
  std::size_t made = 0;
  const MeshTopology topology(left.mesh);
  for (const BoundaryEdge& edge : topology.boundaryEdges()) {
    const Vec3& v = left.mesh.vertices[edge.from];
    if (before.contains({v.x(), v.y(), v.z()})) continue;
    EXPECT_EQ(border[edge.from], 1) << "made by the erasure, at " << v.transpose();
    ++made;
  }
  EXPECT_GT(made, 10U);
  for (std::size_t v = 0; v < border.size(); ++v)
    if (border[v] != 0) EXPECT_TRUE(space.holds(0, left.mesh.vertices[v], 5.0)) << "far from what is erased";
  EXPECT_TRUE(erasedBorder(left, views_, 1, space).empty());
}

TEST_F(Erasing, ProvenanceThatNamesNoViewIsRefused) {
  const std::vector<View> one{views_[0]};
  EXPECT_THROW(static_cast<void>(withoutErased(model_, one, spaceWith(0, BelowPlane{}))), InvalidInput);
}

}  // namespace
}  // namespace vantage
