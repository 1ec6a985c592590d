#include "registration/prepared_refinement.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/errors.h"
#include "scenes.h"

namespace vantage {
namespace {

// Two views of the ball, the second one off by a little.
std::vector<View> twoViews() {
  const auto profile = testing::makeProfile(0.1, 90, 90);
  std::vector<View> views{testing::scanFrom(testing::makeBall(), profile, 0, 1),
                          testing::scanFrom(testing::makeBall(), profile, 6, 2)};
  views[1].T_object_scanner.pretranslate(Vec3(0.1, 0.05, 0.0));
  return views;
}

TEST(PreparedRefinement, IsThatOfTheViews) {
  const std::vector<View> views = twoViews();
  const MultiViewResult all = refineViews(views, {});
  const MultiViewResult prepared = refinePrepared(views, prepareViews(views, {}), {}, {});
  ASSERT_TRUE(all.improved);
  ASSERT_EQ(prepared.poses.size(), views.size());
  for (std::size_t i = 0; i < views.size(); ++i) EXPECT_TRUE(prepared.poses[i].matrix() == all.poses[i].matrix()) << i;
  EXPECT_EQ(prepared.poseSigmas, all.poseSigmas);
  EXPECT_EQ(prepared.rmsAfter, all.rmsAfter);
}

TEST(PreparedRefinement, LeavesASingleViewWhereItIs) {
  const std::vector<View> views{twoViews()[1]};
  const MultiViewResult result = refinePrepared(views, {}, {}, {});
  EXPECT_FALSE(result.improved);
  EXPECT_TRUE(result.poses.at(0).matrix() == views[0].T_object_scanner.matrix());
  MultiViewOptions options;
  options.ties.push_back({0, 1, Pose::Identity(), {}});
  EXPECT_THROW(static_cast<void>(refinePrepared(views, {}, options, {})), InvalidInput);
}

}  // namespace
}  // namespace vantage
