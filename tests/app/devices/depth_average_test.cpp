#include "devices/depth_average.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace vantage {
namespace {

// What becomes of one pixel with these depths.
float averageOf(const std::vector<std::uint16_t>& depths) {
  std::vector<DepthFrame> frames;
  for (const std::uint16_t depth : depths) frames.push_back({depth});
  return averageDepth(frames).front();
}

TEST(DepthAverage, IsTheMeanOfWhatAgrees) {
  EXPECT_FLOAT_EQ(averageOf({500}), 500.0F);
  EXPECT_FLOAT_EQ(averageOf({500, 501}), 500.5F);
  EXPECT_FLOAT_EQ(averageOf({500, 501, 501, 500, 501}), 500.6F);
}

TEST(DepthAverage, OutliersDoNotCount) {
  EXPECT_FLOAT_EQ(averageOf({500, 501, 500, 900, 501, 500, 500, 650}), 500.0F + 2.0F / 6.0F);
  EXPECT_FLOAT_EQ(averageOf({500, 500, 500, 500, 502}), 500.0F);
}

TEST(DepthAverage, NothingMeasuredIsNoDepthAndDoesNotCount) {
  EXPECT_FLOAT_EQ(averageOf({0, 0, 0}), 0.0F);
  EXPECT_FLOAT_EQ(averageOf({0, 500, 0, 500, 500, 0}), 500.0F);
  EXPECT_FLOAT_EQ(averageOf({0, 0, 500, 0, 0, 0}), 0.0F) << "one of six is too few";
}

TEST(DepthAverage, EveryPixelIsItsOwn) {
  const std::vector<float> average = averageDepth({{10, 0, 30}, {12, 0, 31}});
  EXPECT_EQ(average, (std::vector<float>{11.0F, 0.0F, 30.5F}));
}

TEST(DepthAverage, RefusesFramesThatDiffer) {
  EXPECT_THROW(static_cast<void>(averageDepth({})), InvalidInput);
  EXPECT_THROW(static_cast<void>(averageDepth({{1, 2}, {1}})), InvalidInput);
}

}  // namespace
}  // namespace vantage
