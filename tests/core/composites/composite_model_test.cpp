#include "composites/composite_model.h"

#include <gtest/gtest.h>

#include <utility>

#include "base/errors.h"
#include "composites/composite.h"
#include "scenes.h"

namespace vantage {
namespace {

TEST(CompositeModel, KnowsPointsAndScaleOfItsComposite) {
  const CompositeModel& model = testing::oddBodyInTwoStands().reference;
  EXPECT_NEAR(static_cast<double>(model.points(PointLevel::Coarse).size()), 300.0, 30.0);
  EXPECT_LT(model.points(PointLevel::Coarse).size(), model.points(PointLevel::Medium).size());
  EXPECT_GE(model.points(PointLevel::Fine).size(), model.points(PointLevel::Medium).size());
  EXPECT_GT(model.scale().spacing, 1.5);
  EXPECT_LT(model.scale().spacing, 4.0);
  EXPECT_NEAR(model.scale().noise, 0.1, 0.08);
  EXPECT_NEAR(model.residual(), 0.1, 0.08);
  EXPECT_GT(model.scale().extent, 70.0);
  EXPECT_LT(model.scale().extent, 130.0);
  EXPECT_EQ(model.prepared().size(), model.composite().views.size());
}

TEST(CompositeModel, MovesWithItsViews) {
  const CompositeModel& model = testing::oddBodyInTwoStands().reference;
  Pose motion = Pose::Identity();
  motion.rotate(Eigen::AngleAxisd(0.02, Vec3::UnitY())).pretranslate(Vec3(0.3, -0.2, 0.1));
  std::vector<Pose> poses;
  for (const View& view : model.composite().views) poses.push_back(motion * view.T_object_scanner);
  const CompositeModel moved = model.withPoses(poses);
  for (const std::uint32_t i : model.points(PointLevel::Coarse))
    EXPECT_LT((moved.surface().point(i) - motion * model.surface().point(i)).norm(), 1e-9);
  EXPECT_LT((moved.centroid() - motion * model.centroid()).norm(), 1e-9);
  EXPECT_TRUE(moved.composite().views[1].T_object_scanner.isApprox(poses[1]));
}

TEST(CompositeModel, RefusesWhatCannotBeAligned) {
  const Composite& whole = testing::oddBodyInTwoStands().reference.composite();
  EXPECT_THROW(CompositeModel(Composite{}), InvalidInput);
  Composite composite = whole;
  composite.model = std::make_shared<const Model>();
  EXPECT_THROW(CompositeModel{composite}, InvalidInput);
  composite = whole;
  composite.views.pop_back();
  EXPECT_THROW(CompositeModel{composite}, InvalidInput);
  composite = whole;
  composite.ties.push_back({0, 99, Pose::Identity(), {}});
  EXPECT_THROW(CompositeModel{composite}, InvalidInput);
  composite = whole;
  composite.views[0].mesh = nullptr;
  EXPECT_THROW(CompositeModel{composite}, InvalidInput);
}

}  // namespace
}  // namespace vantage
