#include "registration/scan_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "registration/list_search.h"
#include "registration/placed_views.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

// Five scans of the ball with relief, 36 degrees apart.
std::vector<View> ballScans() {
  const auto profile = testing::makeProfile(0.05, 90, 90);
  const Mesh ball = testing::makeBall();
  std::vector<View> views;
  views.reserve(5);
  for (int k = 0; k < 5; ++k) views.push_back(testing::scanFrom(ball, profile, 9 * k, static_cast<unsigned>(k + 1)));
  return views;
}

// Another object in the place of one of them: a box as large.
View boxScan(int position) {
  const Mesh box = testing::makeBox(Vec3(-35, -35, 20), Vec3(35, 35, 120));
  return testing::scanFrom(box, testing::makeProfile(0.05, 90, 90), position);
}

std::vector<Pose> posesOf(const std::vector<View>& views) {
  std::vector<Pose> poses;
  poses.reserve(views.size());
  for (const View& view : views) poses.push_back(view.T_object_scanner);
  return poses;
}

TEST(ScanSet, OfScansOfOneObjectIsWhole) {
  const std::vector<View> views = ballScans();
  const ScanSet set = judgedSet(views, prepareViews(views, {}), posesOf(views), {}, {});
  EXPECT_EQ(set.worth(), 5.0);
  for (std::size_t i = 0; i < views.size(); ++i)
    EXPECT_LT(testing::poseError(views[i], set.placement.poses[i], views[i].T_object_scanner), 0.2) << i;
}

TEST(ScanSet, LeavesOutTheFirstScanWhenItIsTheOddOne) {
  std::vector<View> views = ballScans();
  views[0] = boxScan(0);
  const ScanSet set = judgedSet(views, prepareViews(views, {}), posesOf(views), {}, {});
  EXPECT_EQ(set.placement.views[0].verdict, Verdict::Failed);
  EXPECT_EQ(set.placement.order.size(), 4U);
  EXPECT_EQ(set.refinement.poses.size(), 4U);
}

// A box without lid, on its side: its mouth looks at the scanner of position 0.
Mesh lyingBox() {
  Mesh box = testing::makeBox(Vec3(-50, -30, 20), Vec3(50, 30, 80), 24);
  std::erase_if(box.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return box.vertices[v].x() > 49.9; });
  });
  Mesh inside = box;
  for (Triangle& t : inside.triangles) std::swap(t[0], t[1]);
  for (Vec3& v : inside.vertices)
    v = Vec3(0.0, 0.0, 50.0) + Vec3(1.0, 0.95, 0.95).cwiseProduct(v - Vec3(0.0, 0.0, 50.0));
  return testing::joined(box, inside);
}

TEST(ScanSet, SeesNoContradictionInWhatTheMouthOfABoxHides) {
  const Mesh box = lyingBox();
  const auto profile = testing::makeProfile(0.05);
  const std::vector<View> views{testing::scanFrom(box, profile, 5, 1), testing::scanFrom(box, profile, 0, 2)};
  const auto prepared = prepareViews(views, {});
  EXPECT_TRUE(contradictionOfLast(views, prepared, true, Mesh{}, {}, {}));
  EXPECT_FALSE(contradictionOfLast(views, prepared, true, box, {}, {}));
}

TEST(PlacedViews, BeginsWithTheFirstScanWhereItBelongs) {
  const std::vector<View> views = ballScans();
  const PlacedViews placement = placeViews(prepareViews(views, {}), posesOf(views), {}, {});
  EXPECT_EQ(placement.order.front(), 0U);
  EXPECT_EQ(placement.order.size(), 5U);
  EXPECT_EQ(placement.poses[0].matrix(), views[0].T_object_scanner.matrix());
}

TEST(ListSearch, FindsThatEveryTurnIsHalf) {
  const std::vector<View> views = ballScans();
  const std::vector<Pose> truth = posesOf(views);
  const std::vector<Pose> listed = withTurns(truth, *turnsOf(truth), 2.0).poses;
  const auto lists = betterLists(prepareViews(views, {}), listed, {});
  EXPECT_TRUE(std::any_of(lists.begin(), lists.end(), [](const MendedList& list) {
    return list.finding.fault == PoseListFault::Turns && std::abs(list.finding.value - 0.5) < 0.03;
  }));
}

TEST(ListSearch, FindsNothingBetterThanAListThatIsRight) {
  const std::vector<View> views = ballScans();
  EXPECT_TRUE(betterLists(prepareViews(views, {}), posesOf(views), {}).empty());
}

TEST(RegisterViews, SaysThatTheTurnsAreHalfAndDoubtsAllScans) {
  std::vector<View> views = ballScans();
  const std::vector<Pose> truth = posesOf(views);
  const std::vector<Pose> listed = withTurns(truth, *turnsOf(truth), 2.0).poses;
  for (std::size_t i = 0; i < views.size(); ++i) views[i].T_object_scanner = listed[i];
  const AlignmentResult result = registerViews(views, {});
  ASSERT_TRUE(result.list);
  EXPECT_EQ(result.list->fault, PoseListFault::Turns);
  EXPECT_NEAR(result.list->value, 0.5, 0.03);
  ASSERT_EQ(result.order.size(), 5U);
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(result.views[i].verdict, Verdict::Doubtful);
    EXPECT_EQ(result.views[i].finding.reason, VerdictReason::OtherTurns);
    const Pose T_listed_true = result.poses[0] * truth[0].inverse();
    EXPECT_LT(testing::poseError(views[i], result.poses[i], T_listed_true * truth[i]), 0.3) << i;
  }
}

TEST(RegisterViews, SaysThatNoPosesWereGivenWhereTheSurfaceDoesNotTell) {
  std::vector<View> views = ballScans();
  for (View& view : views) {
    RangeImage image = *view.image;
    image.poseKnownBy = PoseSource::Unknown;
    view.image = std::make_shared<const RangeImage>(std::move(image));
    view.T_object_scanner = Pose::Identity();
  }
  const AlignmentResult result = registerViews(views, {});
  ASSERT_LT(result.order.size(), 5U);
  for (std::size_t i = 1; i < views.size(); ++i) EXPECT_NE(result.views[i].verdict, Verdict::Good) << i;
  EXPECT_EQ(result.views[4].finding.reason, VerdictReason::NoPoseGiven);
}

}  // namespace
}  // namespace vantage
