#include "scanner/scan_use.h"

#include <gtest/gtest.h>

#include <stop_token>

#include "base/errors.h"
#include "scanner/ray_patterns.h"
#include "scanner/triangulation.h"

namespace vantage {
namespace {

// A wall 300 mm before a camera at (300, 0, 0), and a piece of 3 x 3 samples 60 mm before it.
std::shared_ptr<const RangeImage> wallWithCrumb(int rows = 60, int columns = 80) {
  RangeImage image;
  image.rays = std::make_shared<const RayGrid>(
      makeRays(Pinhole{Vec3(300, 0, 0), Vec3::Zero(), rows, columns, radians(30), radians(30)}, {}));
  for (std::size_t i = 0; i < image.rays->size(); ++i)
    image.range.push_back(static_cast<float>(-300.0 / image.rays->ray(i).direction.x()));
  for (int r = 20; r < 23; ++r)
    for (int c = 30; c < 33; ++c) image.range[image.rays->index(r, c)] -= 60.0F;
  return std::make_shared<const RangeImage>(std::move(image));
}

ScanUse withoutIslands(std::optional<double> spacing) {
  ScanUse use{{}, {spacing}};
  use.cut.options.smallestIsland = 12;
  return use;
}

TEST(ScanUse, IsTheImageItselfWhereNothingIsCutOrThinned) {
  const auto image = wallWithCrumb();
  const UsedImage used = usedImage(image, {});
  EXPECT_EQ(used.image, image);
  EXPECT_EQ(used.everyNth, 1);
  EXPECT_EQ(used.samples, image->sampleCount());
  EXPECT_EQ(cutSamples(used.cut), 0U);
}

TEST(ScanUse, CutsTheScanAsItCameAndThinsWhatIsLeft) {
  const auto image = wallWithCrumb();
  const double spacing = triangulate(*image, {}).spacing;
  const UsedImage used = usedImage(image, withoutIslands(2.9 * spacing));
  EXPECT_EQ(used.everyNth, 2);
  EXPECT_EQ(cutSamples(used.cut), 9U) << "a piece of 9 samples would be one of 1 to 4 if it were thinned before";
  EXPECT_EQ(used.samples, image->sampleCount() - 9U);
  EXPECT_EQ(used.image->rays->rows(), 30);
  for (std::size_t i = 0; i < used.image->range.size(); ++i) {
    const std::size_t before = rayBeforeThinning(*image->rays, 2, i);
    const int row = static_cast<int>(before) / 80;
    const int column = static_cast<int>(before) % 80;
    if (row >= 20 && row < 23 && column >= 30 && column < 33)
      EXPECT_FALSE(used.image->valid(i));
    else
      EXPECT_EQ(used.image->range[i], image->range[before]);
  }
}

TEST(ScanUse, ThinnedScansOfOneScannerShareTheirRays) {
  const auto image = wallWithCrumb();
  const ScanUse use{{}, {3.0 * triangulate(*image, {}).spacing}};
  const UsedImage first = usedImage(image, use);
  const UsedImage second = usedImage(std::make_shared<const RangeImage>(*image), use, first.image->rays);
  EXPECT_EQ(first.image->rays, second.image->rays);
  EXPECT_NE(first.image->rays, image->rays);
}

TEST(ScanUse, OfTheSameScanIsTheSameForAnyNumberOfThreads) {
  const auto image = wallWithCrumb(300, 310);
  const UsedImage one = usedImage(image, withoutIslands({}));
  const UsedImage four = usedImage(image, withoutIslands({}), nullptr, Progress().withThreads(4));
  EXPECT_EQ(one.cut, four.cut);
  for (std::size_t i = 0; i < one.image->range.size(); ++i) ASSERT_EQ(one.image->valid(i), four.image->valid(i));
  const ViewMesh a = triangulate(*one.image, {});
  const ViewMesh b = triangulate(*four.image, {}, Progress().withThreads(4));
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.sample, b.sample);
  EXPECT_EQ(a.spacing, b.spacing);
  EXPECT_EQ(a.onBoundary, b.onBoundary);
}

TEST(ScanUse, CanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  const Progress stopped({}, stop.get_token(), 1);
  const auto image = wallWithCrumb();
  EXPECT_THROW(static_cast<void>(usedImage(image, withoutIslands({}), nullptr, stopped)), Cancelled);
  EXPECT_THROW(static_cast<void>(usedImage(image, {}, nullptr, stopped)), Cancelled);
  EXPECT_THROW(static_cast<void>(triangulate(*image, {}, stopped)), Cancelled);
}

}  // namespace
}  // namespace vantage
