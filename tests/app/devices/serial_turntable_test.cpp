#include "devices/serial/serial_turntable.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/errors.h"
#include "program/installed_files.h"
#include "devices/serial/serial_port.h"
#include "devices/serial/table_device.h"
#include "devices/serial/table_recognition.h"
#include "stand_in_table.h"

namespace vantage {
namespace {

using testing::Mishap;
using testing::StandInFirmware;
using testing::StandInOptions;
using testing::StandInTable;

// A table that is connected to a stand-in.
struct Bench {
  StandInTable standIn;
  std::shared_ptr<SerialTurntable> table;

  explicit Bench(std::unique_ptr<StandInFirmware> firmware, const std::string& protocol = "grbl:settle_s=0")
      : standIn(std::move(firmware)), table(serialTurntable({standIn.port(), protocol})) {
    table->open({});
  }

  [[nodiscard]] double turned(double degrees) const { return table->turnTo(degrees, {}).degrees; }

  // The sentence that a move ends with.
  [[nodiscard]] std::string messageOf(double degrees) const {
    try {
      static_cast<void>(table->turnTo(degrees, {}));
    } catch (const DeviceError& e) {
      return e.what();
    }
    return "arrived";
  }
};

void expectIn(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

// What a firmware is asked for, and its stand-in.
struct Firmware {
  const char* protocol;
  std::unique_ptr<StandInFirmware> (*make)(const StandInOptions&);
  double unitsPerDegree;
  PoseSource knownBy;
};
const Firmware kFirmwares[] = {
    {"grbl", testing::grblStandIn, 1.0, PoseSource::Reported},
    {"marlin", testing::marlinStandIn, 1.0, PoseSource::Reported},
    {"fabscan", testing::fabscanStandIn, 3200.0 / 360.0, PoseSource::Commanded},
    {"comxim", testing::comximStandIn, 1.0, PoseSource::Commanded},
};

// At the speed of the stand-ins, for objects that do not tremble.
std::string protocolOf(const Firmware& firmware) {
  const std::string name = firmware.protocol;
  return name + ":settle_s=0" + (name == "fabscan" ? ":fastest_deg_s=20000" : "");
}

// One move of the table for every turn, so that a mishap comes in the second of them.
std::string inOneMove(const Firmware& firmware) {
  return protocolOf(firmware) + (firmware.protocol == std::string("fabscan") ? ":longest_move_deg=360" : "");
}

Bench bench(const Firmware& firmware, Mishap mishap) {
  return Bench(firmware.make({.mishap = mishap, .unitsPerDegree = firmware.unitsPerDegree}),
               mishap == Mishap::None ? protocolOf(firmware) : inOneMove(firmware));
}

TEST(SerialTurntable, TurnsToAnglesWithEveryFirmware) {
  for (const Firmware& firmware : kFirmwares) {
    SCOPED_TRACE(firmware.protocol);
    const Bench b = bench(firmware, Mishap::None);
    EXPECT_EQ(b.table->angle()->degrees, 0.0);
    // A step of the coarsest is 0.1125 degrees.
    for (const double degrees : {30.0, -15.0, -15.0, 375.0}) EXPECT_NEAR(b.turned(degrees), degrees, 0.06);
    EXPECT_EQ(b.table->angle()->knownBy, firmware.knownBy);
    b.table->home({});
    EXPECT_EQ(b.table->angle()->degrees, 0.0);
    EXPECT_NEAR(b.table->jog(-10.0, {})->degrees, -10.0, 0.06);
    EXPECT_EQ(b.table->notReady(), std::nullopt);
  }
}

TEST(SerialTurntable, DoesNotAddUpTheRoundingOfItsMoves) {
  const Bench b = bench(kFirmwares[2], Mishap::None);
  double degrees = 0.0;
  for (int i = 1; i <= 7; ++i) degrees = b.turned(360.0 * i / 7.0);
  EXPECT_EQ(degrees, 360.0) << "a seventh of a turn is no whole number of steps";
}

TEST(SerialTurntable, FindsOutTheProtocolByAsking) {
  for (const Firmware& firmware : kFirmwares) {
    const Bench b(firmware.make({.unitsPerDegree = firmware.unitsPerDegree}), "");
    EXPECT_EQ(b.table->protocol(), firmware.protocol);
    expectIn(b.table->identity(), b.table->title() + " turntable on /dev/");
  }
}

TEST(SerialTurntable, ThatSpeaksAnotherProtocolSaysWhatItSends) {
  const StandInTable standIn(testing::marlinStandIn({}));
  const auto table = serialTurntable({standIn.port(), "grbl"});
  try {
    table->open({});
    FAIL() << "opened";
  } catch (const DeviceError& e) {
    expectIn(e.what(), "does not answer as GRBL 1.1");
    expectIn(e.what(), "Marlin 2.1.2");
  }
  EXPECT_EQ(*table->notReady(), "is not connected");
  EXPECT_THROW(static_cast<void>(table->turnTo(10.0, {})), DeviceError);
}

TEST(SerialTurntable, UnderstandsHowTheBoardIsSet) {
  const StandInOptions boards[] = {{.workOnly = true, .offset = 7.0},
                                   {.inches = true},
                                   {.workOnly = true, .inches = true, .offset = -3.0},
                                   {.noise = true},
                                   {.locked = true}};
  for (const StandInOptions& options : boards) {
    const Bench b(testing::grblStandIn(options));
    EXPECT_NEAR(b.turned(30.0), 30.0, 0.01);
    EXPECT_NEAR(b.turned(-90.0), -90.0, 0.01);
    b.table->home({});
    EXPECT_NEAR(b.turned(10.0), 10.0, 0.01);
  }
  const Bench rotary(testing::grblStandIn({.axis = 3, .axes = 4, .unitsPerDegree = 40.0 / 360.0}),
                     "grbl:settle_s=0:axis=A:units_per_turn=40:sense=-1");
  EXPECT_NEAR(rotary.turned(90.0), 90.0, 0.01);
}

// What becomes of the second move; where it stands is not known afterwards.
struct Loss {
  Mishap mishap;
  int firmware;
  const char* says;
};

TEST(SerialTurntable, SaysWhyItDoesNotKnowWhereItStandsAndGoesOnFromANewReference) {
  const Loss losses[] = {{Mishap::Restart, 0, "has restarted by itself"},
                         {Mishap::Restart, 1, "has restarted by itself"},
                         {Mishap::Alarm, 0, "a limit switch was touched"},
                         {Mishap::StopsShort, 0, "degrees away from where it was told to go"},
                         {Mishap::Jam, 0, "is stuck"},
                         {Mishap::Jam, 1, "is stuck"}};
  for (const Loss& loss : losses) {
    const Bench b = bench(kFirmwares[loss.firmware], loss.mishap);
    static_cast<void>(b.turned(10.0));
    const std::string message = b.messageOf(50.0);
    SCOPED_TRACE(message);
    expectIn(message, b.table->identity());
    expectIn(message, loss.says);
    expectIn(message, "set the reference anew");
    EXPECT_EQ(b.table->angle(), std::nullopt);
    EXPECT_TRUE(b.table->notReady());
    EXPECT_NE(b.messageOf(0.0), "arrived") << "it turns nowhere before it has a reference";
    b.table->home({});
    EXPECT_NEAR(b.turned(10.0), 10.0, 0.01);
  }
}

TEST(SerialTurntable, AnEndThatIsNeverToldIsNoArrival) {
  for (const int i : {2, 3}) {
    const Firmware& firmware = kFirmwares[i];
    const Bench b(firmware.make({.mishap = Mishap::EndLost, .unitsPerDegree = firmware.unitsPerDegree}),
                  inOneMove(firmware) + ":slowest_deg_s=100");
    static_cast<void>(b.turned(10.0));
    expectIn(b.messageOf(20.0), "has not said within 5 s that it has arrived");
    EXPECT_EQ(b.table->angle(), std::nullopt);
  }
}

TEST(SerialTurntable, WhatIsSilentIsGivenUp) {
  const Bench b = bench(kFirmwares[0], Mishap::Silence);
  static_cast<void>(b.turned(10.0));
  expectIn(b.messageOf(50.0), "has not answered for 8 s");
  EXPECT_EQ(b.table->angle(), std::nullopt);
}

TEST(SerialTurntable, ARefusalLeavesItWhereItWas) {
  for (const int i : {0, 1, 3}) {
    const Bench b = bench(kFirmwares[i], Mishap::Refuses);
    const double before = b.turned(10.0);
    expectIn(b.messageOf(50.0), "refused to turn (error:");
    EXPECT_NEAR(b.table->askStatus({}).angle->degrees, before, 0.01);
  }
}

TEST(SerialTurntable, ADoorStopsItAndItGoesOnWhenToldTo) {
  const Bench b = bench(kFirmwares[0], Mishap::Door);
  static_cast<void>(b.turned(10.0));
  expectIn(b.messageOf(50.0), "its safety door is open");
  EXPECT_NEAR(b.turned(50.0), 50.0, 0.01);
}

TEST(SerialTurntable, ArrivesWithoutAnOkAndThoughACommandWasLost) {
  for (const auto& [firmware, mishap] :
       {std::pair{0, Mishap::OkLost}, {0, Mishap::CommandLost}, {1, Mishap::OkLost}, {3, Mishap::OkLost}}) {
    const Bench b = bench(kFirmwares[firmware], mishap);
    static_cast<void>(b.turned(10.0));
    EXPECT_NEAR(b.turned(50.0), 50.0, 0.01);
  }
}

TEST(SerialTurntable, StopsAndSaysWhatIsThenKnown) {
  for (const Firmware& firmware : kFirmwares) {
    SCOPED_TRACE(firmware.protocol);
    const Bench b = bench(firmware, Mishap::None);
    std::jthread operator_([&] {
      while (b.table->status().state != TableState::Moving) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      b.table->stop();
    });
    EXPECT_THROW(static_cast<void>(b.table->turnTo(350.0, {})), Cancelled);
    const TableStatus after = b.table->askStatus({});
    if (firmware.protocol == std::string("comxim")) {
      EXPECT_EQ(after.angle, std::nullopt) << "it does not tell where it was stopped";
      expectIn(*b.table->notReady(), "was stopped");
    } else {
      ASSERT_TRUE(after.angle);
      EXPECT_GT(after.angle->degrees, 5.0);
      EXPECT_LT(after.angle->degrees, 345.0);
      EXPECT_NEAR(after.angle->degrees, b.standIn.degrees(), 0.01);
      EXPECT_NEAR(b.turned(0.0), 0.0, 0.01);
      EXPECT_NEAR(b.standIn.degrees(), 0.0, 0.01);
    }
  }
}

// It can neither be stopped nor asked, and what is under way takes longer than who stops it waits.
TEST(SerialTurntable, WaitsForTheEndOfAMoveThatItWasStoppedInBeforeTheNext) {
  const Bench b(testing::fabscanStandIn({.unitsPerDegree = kFirmwares[2].unitsPerDegree}), inOneMove(kFirmwares[2]));
  std::jthread operator_([&] {
    while (b.table->status().state != TableState::Moving) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    b.table->stop();
  });
  EXPECT_THROW(static_cast<void>(b.table->turnTo(350.0, {})), Cancelled);
  ASSERT_TRUE(b.table->angle());
  EXPECT_NEAR(b.table->angle()->degrees, 350.0, 0.06) << "where it is going to stand";
  EXPECT_NEAR(b.table->askStatus({}).angle->degrees, 350.0, 0.06);
  EXPECT_NEAR(b.standIn.degrees(), 350.0, 0.06);
}

TEST(SerialTurntable, StoppedWhileTheObjectSettlesItStandsWhereItArrived) {
  const Bench b(testing::fabscanStandIn({.unitsPerDegree = kFirmwares[2].unitsPerDegree}),
                "fabscan:settle_s=20:fastest_deg_s=20000");
  std::jthread operator_([&] {
    while (std::abs(b.standIn.degrees() - 20.0) > 0.06) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    b.table->stop();
  });
  EXPECT_THROW(static_cast<void>(b.table->turnTo(20.0, {})), Cancelled);
  ASSERT_TRUE(b.table->angle());
  EXPECT_NEAR(b.table->angle()->degrees, 20.0, 0.06);
}

TEST(SerialTurntable, ThatIsUnpluggedCanBeConnectedAgain) {
  auto standIn = std::make_unique<StandInTable>(testing::grblStandIn({}));
  const auto table = serialTurntable({standIn->port(), "grbl:settle_s=0"});
  table->open({});
  std::jthread cable([&] {
    while (table->status().state != TableState::Moving) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    standIn->unplug();
  });
  try {
    static_cast<void>(table->turnTo(300.0, {}));
    FAIL() << "arrived";
  } catch (const DeviceError& e) {
    expectIn(e.what(), "was unplugged or switched off");
  }
  EXPECT_EQ(table->status().state, TableState::Closed);
  EXPECT_EQ(table->angle(), std::nullopt);
  expectIn(*table->notReady(), "was unplugged or switched off");
  EXPECT_THROW(table->open({}), DeviceError);
}

}  // namespace
}  // namespace vantage
