#include "registration/multi_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "base/errors.h"
#include "registration/alignment.h"
#include "scenes.h"

namespace vantage {
namespace {

using testing::centroid;
using testing::makeBall;
using testing::makeProfile;
using testing::poseError;
using testing::randomMotion;
using testing::scanFrom;
using testing::scanVase;

struct Ring {
  std::vector<View> views;
  std::vector<Pose> truth;

  [[nodiscard]] double error(const std::vector<Pose>& poses) const {
    double squares = 0.0;
    for (std::size_t i = 0; i < views.size(); ++i) squares += std::pow(poseError(views[i], poses[i], truth[i]), 2);
    return std::sqrt(squares / static_cast<double>(views.size()));
  }
};

// Views all around the ball.
Ring makeRing(int count) {
  const auto profile = makeProfile(0.1, 90, 90);
  const Mesh ball = makeBall();
  Ring ring;
  for (int i = 0; i < count; ++i) {
    ring.views.push_back(scanFrom(ball, profile, 90 * i / count, static_cast<unsigned>(i) + 1));
    ring.truth.push_back(ring.views.back().T_object_scanner);
  }
  return ring;
}

// A chain of registrations that each turned 0.1 degrees and shifted 0.05 mm too far.
void drift(Ring& ring) {
  Pose step = Pose::Identity();
  step.translate(Vec3(0.05, 0.0, 0.02));
  step.rotate(Eigen::AngleAxisd(radians(0.1), Vec3::UnitZ()));
  Pose error = Pose::Identity();
  for (std::size_t i = 1; i < ring.views.size(); ++i) {
    error = error * step;
    ring.views[i].T_object_scanner = error * ring.truth[i];
  }
}

double relativeError(const Ring& ring, const std::vector<Pose>& poses, std::size_t i, std::size_t j) {
  return poseError(ring.views[i], poses[j].inverse() * poses[i], ring.truth[j].inverse() * ring.truth[i]);
}

TEST(MultiView, SpreadsTheErrorOfALoop) {
  Ring ring = makeRing(10);
  drift(ring);
  std::vector<Pose> before;
  for (const View& view : ring.views) before.push_back(view.T_object_scanner);
  const MultiViewResult result = refineViews(ring.views, {});
  EXPECT_TRUE(result.improved);
  EXPECT_GT(relativeError(ring, before, 9, 0), 0.5);
  for (std::size_t i = 0; i < ring.views.size(); ++i)
    EXPECT_LT(relativeError(ring, result.poses, (i + 1) % 10, i), 0.06) << i;
  EXPECT_LT(ring.error(result.poses), 0.12);  // neighbours' noise adds up to half way round
  EXPECT_LT(result.rmsAfter, result.rmsBefore);
  EXPECT_NEAR(result.rmsAfter, 0.1 * std::sqrt(2.0), 0.06);
  ASSERT_EQ(result.poseSigmas.size(), ring.views.size());
  EXPECT_EQ(result.poseSigmas[0], 0.0);
  for (std::size_t i = 1; i < ring.views.size(); ++i) EXPECT_LT(result.poseSigmas[i], 0.1) << i;
}

TEST(MultiView, KeepsTheFirstPoseToTheLastBit) {
  Ring ring = makeRing(6);
  ring.views[0].T_object_scanner = randomMotion(3, 0.7, 50.0, Vec3::Zero());
  for (std::size_t i = 1; i < 6; ++i)
    ring.views[i].T_object_scanner = ring.views[0].T_object_scanner * ring.truth[0].inverse() * ring.truth[i];
  const MultiViewResult result = refineViews(ring.views, {});
  EXPECT_TRUE(result.poses[0].matrix() == ring.views[0].T_object_scanner.matrix());
}

TEST(MultiView, NeverMakesItWorse) {
  Ring ring = makeRing(6);
  const MultiViewResult once = refineViews(ring.views, {});
  for (std::size_t i = 0; i < 6; ++i) ring.views[i].T_object_scanner = once.poses[i];
  const MultiViewResult again = refineViews(ring.views, {});
  EXPECT_LE(once.rmsAfter, once.rmsBefore);
  EXPECT_LE(again.rmsAfter, again.rmsBefore);
  for (std::size_t i = 0; i < 6 && !again.improved; ++i) EXPECT_TRUE(again.poses[i].matrix() == once.poses[i].matrix());
}

TEST(MultiView, LeavesAViewWithoutOverlapWhereItIs) {
  const auto profile = makeProfile(0.1, 90, 90);
  const std::vector<View> views = {scanFrom(makeBall(), profile, 0, 1), scanFrom(makeBall(), profile, 45, 2)};
  const MultiViewResult result = refineViews(views, {});
  EXPECT_TRUE(result.poses[1].matrix() == views[1].T_object_scanner.matrix());
  EXPECT_EQ(result.pairs, 0U);
  EXPECT_GT(result.poseSigmas[1], 100.0);
}

TEST(MultiView, AViewIsAsSureAsTheWayToTheFirstOne) {
  const auto profile = makeProfile(0.1, 90, 90);
  std::vector<View> views;
  for (const int position : {0, 8, 16, 45, 53})
    views.push_back(scanFrom(makeBall(), profile, position, static_cast<unsigned>(position) + 1));
  const MultiViewResult result = refineViews(views, {});
  EXPECT_LT(result.poseSigmas[1], 0.2);
  EXPECT_LT(result.poseSigmas[2], 0.3);
  EXPECT_GT(result.poseSigmas[2], result.poseSigmas[1]);
  // These hold each other, and nothing holds both.
  EXPECT_GT(result.poseSigmas[3], 100.0);
  EXPECT_GT(result.poseSigmas[4], 100.0);
}

TEST(MultiView, DoesNotTurnWhatNothingHolds) {
  const auto profile = makeProfile(0.1, 90, 90);
  std::vector<View> views;
  views.reserve(6);
  for (int i = 0; i < 6; ++i) views.push_back(scanVase(profile, 15 * i, static_cast<unsigned>(i) + 1));
  const MultiViewResult result = refineViews(views, {});
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Vec6 motion = motionVector(result.poses[i] * views[i].T_object_scanner.inverse(), Vec3::Zero());
    EXPECT_LT(std::abs(motion[2]), radians(0.1)) << i;
  }
}

TEST(MultiView, GoesBackToWhatWasSaidWhereNothingHolds) {
  const auto profile = makeProfile(0.1, 90, 90);
  std::vector<View> views;
  MultiViewOptions options;
  for (int i = 0; i < 4; ++i) {
    views.push_back(scanVase(profile, 15 * i, static_cast<unsigned>(i) + 1));
    options.given.push_back(views.back().T_object_scanner);
    // Turned about the axis of the vase by 4 degrees more from view to view.
    views.back().T_object_scanner = Eigen::AngleAxisd(radians(4.0 * i), Vec3::UnitZ()) * views.back().T_object_scanner;
  }
  const MultiViewResult result = refineViews(views, options);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Vec6 motion = motionVector(result.poses[i] * options.given[i].inverse(), Vec3::Zero());
    EXPECT_LT(std::abs(motion[2]), radians(0.2)) << i;
    EXPECT_LT(motion.tail<3>().norm(), 0.3) << i;
  }
  options.given.pop_back();
  EXPECT_THROW((void)refineViews(views, options), InvalidInput);
}

TEST(MultiView, GivesTheSameBytesForAnyThreadCount) {
  Ring ring = makeRing(6);
  drift(ring);
  const MultiViewResult one = refineViews(ring.views, {});
  const MultiViewResult three = refineViews(ring.views, {}, Progress({}, {}, 3));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(one.poses[i].matrix() == three.poses[i].matrix());
  EXPECT_EQ(one.rmsAfter, three.rmsAfter);
}

TEST(MultiView, StopsWhenAsked) {
  const Ring ring = makeRing(2);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)refineViews(ring.views, {}, Progress({}, stop.get_token(), 1)), Cancelled);
}

TEST(MultiView, OfOneViewOrNoneIsThatView) {
  const Ring ring = makeRing(1);
  EXPECT_TRUE(refineViews(ring.views, {}).poses[0].matrix() == ring.truth[0].matrix());
  EXPECT_TRUE(refineViews({}, {}).poses.empty());
}

PosePrior precise() {
  return isotropicPrior(radians(0.1), 0.1, Vec3::Zero());
}

// A vase may turn about its axis as it likes. What is known of the moves between its scans turns it, whereever it
// began.
TEST(MultiView, TiesDecideWhatTheSurfacesLeaveOpen) {
  const auto profile = makeProfile(0.1, 90, 90);
  std::vector<View> views;
  std::vector<Pose> truth;
  MultiViewOptions options;
  for (int i = 0; i < 6; ++i) {
    views.push_back(scanVase(profile, 15 * i, static_cast<unsigned>(i) + 1));
    truth.push_back(views.back().T_object_scanner);
    if (i > 0)
      options.ties.push_back(
          {views.size() - 2, views.size() - 1, truth[views.size() - 2].inverse() * truth.back(), precise()});
  }
  for (const double off : {-1.0, 1.5}) {
    for (std::size_t i = 1; i < views.size(); ++i)
      views[i].T_object_scanner = Eigen::AngleAxisd(radians(off), Vec3::UnitZ()) * truth[i];
    const MultiViewResult result = refineViews(views, options);
    EXPECT_TRUE(result.improved);
    for (std::size_t i = 0; i < views.size(); ++i) {
      const Vec6 motion = motionVector(result.poses[i] * truth[i].inverse(), Vec3::Zero());
      EXPECT_LT(std::abs(motion[2]), radians(0.1)) << i << " from " << off;
    }
  }
}

TEST(MultiView, TiesGiveInToTheSurfaces) {
  Ring ring = makeRing(6);
  MultiViewOptions options;
  Pose wrong = Pose::Identity();
  wrong.translate(Vec3(0.2, -0.2, 0.1));
  for (std::size_t i = 1; i < ring.views.size(); ++i) {
    options.ties.push_back({i - 1, i, ring.truth[i - 1].inverse() * wrong * ring.truth[i], precise()});
    ring.views[i].T_object_scanner = ring.views[i - 1].T_object_scanner * options.ties.back().T_from_to;
  }
  const MultiViewResult result = refineViews(ring.views, options);
  EXPECT_TRUE(result.improved);
  EXPECT_LT(ring.error(result.poses), 0.12);
}

TEST(MultiView, RefusesATieThatDoesNotJoinTwoViews) {
  const Ring ring = makeRing(2);
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{0, 2}, {1, 1}, {7, 0}}) {
    MultiViewOptions options;
    options.ties.push_back({from, to, Pose::Identity(), precise()});
    EXPECT_THROW((void)refineViews(ring.views, options), InvalidInput);
  }
}

TEST(Alignment, BringsDisturbedViewsTogether) {
  Ring ring = makeRing(8);
  for (std::size_t i = 1; i < 8; ++i)
    ring.views[i].T_object_scanner =
        randomMotion(static_cast<unsigned>(i), radians(3.0), 3.0, centroid(ring.views[i])) * ring.truth[i];
  const AlignmentResult result = registerViews(ring.views, {});
  EXPECT_EQ(result.order.size(), 8U);
  EXPECT_EQ(result.order.front(), 0U);
  EXPECT_LT(ring.error(result.poses), 0.08);
  EXPECT_TRUE(result.poses[0].matrix() == ring.truth[0].matrix());
}

TEST(Alignment, ReportsTheViewThatBelongsToAnotherObject) {
  Ring ring = makeRing(8);
  const auto profile = makeProfile(0.1, 90, 90);
  ring.views.push_back(scanVase(profile, 40, 9));
  const AlignmentResult result = registerViews(ring.views, {});
  EXPECT_NE(result.views[8].verdict, Verdict::Good);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NE(result.views[i].verdict, Verdict::Failed) << i;
}

}  // namespace
}  // namespace vantage
