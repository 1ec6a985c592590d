#include "positional_space/scanner_images.h"

#include <gtest/gtest.h>

#include <limits>

#include <algorithm>
#include <numeric>
#include <stop_token>
#include <tuple>

#include "base/errors.h"
#include "support/scenes/small_profiles.h"

namespace vantage {
namespace {

using Key = std::tuple<int, int, int, int>;

std::vector<Key> cellsOf(const ScannerImages& images, int position) {
  std::vector<Key> keys;
  for (const std::uint32_t number : images.image(position)) {
    const PositionalCell c = images.cell(number);
    keys.emplace_back(c.row, c.column, c.phi, c.psi);
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

TEST(ScannerImages, ShiftedImagesEqualThoseComputedForEveryPosition) {
  // 30 steps: three columns each. 36: gcd 18, two images stored. 180: two positions per column. 7: nothing repeats.
  for (const int steps : {30, 36, 180, 7}) {
    const ScannerProfile profile = testing::rotatingStripe(steps);
    ScannerProfile unordered = profile;
    unordered.workspace.steps = 0;
    const ScannerImages shifted = computeScannerImages(profile);
    const ScannerImages direct = computeScannerImages(unordered);
    ASSERT_EQ(direct.data().periods, 1);
    EXPECT_EQ(shifted.data().periods, std::gcd(steps, 90));
    ASSERT_EQ(shifted.positions(), direct.positions());
    for (int position = 0; position < steps; ++position)
      EXPECT_EQ(cellsOf(shifted, position), cellsOf(direct, position)) << "position " << position << " of " << steps;
  }
}

TEST(ScannerImages, ShiftsWorkForEveryTilt) {
  const ScannerProfile profile = testing::tiltedPinhole("0, 20, 35", 10);
  ScannerProfile unordered = profile;
  unordered.workspace.steps = 0;
  const ScannerImages shifted = computeScannerImages(profile);
  const ScannerImages direct = computeScannerImages(unordered);
  EXPECT_EQ(shifted.data().imageStart.size(), 3U + 1U);
  for (int position = 0; position < 30; ++position) EXPECT_EQ(cellsOf(shifted, position), cellsOf(direct, position));
}

TEST(ScannerImages, ImageCellsAreThoseOfTheRangingRaysThroughTheirMiddles) {
  for (const ScannerProfile& profile : testing::everyKind()) {
    const ScannerImages images = computeScannerImages(profile);
    const int position = 5;
    const Pose& pose = profile.workspace.poses[position];
    const auto image = images.image(position);
    EXPECT_GT(image.size(), 50U);
    for (const std::uint32_t number : image) {
      const OutwardRay ray = images.ray(number);
      // Of all ranging rays, the one nearest to the surface cell's middle has the direction of the cell's ray.
      double best = 1e9;
      Vec3 direction = Vec3::Zero();
      for (std::size_t i = 0; i < profile.rays->size(); ++i) {
        const Vec3 d = pose.linear() * profile.rays->ray(i).direction;
        const double distance = (ray.point - pose * profile.rays->ray(i).origin).cross(d).norm();
        if (distance < best && d.dot(ray.direction) < 0.0) std::tie(best, direction) = std::pair(distance, d);
      }
      ASSERT_LT(best, 6.0);
      // Half of the widest ray spacing (0.67 degrees) and half a direction cell.
      EXPECT_LT(std::acos(std::min(1.0, -direction.dot(ray.direction))), radians(0.5) + images.grid().directionStep());
    }
  }
}

TEST(ScannerImages, EverySurfaceCellInViewIsEntered) {
  // Linear stripe: at position 0 the rays are parallel to -x and cover |y| <= 115 and z from 5 to 295 of the near side,
  // and half a ray's spacing more.
  const ScannerImages images = computeScannerImages(testing::linearStripe());
  std::size_t expected = 0;
  for (const SurfaceCell& cell : images.grid().surfaceCells())
    if (cell.centre.x() > 0.0 && std::abs(cell.centre.y()) <= 115.0 + 1.456) ++expected;
  EXPECT_EQ(images.image(0).size(), expected);
}

TEST(ScannerImages, PositionsOfIsTheInverseOfImage) {
  for (const ScannerProfile& profile : {testing::rotatingStripe(180), testing::tiltedPinhole("0, 25", 30)}) {
    const ScannerImages images = computeScannerImages(profile);
    std::vector<std::vector<int>> positions(images.cellCount());
    for (int position = 0; position < images.positions(); ++position)
      for (const std::uint32_t cell : images.image(position)) positions[cell].push_back(position);
    for (std::uint32_t cell = 0; cell < images.cellCount(); ++cell) {
      EXPECT_EQ(images.positionsOf(cell), positions[cell]);
      EXPECT_FALSE(positions[cell].empty()) << "the union holds a cell that no position occupies";
    }
  }
}

TEST(ScannerImages, ReceiversTurnWithThePosition) {
  const ScannerProfile profile = testing::rotatingStripe(90);
  const ScannerImages images = computeScannerImages(profile);
  for (const int position : {0, 17, 60}) {
    const Pose& pose = profile.workspace.poses[static_cast<std::size_t>(position)];
    for (const std::uint32_t cell : images.image(position)) {
      ASSERT_EQ(images.receivers(cell).size(), 1U);
      // The receiver is 60 mm from the head, which stands at (300, 0, 150).
      EXPECT_NEAR((images.receivers(cell)[0] - pose * Vec3(300, 0, 150)).norm(), 60.0, 1.0);
    }
  }
}

TEST(ScannerImages, ReceiversOnOppositeSidesAreNotMixed) {
  // Two positions with the same rays; in the second the head is turned upside down about its viewing direction.
  ScannerProfile profile = testing::pinhole(1);
  const Vec3 head(420, 10, 240);
  const Vec3 forward = (Vec3(0, 0, 140) - head).normalized();
  Pose turned = Pose::Identity();
  turned.translate(head);
  turned.rotate(Eigen::AngleAxisd(kPi, forward));
  turned.translate(-head);
  profile.workspace = {{Pose::Identity(), turned}, 0};
  const ScannerImages images = computeScannerImages(profile);
  const Vec3 receiver = profile.rays->receivers(0)[0];
  for (int position = 0; position < 2; ++position)
    for (const std::uint32_t cell : images.image(position))
      EXPECT_LT(
          (images.receivers(cell)[0] - profile.workspace.poses[static_cast<std::size_t>(position)] * receiver).norm(),
          1e-6);
}

TEST(ScannerImages, AnyThreadCountGivesTheSameImages) {
  const ScannerProfile profile = testing::tiltedPinhole("0, 25", 7);
  const ScannerImages one = computeScannerImages(profile, Progress(nullptr, {}, 1));
  const ScannerImages three = computeScannerImages(profile, Progress(nullptr, {}, 3));
  EXPECT_EQ(one.data().imageCells, three.data().imageCells);
  EXPECT_EQ(one.data().direction, three.data().direction);
  EXPECT_EQ(one.data().receiverPositions, three.data().receiverPositions);
}

TEST(ScannerImages, RefusesPartsThatDoNotFit) {
  const ScannerImages images = computeScannerImages(testing::linearStripe());
  ScannerImages::Data data = images.data();
  data.imageCells[3] = 0xfffffff0U;
  EXPECT_THROW(ScannerImages{data}, InvalidInput);
  data = images.data();
  data.direction.pop_back();
  EXPECT_THROW(ScannerImages{data}, InvalidInput);
  data = images.data();
  data.direction[5][1] = static_cast<std::int16_t>(data.shape.directions);
  EXPECT_THROW(ScannerImages{data}, InvalidInput);
  data = images.data();
  data.cells[5].receiverSide = 4;
  EXPECT_THROW(ScannerImages{data}, InvalidInput);
  data = images.data();
  data.shape.radius = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ScannerImages{data}, InvalidInput);
}

TEST(ScannerImages, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)computeScannerImages(testing::pinhole(), Progress(nullptr, stop.get_token(), 2)), Cancelled);
}

}  // namespace
}  // namespace vantage
