#include "session/session_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/io/expect_error.h"
#include "session/json_fields.h"

namespace vantage {
namespace {

using testing::expectError;

TEST(JsonFields, NameWhatIsDamagedAndTheField) {
  const nlohmann::json json = jsonObject(R"({"count": -1, "far": null, "flag": 1, "big": 3e9})", "step 7");
  const JsonFields fields(json, "step 7");
  EXPECT_EQ(fields.number("far"), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(fields.has("count"));
  expectError<InvalidInput>([&] { static_cast<void>(fields.count("count")); }, {"step 7", "count"});
  expectError<InvalidInput>([&] { static_cast<void>(fields.flag("flag")); }, {"step 7", "flag"});
  expectError<InvalidInput>([&] { static_cast<void>(fields.integer("big")); }, {"step 7", "big"});
  expectError<InvalidInput>([&] { static_cast<void>(fields.text("none")); }, {"step 7", "none"});
}

TEST(JsonFields, AreOfAnObjectThatIsNotNestedWithoutEnd) {
  EXPECT_THROW(static_cast<void>(jsonObject("[1]", "x")), InvalidInput);
  EXPECT_THROW(static_cast<void>(jsonObject("{\"a\": ", "x")), InvalidInput);
  const std::string deep = "{\"a\": " + std::string(1000, '[') + std::string(1000, ']') + "}";
  expectError<InvalidInput>([&] { static_cast<void>(jsonObject(deep, "record 2")); }, {"record 2", "too deep"});
}

TEST(SessionJson, NamesThatNobodyKnowsAreRefused) {
  expectError<InvalidInput>([] { static_cast<void>(terminationFromName("bored", "step 1")); }, {"step 1"});
  expectError<InvalidInput>([] { static_cast<void>(scanStatusFromName("left out", "view 3")); }, {"view 3", "status"});
}

TEST(SessionJson, APlanKeepsWhatItsForecastRestsOn) {
  Plan plan;
  plan.outcome = PlanOutcome::Finished;
  EXPECT_FALSE(planFromText(planText(plan), "plan 3").forecast.has_value());
  plan.forecast = PlanForecast{{1.0 / 3.0, 0.25}, SurfaceLeft{12.5, 0.0, 1.0 / 7.0}, true};
  const Plan read = planFromText(planText(plan), "plan 3");
  ASSERT_TRUE(read.forecast && read.forecast->left);
  EXPECT_EQ(read.forecast->trust.factor, 1.0 / 3.0);
  EXPECT_EQ(read.forecast->trust.spread, 0.25);
  EXPECT_TRUE(read.forecast->probing);
  EXPECT_EQ(read.forecast->left->area, 12.5);
  EXPECT_EQ(read.forecast->left->most, 1.0 / 7.0);
}

TEST(SessionJson, AStandStandsByARigidMotion) {
  std::vector<Stand> stands{{Pose::Identity()}, {}};
  EXPECT_FALSE(standsFromText(standsText(stands), "step 1")[1].T_object_table);
  stands[0].T_object_table->linear() *= 2.0;
  EXPECT_THROW(static_cast<void>(standsFromText(standsText(stands), "step 1")), InvalidInput);
  EXPECT_THROW(static_cast<void>(standsFromText(R"({"stands": []})", "step 1")), InvalidInput);
}

}  // namespace
}  // namespace vantage
