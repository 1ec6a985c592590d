#include "devices/serial/table_profile.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <iterator>

#include "base/errors.h"
#include "program/installed_files.h"
#include "support/test_data.h"

namespace vantage {
namespace {

std::string textOfGrbl() {
  std::ifstream in(resourceFolder("turntables") + "/grbl.json");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string messageOf(const std::string& from, const std::string& to) {
  std::string text = textOfGrbl();
  text.replace(text.find(from), from.size(), to);
  const testing::TemporaryFolder folder;
  try {
    static_cast<void>(readTableProfile(folder.write("mine.json", text)));
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "read";
}

TEST(TableProfile, AllThatAreShippedCanBeRead) {
  const auto profiles = readTableProfiles(resourceFolder("turntables"));
  std::vector<std::string> names;
  for (const TableProfile& profile : profiles) names.push_back(profile.name);
  EXPECT_EQ(names, (std::vector<std::string>{"comxim", "fabscan", "grbl", "horus", "marlin"}));
}

TEST(TableProfile, RefusalsNameFilePlaceAndExpectation) {
  const auto expect = [](const std::string& message, const std::string& pointer, const std::string& expectation) {
    EXPECT_NE(message.find("mine.json: " + pointer), std::string::npos) << message;
    EXPECT_NE(message.find("expected " + expectation), std::string::npos) << message;
  };
  expect(messageOf("\"sense\": 1", "\"sense\": 0"), "/sense", "1 or -1");
  expect(messageOf("\"units_per_turn\": 360", "\"units_per_turn\": -1"), "/units_per_turn", "a number between");
  expect(messageOf("\"^ok$\"", "\"(ok\""), "/answers/ok", "a regular expression");
  expect(messageOf("\"Idle\": \"idle\"", "\"Idle\": \"ready\""), "/status/states/Idle", "one of idle");
  expect(messageOf("\"hold\": \"!\"", "\"hold\": \"!!\""), "/stop/hold", "one character");
  expect(messageOf("\"baud\": [115200]", "\"baud\": [0.5]"), "/baud", "whole numbers");
  expect(messageOf("\"feed_per\": \"min\"", "\"feed_per\": \"h\""), "/move/feed_per", "min or s");
  expect(messageOf("\"unlock\"", "\"unlok\""), "/unlok", "one of");
}

TEST(TableProfile, AProtocolIsANameOrAFileAndWhatDiffersAtThisTable) {
  const std::string folder = resourceFolder("turntables");
  const TableProfile rotary = tableProfilesFor("grbl:axis=A:units_per_turn=40:sense=-1", folder).front();
  EXPECT_EQ(rotary.axis, "A");
  EXPECT_EQ(rotary.unitsPerTurn, 40.0);
  EXPECT_EQ(rotary.sense, -1);
  EXPECT_EQ(tableProfilesFor("", folder).size(), 5U);
  const testing::TemporaryFolder own;
  EXPECT_EQ(tableProfilesFor(own.write("mine.json", textOfGrbl()) + ":settle_s=2", folder).front().settle,
            std::chrono::seconds(2));
  EXPECT_THROW(static_cast<void>(tableProfilesFor("gbrl", folder)), InvalidInput);
  EXPECT_THROW(static_cast<void>(tableProfilesFor("grbl:steps=3", folder)), InvalidInput);
  EXPECT_THROW(static_cast<void>(tableProfilesFor("grbl:sense=3", folder)), InvalidInput);
  EXPECT_THROW(static_cast<void>(tableProfilesFor("grbl:status=1", folder)), InvalidInput);
}

TEST(TableState, HasANameForEach) {
  for (int i = 0; i <= static_cast<int>(kLastTableState); ++i) {
    const auto state = static_cast<TableState>(i);
    EXPECT_EQ(tableStateOf(name(state)), state);
  }
  EXPECT_FALSE(tableStateOf("ready"));
}

TEST(ResourceFolder, IsTheOneThatTheEnvironmentNames) {
  const std::string usual = resourceFolder("turntables");
  ASSERT_EQ(::setenv("VANTAGE_RESOURCES", "/elsewhere", 1), 0);
  EXPECT_EQ(resourceFolder("turntables"), "/elsewhere/turntables");
  ASSERT_EQ(::unsetenv("VANTAGE_RESOURCES"), 0);
  EXPECT_EQ(resourceFolder("turntables"), usual);
}

}  // namespace
}  // namespace vantage
