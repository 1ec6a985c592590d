#include "session/value_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/io/expect_error.h"

namespace vantage {
namespace {

using testing::expectError;

Pose somePose() {
  Pose pose = Pose::Identity();
  pose.translate(Vec3(0.1, -2.0 / 3.0, 30.0));
  pose.rotate(Eigen::AngleAxisd(1.0 / 3.0, Vec3::UnitY()));
  return pose;
}

TEST(ValueJson, PosesComeBackToTheLastBit) {
  const nlohmann::json json = nlohmann::json::parse(nlohmann::json{{"pose", poseJson(somePose())}}.dump());
  EXPECT_EQ(poseFrom(JsonFields(json, "view 1"), "pose").matrix(), somePose().matrix());
  const nlohmann::json cut{{"pose", {1.0, 2.0}}};
  expectError<InvalidInput>([&] { static_cast<void>(poseFrom(JsonFields(cut, "view 1"), "pose")); },
                            {"view 1", "pose"});
}

TEST(ValueJson, AStandThatNobodyKnowsIsNull) {
  EXPECT_TRUE(standPoseJson(std::nullopt).is_null());
  const nlohmann::json unknown{{"stand", standPoseJson(std::nullopt)}, {"known", standPoseJson(somePose())}};
  const JsonFields fields(unknown, "step 2");
  EXPECT_FALSE(standPoseFrom(fields, unknown, "stand"));
  EXPECT_FALSE(standPoseFrom(fields, unknown, "other"));
  ASSERT_TRUE(standPoseFrom(fields, unknown, "known"));
  EXPECT_EQ(standPoseFrom(fields, unknown, "known")->matrix(), somePose().matrix());
}

TEST(ValueJson, AStandStandsByARigidMotion) {
  Pose stretched = somePose();
  stretched.linear() *= 1.1;
  const nlohmann::json json{{"stand", standPoseJson(stretched)}};
  const JsonFields fields(json, "step 2");
  expectError<InvalidInput>([&] { static_cast<void>(standPoseFrom(fields, json, "stand")); }, {"step 2", "stand"});
}

TEST(ValueJson, WhatIsInfiniteIsNull) {
  const std::vector<double> values{1.5, std::numeric_limits<double>::infinity(), 3.0};
  EXPECT_EQ(numberList(values, 2).dump(), "[1.5,null]");
}

TEST(ValueJson, APredictionKeepsThePatchesThatAScoreLeavesOut) {
  PositionScore score;
  score.position = 4;
  score.voidArea = 1.0 / 3.0;
  score.patches = {3, 5};
  score.uncorrected = 2.0 / 3.0;
  const nlohmann::json prediction = predictionJson(score);
  const PositionScore read = predictionFrom(JsonFields(prediction, "step 2"));
  EXPECT_EQ(read.position, 4);
  EXPECT_EQ(read.voidArea, 1.0 / 3.0);
  EXPECT_EQ(read.patches, score.patches);
  EXPECT_EQ(read.uncorrected, score.uncorrected);
  const nlohmann::json stored = storedScoreJson(score);
  EXPECT_TRUE(scoreFrom(JsonFields(stored, "plan 2")).patches.empty());
}

}  // namespace
}  // namespace vantage
