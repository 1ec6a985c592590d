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

// Every kind of command, with a value that is not the one it has anyway.
std::vector<Command> someCommands() {
  Pose pose = Pose::Identity();
  pose.translate(Vec3(0.1, -2.0 / 3.0, 30.0));
  AcquisitionSettings settings;
  settings.simulation.seed = std::numeric_limits<std::uint64_t>::max();
  settings.planner.tolerance = 0.1;
  settings.strategy = parseStrategy("uniform:7");
  PositionScore predicted;
  predicted.position = 4;
  predicted.voidArea = 1.0 / 3.0;
  predicted.patches = {3, 5};
  return {ChangeSettings{settings},
          AddScan{5, predicted},
          ImportScans{{0, 2}},
          ChoosePosition{3},
          ChoosePosition{},
          LeaveOutView{1},
          TakeBackView{2},
          Finish{Termination::EndedByOperator},
          TakeOver{},
          TurnObject{pose},
          TurnObject{},
          PlaceStand{1, pose},
          ChangeMode{Mode::Assisted}};
}

TEST(SessionJson, EveryCommandComesBackToTheLastBit) {
  for (const Command& command : someCommands()) {
    const std::string text = commandText(command);
    const Command read = commandFromText(kindOf(command), text, "step 1");
    EXPECT_EQ(read.index(), command.index());
    EXPECT_EQ(commandText(read), text);
  }
  EXPECT_FALSE(std::get<ChoosePosition>(commandFromText("choose_position", R"({"position": -1})", "step 1")).position);
  const Command read = commandFromText("turn_object", commandText(someCommands()[9]), "step 1");
  EXPECT_EQ(std::get<TurnObject>(read).T_object_table->translation().y(), -2.0 / 3.0);
}

TEST(SessionJson, KindsAndNamesThatNobodyKnowsAreRefused) {
  EXPECT_THROW(static_cast<void>(commandFromText("explode", "{}", "step 1")), InvalidInput);
  EXPECT_THROW(static_cast<void>(commandFromText("finish", R"({"termination": "bored"})", "step 1")), InvalidInput);
  expectError<InvalidInput>([] { static_cast<void>(terminationFromName("bored", "step 1")); }, {"step 1"});
  expectError<InvalidInput>([] { static_cast<void>(scanStatusFromName("left out", "view 3")); }, {"view 3", "status"});
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
