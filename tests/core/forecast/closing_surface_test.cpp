#include "forecast/closing_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/forecast/scanned_sphere.h"
#include "scanner/sight.h"

namespace vantage {
namespace {

ClosingSurface predicted(const testing::ScannedSphere& sphere, const ClosingOptions& options = {}, int threads = 1) {
  const RayCaster obstacles(sphere.model);
  return predictClosingSurface(sphere.model, obstacles, sphere.views, *sphere.profile, sphere.spacing, options,
                               Progress().withThreads(threads));
}

double areaOf(const ClosingSurface& closing) {
  double area = 0.0;
  for (const LevelFace& face : closing.faces) area += face.area;
  return area;
}

// Of a sphere that is seen from around, what lacks are its poles: what closes them lies near the sphere, and is about
// as large.
TEST(ClosingSurface, ClosesASphereWhereNobodyLooked) {
  const testing::ScannedSphere sphere({0, 4, 8, 12, 16, 20});
  const ClosingSurface closing = predicted(sphere);
  ASSERT_FALSE(closing.faces.empty());
  std::vector<double> off;
  for (const LevelFace& face : closing.faces)
    off.push_back(std::abs((face.centre - testing::sphereCentre()).norm() - testing::kSphereRadius));
  std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2), off.end());
  EXPECT_LT(off[off.size() / 2], 0.2 * testing::kSphereRadius);
  // Two caps that begin 60 degrees from the horizon, and a little more where the camera looks down or up.
  const double caps = 4.0 * kPi * testing::kSphereRadius * testing::kSphereRadius * (1.0 - std::sin(radians(60.0)));
  EXPECT_GT(areaOf(closing), 0.5 * caps);
  EXPECT_LT(areaOf(closing), 2.0 * caps);
}

TEST(ClosingSurface, ShrinksAsViewsGoAround) {
  double before = 1e9;
  for (const std::vector<int>& positions : {std::vector<int>{0, 8}, {0, 8, 16}, {0, 4, 8, 12, 16, 20}}) {
    const double area = areaOf(predicted(testing::ScannedSphere(positions)));
    EXPECT_LT(area, before);
    before = area;
  }
}

// The law that carving serves: no view contradicts what is left.
TEST(ClosingSurface, IsNothingThatAViewShouldHaveSampled) {
  const testing::ScannedSphere sphere({0, 5});
  const ClosingOptions options;
  const ClosingSurface closing = predicted(sphere, options);
  const RayCaster obstacles(sphere.model);
  const RayCaster itself(closing.mesh);
  const double margin = 0.6 * closing.side;
  const SightTest sight(*sphere.profile, obstacles,
                        {sphere.profile->breakdownAngle - options.clearOfBreakdown, margin, margin}, &itself);
  for (const LevelFace& face : closing.faces)
    for (const View& view : sphere.views)
      EXPECT_NE(sight.look(view.T_object_scanner, face.centre, face.normal).visibility, Visibility::Seen);
}

TEST(ClosingSurface, IsTheSameForAnyNumberOfThreads) {
  const testing::ScannedSphere sphere({0, 5});
  const ClosingSurface one = predicted(sphere);
  const ClosingSurface four = predicted(sphere, {}, 4);
  ASSERT_EQ(one.faces.size(), four.faces.size());
  for (std::size_t f = 0; f < one.faces.size(); ++f) {
    EXPECT_EQ(one.faces[f].centre, four.faces[f].centre);
    EXPECT_EQ(one.faces[f].area, four.faces[f].area);
  }
}

}  // namespace
}  // namespace vantage
