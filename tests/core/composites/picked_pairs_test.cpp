#include "composites/picked_pairs.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/errors.h"
#include "scenes.h"

namespace vantage {
namespace {

std::vector<PickedPair> pairsOf(const testing::TwoStands& stands, const std::vector<Vec3>& onReference) {
  std::vector<PickedPair> pairs;
  for (const Vec3& p : onReference) pairs.push_back({p, stands.T_reference_moved.inverse() * p});
  return pairs;
}

TEST(PickedPairs, BringTheSurfacesRoughlyTogether) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  std::vector<Vec3> picks;
  const auto points = stands.reference.points(PointLevel::Coarse);
  for (const std::size_t k : {std::size_t{0}, points.size() / 3, points.size() - 1})
    picks.push_back(stands.reference.surface().point(points[k]));
  const Pose T = poseOfPairs(stands.reference, stands.moved, pairsOf(stands, picks));
  EXPECT_LT(testing::poseError(stands.moved, T, stands.T_reference_moved), 15.0);
}

TEST(PickedPairs, FewerThanThreeOrOnesOnALineAreRefused) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  const auto refused = [&](const std::vector<PickedPair>& pairs) {
    EXPECT_THROW(static_cast<void>(poseOfPairs(stands.reference, stands.moved, pairs)), InvalidInput);
  };
  const auto points = stands.reference.points(PointLevel::Coarse);
  const Vec3 a = stands.reference.surface().point(points.front());
  const Vec3 b = stands.reference.surface().point(points.back());
  refused({});
  refused(pairsOf(stands, {a, b}));
  refused(pairsOf(stands, {a, b, b}));
  std::vector<PickedPair> odd = pairsOf(stands, {a, b, b});
  odd[2].moved.x() = std::numeric_limits<double>::quiet_NaN();
  refused(odd);
}

}  // namespace
}  // namespace vantage
