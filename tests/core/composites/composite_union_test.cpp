#include "composites/composite_union.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "composites/composite_model.h"
#include "geometry/measures.h"
#include "scenes.h"

namespace vantage {
namespace {

TEST(CompositeUnion, HasTheViewsTablesTiesAndSurfaceOfBoth) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  const Composite& a = stands.reference.composite();
  const Composite& b = stands.moved.composite();
  AlignedPose pose;
  pose.T_reference_moved = stands.T_reference_moved;
  const Composite both = united(a, b, pose, {});
  EXPECT_EQ(both.views.size(), a.views.size() + b.views.size());
  EXPECT_EQ(both.ties.size(), a.ties.size() + b.ties.size());
  EXPECT_EQ(both.ties.back().to, both.views.size() - 1);
  ASSERT_EQ(both.tables.size(), 2U);
  // The other table leaves out the surface of the reference that stood on it.
  for (const Vec3& p : both.model->mesh.vertices)
    for (const TablePlane& table : both.tables) ASSERT_GT(table.normal.dot(p), table.height - 2.0);
  EXPECT_GT(area(both.model->mesh), 1.03 * area(a.model->mesh));
  const CompositeModel model(both);
  EXPECT_EQ(model.prepared().size(), both.views.size());
}

TEST(CompositeUnion, RefusesARefinementOfOtherViews) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  AlignedPose pose;
  pose.refinement = JointRefinement{};
  EXPECT_THROW(static_cast<void>(united(stands.reference.composite(), stands.moved.composite(), pose, {})),
               InvalidInput);
}

}  // namespace
}  // namespace vantage
