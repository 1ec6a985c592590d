#include "planning/planning_scene.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "core/planning/scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

const Pose kMotion = Eigen::Translation3d(3.0, -2.0, 7.0) * Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized());

TEST(PlanningScene, KeepsLinesOfSightAShareOfTheMeanSpacingAwayFromTheSurface) {
  const testing::ScannedObject object({0, 5});
  PlannerOptions options;
  options.surfaceOffset = 0.2;
  options.sightMargin = 0.7;
  const PlanningScene scene(object.input(), options, {});
  EXPECT_DOUBLE_EQ(scene.spacing(), 0.5 * (object.views[0].mesh->spacing + object.views[1].mesh->spacing));
  EXPECT_DOUBLE_EQ(scene.sight().options().offset, 0.2 * scene.spacing());
  EXPECT_DOUBLE_EQ(scene.sight().options().margin, 0.7 * scene.spacing());
  EXPECT_DOUBLE_EQ(scene.sight().options().breakdownAngle, object.profile->breakdownAngle);
}

TEST(PlanningScene, TracesADecimatedModelOnceItIsLarge) {
  const testing::ScannedObject object({0});
  PlannerOptions options;
  EXPECT_EQ(PlanningScene(object.input(), options, {}).surface().triangles, object.model->mesh.triangles);
  options.tracedTriangles = object.model->mesh.triangles.size() - 1;
  options.planningError = 1.0;
  EXPECT_LT(PlanningScene(object.input(), options, {}).surface().triangles.size(), object.model->mesh.triangles.size());
}

TEST(PlanningScene, IsMadeOfThePatchesOfAPlanAsOfThoseItFinds) {
  const testing::ScannedObject object({0, 5});
  const PlanningScene found(object.input(), {}, {});
  const PlanningScene given(object.input(), found.voids(), {}, {});
  ASSERT_EQ(given.patches().size(), found.patches().size());
  ASSERT_FALSE(found.patches().empty());
  for (std::size_t p = 0; p < found.patches().size(); ++p) {
    EXPECT_EQ(given.patches()[p].weight, found.patches()[p].weight);
    EXPECT_EQ(given.history().looks(p), found.history().looks(p));
  }
}

TEST(PlanningScene, MovesPatchesAndSurfaceToTheTable) {
  const testing::ScannedObject object({0});
  PlanInput input = object.input();
  input.T_object_table = kMotion;
  const PlanningScene scene(input, {}, {});
  ASSERT_FALSE(scene.patches().empty());
  for (std::size_t p = 0; p < scene.patches().size(); ++p) {
    const VoidPatch& inObject = scene.voids()->patches[p];
    EXPECT_TRUE(inObject.centre.isApprox(kMotion * scene.patches()[p].centre, 1e-12));
    EXPECT_TRUE(inObject.normal.isApprox(kMotion.linear() * scene.patches()[p].normal, 1e-12));
    EXPECT_TRUE(inObject.corners[2].isApprox(kMotion * scene.patches()[p].corners[2], 1e-12));
  }
  EXPECT_TRUE((kMotion * scene.surface().vertices[0]).isApprox(object.model->mesh.vertices[0], 1e-12));
  EXPECT_TRUE(scene.pointOnTable(kMotion * Vec3(1, 2, 3)).isApprox(Vec3(1, 2, 3), 1e-12));
  EXPECT_TRUE(scene.directionOnTable(kMotion.linear() * Vec3(1, 2, 3)).isApprox(Vec3(1, 2, 3), 1e-12));
}

TEST(PlanningScene, MovesNothingToTheLastBitWhereBothFramesAreTheSame) {
  const testing::ScannedObject object({0});
  const PlanningScene scene(object.input(), {}, {});
  EXPECT_EQ(scene.patches().data(), scene.voids()->patches.data());
  EXPECT_EQ(scene.surface().vertices, object.model->mesh.vertices);
  EXPECT_EQ(scene.pointOnTable(Vec3(0.1, 0.2, 0.3)), Vec3(0.1, 0.2, 0.3));
}

TEST(PlanningScene, KnowsThePositionsThatWereTaken) {
  const testing::ScannedObject object({0, 5});
  const PlanningScene scene(object.input(), {}, {});
  EXPECT_TRUE(scene.taken(5));
  EXPECT_FALSE(scene.taken(4));
  EXPECT_THROW((void)scene.pose(24), InvalidInput);
  EXPECT_THROW((void)scene.pose(-1), InvalidInput);
}

TEST(PlanningScene, NeedsAView) {
  PlanInput input = testing::ScannedObject({0}).input();
  input.views.clear();
  EXPECT_THROW((void)PlanningScene(input, {}, {}), InvalidInput);
  EXPECT_THROW((void)PlanningScene(input, std::make_shared<const VoidSurface>(), {}, {}), InvalidInput);
}

}  // namespace
}  // namespace vantage
