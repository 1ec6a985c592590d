// The turntables of the laboratory, whose firmwares were written by others. VANTAGE_LAB names its folder.
#include "laboratory.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "base/errors.h"
#include "devices/serial/table_device.h"

namespace vantage {
namespace {

using std::chrono::milliseconds;
using testing::LaboratoryTable;

struct Drive {
  LaboratoryTable lab;
  std::shared_ptr<SerialTurntable> table;

  Drive(const std::filesystem::path& folder, const std::vector<std::string>& options, const std::string& faults,
        const std::string& protocol)
      : lab(folder, options, faults), table(serialTurntable({lab.port(), protocol})) {
    table->open({});
  }

  // The sentence that a move ends with; "arrived" when the plate rests where the table says.
  std::string turn(double degrees, double truth) {
    try {
      const double said = table->turnTo(degrees, {}).degrees;
      if (std::abs(said - degrees) > 0.1) return "arrived elsewhere: " + std::to_string(said);
      if (lab.moving()) return "arrived, but it still moves";
      const double is = lab.truth();
      return std::abs(is - truth) < 0.1 ? "arrived" : "arrived, but is at " + std::to_string(is);
    } catch (const DeviceError& e) {
      return e.what();
    }
  }
};

std::string secondMove(const std::string& fault) {
  return R"([{"at": {"move": 2, "fraction": 0.5}, )" + fault + "}]";
}

// What becomes of a fault in the second move, by firmware: part of the sentence that must come.
struct Case {
  std::string fault;
  std::string says;
};

class Laboratory : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    folder_ = testing::laboratoryFolder();
    if (!folder_) GTEST_SKIP() << "no laboratory: set VANTAGE_LAB to the folder that holds lab_table";
  }

  [[nodiscard]] Drive drive(const std::string& faults, const std::string& protocol = GetParam()) const {
    return Drive(*folder_, {"--protocol", GetParam()}, faults, protocol);
  }
  // With one move for every turn.
  [[nodiscard]] static std::string inOneMove() {
    return GetParam() + (GetParam() == "fabscan" ? ":longest_move_deg=360" : "");
  }
  [[nodiscard]] bool reports() const { return GetParam() != "fabscan" && GetParam() != "comxim"; }
  [[nodiscard]] bool isGrbl() const { return GetParam() == "grbl" || GetParam() == "horus"; }

  // The fault comes in the second move; where it is noticed the table turns no more until it has a new reference.
  void expectLoss(const Case& c) const {
    SCOPED_TRACE(c.fault);
    Drive d = drive(secondMove(c.fault), inOneMove());
    EXPECT_EQ(d.turn(10.0, 10.0), "arrived");
    const std::string said = d.turn(40.0, 40.0);
    EXPECT_NE(said.find(c.says), std::string::npos) << said;
    EXPECT_EQ(d.table->angle(), std::nullopt);
    EXPECT_FALSE(d.turn(0.0, 0.0).starts_with("arrived"));
  }

  void expectArrival(const std::string& faults) const {
    SCOPED_TRACE(faults);
    Drive d = drive(faults);
    for (const double degrees : {10.0, 40.0, 30.0}) EXPECT_EQ(d.turn(degrees, degrees), "arrived");
  }

  std::optional<std::filesystem::path> folder_;
};

TEST_P(Laboratory, TurnsAndIsFoundByAsking) {
  Drive d = drive("[]", "");
  EXPECT_EQ(d.table->protocol(), GetParam());
  for (const double degrees : {10.0, -30.0, 90.0}) EXPECT_EQ(d.turn(degrees, degrees), "arrived");
  d.table->home({});
  EXPECT_EQ(d.turn(-90.0, 0.0), "arrived");
}

TEST_P(Laboratory, BytesThatComeInAnyPiecesAreUnderstood) {
  expectArrival(R"([{"at": {"time": 0}, "do": "split"}])");
  expectArrival(R"([{"at": {"time": 0}, "do": "merge"}])");
  for (const std::string kind : {"cr", "lf", "lfcr", "crcrlf"})
    expectArrival(R"([{"at": {"time": 0}, "do": "eol", "kind": ")" + kind + "\"}]");
  expectArrival(secondMove(R"("do": "garbage", "bytes": 60)"));
}

TEST_P(Laboratory, AnswersThatAreLateMissingOrTwiceAreNoArrival) {
  expectArrival(R"([{"at": {"move": 1}, "do": "late_ok", "count": 2}])");
  expectArrival(R"([{"at": {"time": 0}, "do": "double_ok", "count": 99}])");
  if (GetParam() != "fabscan") return expectArrival(secondMove(R"("do": "lost_ok", "count": 2)"));
  expectLoss({R"("do": "lost_ok")", "has not said within"});
}

TEST_P(Laboratory, ASlowTableIsWaitedFor) {
  expectArrival(secondMove(R"("do": "slow", "factor": 0.2)"));
}

TEST_P(Laboratory, ARestartLosesThePosition) {
  expectLoss({R"("do": "reset")", reports() ? "has restarted by itself" : "has not said within"});
}

TEST_P(Laboratory, AJamIsNoArrival) {
  expectLoss({R"("do": "jam")", reports() ? "is stuck" : "has not said within"});
}

TEST_P(Laboratory, SilenceIsWaitedForAndThenGivenUp) {
  if (reports()) expectArrival(secondMove(R"("do": "silence", "seconds": 4)"));
  expectLoss(
      {R"("do": "silence", "seconds": 60)", GetParam() == "fabscan" ? "has not said within" : "has not answered"});
}

TEST_P(Laboratory, AlarmDoorAndRefusalAreSaid) {
  if (isGrbl()) {
    expectLoss({R"("do": "alarm", "code": 1)", "a limit switch was touched"});
    Drive door = drive(secondMove(R"("do": "door")"));
    EXPECT_EQ(door.turn(10.0, 10.0), "arrived");
    EXPECT_NE(door.turn(40.0, 40.0).find("safety door is open"), std::string::npos);
    EXPECT_EQ(door.turn(40.0, 40.0), "arrived");
  }
  Drive refusing = drive(secondMove(R"("do": "error", "code": 20)"), inOneMove());
  EXPECT_EQ(refusing.turn(10.0, 10.0), "arrived");
  std::string said = refusing.turn(40.0, 40.0);
  if (said == "arrived") said = refusing.turn(70.0, 70.0);
  const bool told = said.find("refused to turn") != std::string::npos || said.find("sooner than") != std::string::npos;
  EXPECT_TRUE(told) << said;
}

TEST_P(Laboratory, UnpluggedItCanBeConnectedAgain) {
  Drive d = drive(secondMove(R"("do": "unplug", "seconds": 1)"), inOneMove());
  EXPECT_EQ(d.turn(10.0, 10.0), "arrived");
  const std::string said = d.turn(40.0, 40.0);
  EXPECT_NE(said.find("was unplugged"), std::string::npos) << said;
  EXPECT_EQ(d.table->status().state, TableState::Closed);
  for (int i = 0; i < 1000 && !std::filesystem::exists(d.lab.port()); ++i)
    std::this_thread::sleep_for(milliseconds(10));
  d.table->open({});
  const double here = d.lab.truth();
  EXPECT_EQ(d.turn(20.0, here + 20.0), "arrived");
}

TEST_P(Laboratory, AStopLeavesNothingUnknownThatTheTableTells) {
  Drive d = drive("[]");
  std::stop_source operator_;
  std::jthread button([&] {
    while (d.table->status().state != TableState::Moving) std::this_thread::sleep_for(milliseconds(5));
    std::this_thread::sleep_for(milliseconds(1000));
    operator_.request_stop();
  });
  EXPECT_THROW(static_cast<void>(d.table->turnTo(90.0, Progress({}, operator_.get_token(), 1))), Cancelled);
  if (GetParam() == "comxim") return;
  const TableStatus after = d.table->askStatus({});
  ASSERT_TRUE(after.angle);
  EXPECT_LT(after.angle->degrees, 80.0);
  EXPECT_NEAR(after.angle->degrees, d.lab.truth(), 0.1);
  EXPECT_EQ(d.turn(0.0, 0.0), "arrived");
}

INSTANTIATE_TEST_SUITE_P(Firmwares, Laboratory, ::testing::Values("grbl", "horus", "marlin", "fabscan", "comxim"),
                         [](const auto& firmware) { return firmware.param; });

struct Board {
  std::vector<std::string> options;
  std::string protocol;
};

TEST(LaboratoryBoards, AreUnderstoodHoweverTheyAreSet) {
  const auto folder = testing::laboratoryFolder();
  if (!folder) GTEST_SKIP() << "no laboratory: set VANTAGE_LAB to the folder that holds lab_table";
  const Board boards[] = {
      {{"--setting", "10=0"}, "grbl"},
      {{"--setting", "10=0", "--setting", "13=1", "--startup", "G54"}, "grbl"},
      {{"--setting", "10=2", "--startup", "G92 X5"}, "grbl"},
      {{"--axis", "a", "--units-per-turn", "40"}, "grbl:axis=A:units_per_turn=40"},
      {{"--axis", "z", "--direction", "cw"}, "grbl:axis=Z:sense=-1"},
      {{"--homing"}, "grbl"},
      {{"--ok-at", "arrival"}, "grbl"},
      {{"--protocol", "horus", "--ok-at", "queued"}, "horus"},
      {{"--protocol", "marlin", "--axis", "y", "--units-per-turn", "72"}, "marlin:axis=Y:units_per_turn=72"},
      {{"--protocol", "comxim", "--direction", "cw"}, "comxim:sense=-1"}};
  for (const Board& board : boards) {
    SCOPED_TRACE(board.protocol + " " + board.options.back());
    Drive d(*folder, board.options, "[]", board.protocol);
    for (const double degrees : {10.0, -50.0, 30.0}) EXPECT_EQ(d.turn(degrees, degrees), "arrived");
  }
}

}  // namespace
}  // namespace vantage
