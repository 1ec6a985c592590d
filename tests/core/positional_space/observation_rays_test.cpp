#include "positional_space/observation_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "support/scenes/small_profiles.h"

namespace vantage {
namespace {

const double kBreakdown = radians(60.0);

ObservationBatch listed(const ScannerImages& images, const CellLookup& lookup,
                        const std::vector<ObservationSource>& sources) {
  ObservationRays rays(images, lookup, kBreakdown, {});
  ObservationBatch batch;
  for (std::size_t s = 0; s < sources.size(); ++s) rays.append(sources[s], static_cast<std::uint32_t>(s), batch);
  return batch;
}

// By how much a source is seen through a cell, in shares of what is asked for: positive when every condition holds.
struct Meeting {
  double margin;
  double confidence;
};

// Where the ranging ray of a cell that passes through the source crosses the surface cell (see accumulate), without
// leaving anything out beforehand.
Meeting meet(const ScannerImages& images, std::uint32_t number, const ObservationSource& source) {
  const PositionalCell at = images.cell(number);
  const SurfaceCell& surface = images.grid().surfaceCell(at.row, at.column);
  const OccupiedCell& cell = images.data().cells[number % images.data().cells.size()];
  const Vec3 d = surface.centre - source.centre;
  const double h = d.dot(surface.normal);
  if (h <= 0.0) return {h, 0.0};
  Eigen::Matrix2d fan;
  fan << cell.fan[0], cell.fan[1], cell.fan[2], cell.fan[3];
  const Vec2 off = h * Vec2(cell.slope[0], cell.slope[1]) - Vec2(d.dot(surface.across), d.dot(surface.up));
  const Vec2 delta = (Eigen::Matrix2d::Identity() - h * fan).inverse() * off;
  const Vec3 ray = d + delta.x() * surface.across + delta.y() * surface.up;
  const double cosine = ray.dot(source.normal) / ray.norm();
  const double outward = static_cast<double>(cell.sourceDistance);
  const double width = surface.halfWidth * (1.0 - surface.taper * delta.y());
  const double margin =
      std::min({1.0 - std::abs(delta.y()) / surface.halfHeight, 1.0 - std::abs(delta.x()) / width,
                cosine / std::cos(kBreakdown) - 1.0, (ray.norm() + outward) / images.data().minRange - 1.0,
                1.0 - (ray.norm() + outward) / images.data().maxRange});
  return {margin, cosine};
}

TEST(ObservationRays, ListEveryCellThatASourceMeetsAndNoOther) {
  const auto sources = testing::scatteredSources(40);
  for (const ScannerProfile& profile : testing::everyKind()) {
    const ScannerImages images = computeScannerImages(profile);
    const CellLookup lookup(images);
    const ObservationBatch batch = listed(images, lookup, sources);
    std::vector<std::map<std::uint32_t, double>> met(sources.size());
    for (const Observation& o : batch.observations)
      for (std::uint32_t k = o.first; k < o.first + o.count; ++k)
        met[o.source][batch.cells[k].cell] = static_cast<double>(batch.cells[k].confidence());
    std::size_t compared = 0;
    for (std::size_t s = 0; s < sources.size(); ++s) {
      for (std::uint32_t cell = 0; cell < images.cellCount(); ++cell) {
        const Meeting expected = meet(images, cell, sources[s]);
        // Nearer to a border, single precision decides.
        if (std::abs(expected.margin) < 1e-3) continue;
        const auto found = met[s].find(cell);
        ASSERT_EQ(found != met[s].end(), expected.margin > 0.0)
            << profile.type << ", source " << s << ", cell " << cell;
        if (found == met[s].end()) continue;
        ASSERT_NEAR(found->second, expected.confidence, 1e-3);
        ++compared;
      }
    }
    EXPECT_GT(compared, 500U) << profile.type;
  }
}

TEST(ObservationRays, AreTheSameBytesWithTheInstructionsOfAnyMachine) {
  const auto sources = testing::scatteredSources(200);
  for (const ScannerProfile& profile : testing::everyKind()) {
    const ScannerImages images = computeScannerImages(profile);
    const ObservationBatch fast = listed(images, CellLookup(images), sources);
    const ObservationBatch portable = listed(images, CellLookup(images, CellLookup::Lanes::Portable), sources);
    ASSERT_GT(fast.rays.size(), 1000U);
    const auto same = [](const auto& a, const auto& b) {
      return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
    };
    EXPECT_TRUE(same(fast.rays, portable.rays));
    EXPECT_TRUE(same(fast.observations, portable.observations));
    EXPECT_TRUE(same(fast.cells, portable.cells));
  }
}

}  // namespace
}  // namespace vantage
