#include "io/no_sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stop_token>

#include "base/errors.h"
#include "geometry/mesh.h"

namespace vantage {
namespace {

constexpr int kRows = 40;
constexpr int kColumns = 50;

// A cap with some noise before it, and `behind` where it is not.
SampleGrid capBefore(const std::function<Vec3(int, int)>& behind, double noise = 0.01) {
  SampleGrid grid{kRows, kColumns, {}, {}};
  for (int r = 0; r < kRows; ++r) {
    for (int c = 0; c < kColumns; ++c) {
      const double x = c - 25.0;
      const double y = r - 20.0;
      const double aside = x * x + y * y;
      const Vec3 cap(x, y,
                     300.0 - std::sqrt(std::max(0.0, 225.0 - aside)) + noise * std::sin(12.9898 * r + 78.233 * c));
      grid.cell.push_back(static_cast<std::uint32_t>(grid.points.size()));
      grid.points.push_back(aside < 196.0 ? cap : behind(r, c));
    }
  }
  return grid;
}

std::size_t outside() {
  std::size_t count = 0;
  for (int r = 0; r < kRows; ++r)
    for (int c = 0; c < kColumns; ++c) count += std::pow(c - 25.0, 2) + std::pow(r - 20.0, 2) < 196.0 ? 0U : 1U;
  return count;
}

void expectDropped(SampleGrid grid, NoSampleMark mark, std::optional<double> given = {}) {
  const NoSamples found = dropNoSamples(grid, given);
  EXPECT_EQ(found.mark, mark);
  EXPECT_EQ(found.dropped, outside());
  EXPECT_EQ(grid.points.size(), kRows * kColumns - outside());
  for (const Vec3& p : grid.points) EXPECT_NEAR(p.z(), 292.0, 8.1);
}

TEST(NoSample, IsAPointThatManyCellsShare) {
  expectDropped(capBefore([](int, int) { return Vec3::Zero(); }), NoSampleMark::Zero);
  expectDropped(capBefore([](int, int) { return Vec3(-1, -1, -1); }), NoSampleMark::Repeated);
  expectDropped(capBefore([](int, int) { return Vec3(1e9, 1e9, 1e9); }), NoSampleMark::Repeated);
}

TEST(NoSample, IsAConstantDepthFarBehindTheRest) {
  const auto alongRay = [](double depth) {
    return [depth](int r, int c) { return Vec3((c - 25.0) * depth / 300.0, (r - 20.0) * depth / 300.0, depth); };
  };
  expectDropped(capBefore(alongRay(4000.0)), NoSampleMark::FarPlane);
  expectDropped(capBefore(alongRay(-1.0)), NoSampleMark::FarPlane);
  expectDropped(capBefore(alongRay(330.0)), NoSampleMark::FarPlane);
}

TEST(NoSample, IsANumberOutOfAllProportion) {
  SampleGrid grid =
      capBefore([](int r, int c) { return Vec3(c, r, r < 5 ? 1e9 + r * 1e6 + c : 300.0 + 0.001 * r * c); });
  const NoSamples found = dropNoSamples(grid, {});
  EXPECT_EQ(found.mark, NoSampleMark::Outlier);
  EXPECT_EQ(found.dropped, 5U * kColumns);
}

// Along one axis a wall is as thin as its noise.
TEST(NoSample, IsNoObjectBeforeAWall) {
  SampleGrid grid = capBefore([](int r, int c) { return Vec3(c, r, 0.0); });
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const double wave = std::sin(static_cast<double>(i));
    grid.points[i].z() = i < 5U * kColumns ? 300.0 + wave : 700.0 + 0.001 * wave;
  }
  EXPECT_EQ(dropNoSamples(grid, {}).dropped, 0U);
}

TEST(NoSample, IsWhatTheOperatorSays) {
  const auto table = [](int r, int c) { return Vec3(c - 25.0, r - 20.0, 301.0); };
  expectDropped(capBefore(table), NoSampleMark::Given, 301.0);
}

TEST(NoSample, IsNoTableThatTheObjectLiesOn) {
  const auto table = [](int r, int c) { return Vec3(c - 25.0, r - 20.0, 301.0); };
  for (const double noise : {0.0, 0.01}) {
    SampleGrid grid = capBefore(table, noise);
    EXPECT_EQ(dropNoSamples(grid, {}).dropped, 0U);
    EXPECT_EQ(grid.points.size(), static_cast<std::size_t>(kRows * kColumns));
  }
}

TEST(NoSample, IsNoSinglePointAtTheOrigin) {
  SampleGrid grid = capBefore([](int r, int c) { return Vec3(c, r, 300.0 + 0.001 * r * c); });
  grid.points[3] = Vec3::Zero();
  EXPECT_EQ(dropNoSamples(grid, {}).dropped, 0U);
}

TEST(NoSample, OfMarksThatAreAsFrequentIsEveryOne) {
  SampleGrid grid = capBefore([](int r, int) { return r % 2 == 0 ? Vec3(-1, -1, 300) : Vec3(5, 2, 300); });
  EXPECT_EQ(dropNoSamples(grid, {}).dropped, outside());
}

TEST(NoSample, IsAPointWhicheverSignItsZerosHave) {
  SampleGrid grid = capBefore([](int, int c) { return Vec3(c % 2 == 0 ? 0.0 : -0.0, 7, 300); });
  EXPECT_EQ(dropNoSamples(grid, {}).dropped, outside());
}

TEST(NoSample, CanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  SampleGrid grid = capBefore([](int, int) { return Vec3::Zero(); });
  EXPECT_THROW(static_cast<void>(dropNoSamples(grid, {}, Progress({}, stop.get_token(), 1))), Cancelled);
}

}  // namespace
}  // namespace vantage
