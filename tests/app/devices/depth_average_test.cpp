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
  const std::vector<float> average = averageDepth({{1000, 0, 3000}, {1001, 0, 3001}});
  EXPECT_EQ(average, (std::vector<float>{1000.5F, 0.0F, 3000.5F}));
}

// What becomes of a pixel among others that see still surface.
float averageAtEdge(const std::vector<std::uint16_t>& depths) {
  std::vector<DepthFrame> frames;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const auto still = static_cast<std::uint16_t>(4498 + (3 * i) % 5);
    frames.push_back({still, still, depths[i], still});
  }
  return averageDepth(frames)[2];
}

// Next to an edge a depth is that of the front, or of anywhere between front and back.
TEST(DepthAverage, DepthsThatJumpAtAnEdgeAreTheFrontOrNone) {
  EXPECT_NEAR(averageAtEdge({4501, 4630, 4499, 4560, 4500, 4502, 4710, 4500, 4521, 4498}), 4500.0F, 1.0F);
  EXPECT_FLOAT_EQ(averageAtEdge({4501, 4630, 4500, 4560, 4540, 4502, 4710, 4660, 4521, 4590}), 0.0F);
  EXPECT_FLOAT_EQ(averageAtEdge({4500, 4600}), 0.0F);
}

// One pixel of ten frames tells little about the noise: all of them tell.
TEST(DepthAverage, WhatAgreesIsTheSameForAllPixels) {
  const std::vector<std::uint16_t> still{1000, 1004, 996, 1002, 998, 1003, 997, 1001, 999, 1000};
  const std::vector<std::uint16_t> lucky{1000, 1000, 1000, 1000, 1000, 1000, 1003, 1004, 997, 1030};
  std::vector<DepthFrame> frames;
  for (std::size_t i = 0; i < still.size(); ++i) frames.push_back({still[i], still[i], lucky[i]});
  const std::vector<float> average = averageDepth(frames);
  EXPECT_FLOAT_EQ(average[0], 1000.0F);
  EXPECT_FLOAT_EQ(average[2], 1000.0F + 4.0F / 9.0F);
}

TEST(DepthAverage, RefusesFramesThatDiffer) {
  EXPECT_THROW(static_cast<void>(averageDepth({})), InvalidInput);
  EXPECT_THROW(static_cast<void>(averageDepth({{1, 2}, {1}})), InvalidInput);
}

}  // namespace
}  // namespace vantage
