#include <gtest/gtest.h>

#include <set>

#include "charts/objective_chart.h"
#include "charts/scanner_picture_chart.h"
#include "charts/unrolled_map_chart.h"

namespace vantage {
namespace {

constexpr QRectF kArea(0.0, 0.0, 500.0, 400.0);

// Twelve positions on a turn, without anything to show.
ObjectiveChartData twelve() {
  ObjectiveChartData data;
  for (int i = 0; i < 12; ++i) {
    ObjectiveChartData::Position position;
    position.azimuth = radians(30.0 * i);
    data.positions.push_back(position);
  }
  return data;
}

// Middle of the dial painted in kArea, found as the mean of what belongs to opposite positions.
TEST(ObjectiveChart, ADialHasZeroDegreesToTheRightAndRunsCounterClockwise) {
  const ObjectiveChartData data = twelve();
  std::array<QPointF, 12> sum{};
  std::array<int, 12> count{};
  for (int y = 0; y < 400; y += 2)
    for (int x = 0; x < 500; x += 2) {
      const auto position = positionAt(QPointF(x, y), kArea, data, ObjectiveStyle::Dial);
      if (!position) continue;
      sum[static_cast<std::size_t>(*position)] += QPointF(x, y);
      ++count[static_cast<std::size_t>(*position)];
    }
  for (const int n : count) ASSERT_GT(n, 0);
  const QPointF right = sum[0] / count[0];
  const QPointF top = sum[3] / count[3];
  const QPointF left = sum[6] / count[6];
  EXPECT_GT(right.x(), left.x() + 50.0);
  EXPECT_NEAR(right.y(), left.y(), 4.0);
  EXPECT_LT(top.y(), right.y() - 50.0);
}

TEST(ObjectiveChart, BarsRunThroughThePositionsFromLeftToRight) {
  const ObjectiveChartData data = twelve();
  std::optional<int> before;
  for (int x = 0; x < 500; ++x) {
    const auto position = positionAt(QPointF(x, 200.0), kArea, data, ObjectiveStyle::Bars);
    if (!position) continue;
    EXPECT_GE(position, before);
    before = position;
  }
  EXPECT_EQ(before, 11);
}

TEST(ObjectiveChart, SeveralTiltsLieSideBySideAndEachCanBePicked) {
  ObjectiveChartData data;
  for (const double tilt : {0.5, 0.1, 0.3})
    for (int i = 0; i < 12; ++i) {
      ObjectiveChartData::Position position;
      position.azimuth = std::remainder(radians(30.0 * i), 2.0 * kPi);
      position.tilt = tilt;
      data.positions.push_back(position);
    }
  layTiltsAside(data);
  EXPECT_EQ(data.tilts, 3);
  for (int i = 0; i < 12; ++i) {
    const auto aside = [&](int tilt) { return data.positions[static_cast<std::size_t>(12 * tilt + i)].aside; };
    EXPECT_NEAR(aside(1), -radians(10.0), 1e-9) << "the lowest";
    EXPECT_NEAR(aside(2), 0.0, 1e-9);
    EXPECT_NEAR(aside(0), radians(10.0), 1e-9) << "the highest";
  }
  std::set<int> picked;
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 500; ++x)
      if (const auto position = positionAt(QPointF(x, y), kArea, data, ObjectiveStyle::Dial)) picked.insert(*position);
  EXPECT_EQ(picked.size(), 36U);
}

TEST(ObjectiveChart, OutsideIsNoPosition) {
  for (const auto style : {ObjectiveStyle::Dial, ObjectiveStyle::Bars}) {
    EXPECT_EQ(positionAt({1.0, 1.0}, kArea, twelve(), style), std::nullopt);
    EXPECT_EQ(positionAt({250.0, 200.0}, kArea, {}, style), std::nullopt);
  }
}

TEST(UnrolledMap, ColumnsBeginAtTheAzimuthOfTheFirstAndRowsBelow) {
  PositionalSpaceShape shape;
  shape.rows = 4;
  shape.columns = 8;
  shape.firstColumn = radians(-22.5);
  const auto low = cellAt({100.0, 340.0}, kArea, shape);
  ASSERT_TRUE(low.has_value());
  EXPECT_EQ(low->row, 0);
  std::vector<int> columns;
  for (int x = 0; x < 500; ++x) {
    const auto cell = cellAt({static_cast<double>(x), 200.0}, kArea, shape);
    if (cell && (columns.empty() || columns.back() != cell->column)) columns.push_back(cell->column);
  }
  // Column 0 lies about azimuth 0: it is met at both ends of the map.
  EXPECT_EQ(columns, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 0}));
}

TEST(ScannerPictureChart, StandsUprightWhateverTheOrderOfTheRays) {
  ScannerPicture picture;
  picture.rows = 2;
  picture.columns = 3;
  picture.sight.assign(6, RaySight::Nothing);
  picture.cosine.assign(6, 1.0F);
  picture.sight[0] = RaySight::Void;
  const QRgb voidColour = toColour(categoryColour(1)).rgb();
  EXPECT_EQ(toImage(picture, lightTheme()).pixel(0, 0), voidColour);
  picture.rowsUp = true;
  EXPECT_EQ(toImage(picture, lightTheme()).pixel(0, 1), voidColour);
  picture.columnsLeft = true;
  EXPECT_EQ(toImage(picture, lightTheme()).pixel(2, 1), voidColour);
}

}  // namespace
}  // namespace vantage
