#include "session/reading_json.h"

#include <gtest/gtest.h>

#include "core/io/expect_error.h"
#include "session/command_json.h"

namespace vantage {
namespace {

ScanReading someReading() {
  ScanReading reading;
  reading.unit = 25.4;
  reading.unitKnownBy = KnownBy::Operator;
  reading.sightKind = SightKind::Point;
  reading.sight = Vec3(0.6, 0.0, 0.8);
  reading.sightKnownBy = KnownBy::Evidence;
  reading.noSample = NoSampleMark::FarPlane;
  reading.dropped = 17;
  reading.exchanged = true;
  reading.placed = true;
  reading.offset = Vec3(403000000.0, 1.0 / 3.0, -2.0);
  reading.poseUnit = 1000.0;
  reading.poseUnitKnownBy = KnownBy::File;
  reading.up = Axis::Y;
  reading.turnsAbout = Axis::X;
  return reading;
}

TEST(ReadingJson, ComesBackToTheLastBit) {
  const nlohmann::json json = readingJson(someReading());
  EXPECT_EQ(readingJson(readingFrom({json, "it"})), json);
  EXPECT_EQ(readingFrom({json, "it"}).offset, someReading().offset);
  EXPECT_EQ(readingFrom({readingJson({}), "it"}).turnsAbout, std::nullopt);
}

TEST(ReadingJson, TakesNothingOnTrust) {
  const auto refuse = [](const char* key, const nlohmann::json& value) {
    nlohmann::json json = readingJson(someReading());
    json[key] = value;
    testing::expectError<InvalidInput>([&] { static_cast<void>(readingFrom({json, "it"})); }, {"it is damaged", key});
  };
  refuse("mm_per_unit", 0.0);
  refuse("mm_per_unit", nullptr);
  refuse("unit_known_by", "rumour");
  refuse("offset_mm", {1.0, nullptr, 2.0});
  refuse("no_sample_cells", -3);
  refuse("up", "w");
}

TEST(ReadingJson, GoesWithTheCommandThatImports) {
  const Command command = ImportScans{{0, 1}, {someReading(), {}}};
  const Command read = commandFromText("import_scans", commandText(command), "step 1");
  EXPECT_EQ(std::get<ImportScans>(read).readings.size(), 2U);
  EXPECT_EQ(commandText(read), commandText(command));
  EXPECT_TRUE(std::get<ImportScans>(commandFromText("import_scans", R"({"scans": [0]})", "step 1")).readings.empty());
}

}  // namespace
}  // namespace vantage
