#include "session/command_json.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/io/expect_error.h"

namespace vantage {
namespace {

using testing::expectError;

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
          TakeAsFrom{2, 131.5},
          Finish{Termination::EndedByOperator},
          TakeOver{},
          TurnObject{pose},
          TurnObject{},
          PlaceStand{1, pose},
          TurnObject{{}, Vec3(0.0, 0.6, 0.8)},
          AlignStand{1, {{Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3)}}},
          AlignStand{2},
          ChooseStandPose{1, 2, true},
          TakeReference{1},
          ChangeMode{Mode::Assisted},
          EraseRegion{1, NearPoints{{Vec3(1.0 / 3.0, 2, 3), Vec3(4, 5, 6)}, 0.1}, true},
          TakeBackErasure{3}};
}

TEST(CommandJson, EveryKindOfCommandComesBackToTheLastBit) {
  std::set<std::size_t> kinds;
  for (const Command& command : someCommands()) {
    const std::string text = commandText(command);
    const Command read = commandFromText(kindOf(command), text, "step 1");
    EXPECT_EQ(read.index(), command.index());
    kinds.insert(read.index());
    EXPECT_EQ(commandText(read), text);
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Command>) << "a kind of command is missing above";
  EXPECT_FALSE(std::get<ChoosePosition>(commandFromText("choose_position", R"({"position": -1})", "step 1")).position);
  const Command read = commandFromText("turn_object", commandText(someCommands()[10]), "step 1");
  EXPECT_EQ(std::get<TurnObject>(read).T_object_table->translation().y(), -2.0 / 3.0);
}

TEST(CommandJson, KindsAndValuesThatNobodyKnowsAreRefused) {
  EXPECT_THROW(static_cast<void>(commandFromText("explode", "{}", "step 1")), InvalidInput);
  expectError<InvalidInput>(
      [] { static_cast<void>(commandFromText("finish", R"({"termination": "bored"})", "step 1")); },
      {"step 1", "termination"});
  expectError<InvalidInput>([] { static_cast<void>(commandFromText("leave_out", R"({"scan": -4})", "step 1")); },
                            {"step 1", "scan"});
  expectError<InvalidInput>([] { static_cast<void>(commandFromText("place_stand", R"({"stand": 1})", "step 1")); },
                            {"step 1", "T_object_table"});
}

}  // namespace
}  // namespace vantage
