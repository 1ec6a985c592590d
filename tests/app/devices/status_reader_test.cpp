#include "devices/serial/status_reader.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "program/installed_files.h"

namespace vantage {
namespace {

TableProfile profileOf(const std::string& protocol) {
  return tableProfilesFor(protocol, resourceFolder("turntables")).front();
}

TEST(StatusReader, ReadsTheFieldsInAnyOrderAndForAnyAxis) {
  const TableProfile profile = profileOf("grbl:axis=A");
  StatusReader reader(profile);
  const auto report = reader.read("<Hold:0|FS:0,0|Pn:P|MPos:1.000,2.000,3.000,-4.500>");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->state, TableState::Held);
  EXPECT_EQ(report->word, "Hold");
  EXPECT_EQ(report->position, -4.5);
  EXPECT_THROW(static_cast<void>(reader.read("<Idle|MPos:1.000,2.000,3.000|FS:0,0>")), DeviceError);
}

TEST(StatusReader, TellsTheMachinePositionFromWorkCoordinatesOnceTheOffsetWasTold) {
  const TableProfile profile = profileOf("grbl");
  StatusReader reader(profile);
  EXPECT_EQ(reader.read("<Idle|WPos:10.000,0.000,0.000>")->position, std::nullopt);
  EXPECT_EQ(reader.read("<Idle|WPos:10.000,0.000,0.000|WCO:5.000,0.000,0.000>")->position, 15.0);
  EXPECT_EQ(reader.read("<Run|WPos:11.000,0.000,0.000>")->position, 16.0);
  reader.setInches(true);
  EXPECT_DOUBLE_EQ(*reader.read("<Run|WPos:-4.000,0.000,0.000>")->position, 25.4);
  reader.forget();
  EXPECT_EQ(reader.read("<Idle|WPos:10.000,0.000,0.000>")->position, std::nullopt);
}

TEST(StatusReader, RefusesWhatIsDamaged) {
  const TableProfile profile = profileOf("grbl");
  StatusReader reader(profile);
  for (const char* damaged : {"ok", "<Idle|MPos:1.000,0.0", "<Idle|MP\x01s:1.000,0.000,0.000>", "Idle|MPos:1.0>", "<>"})
    EXPECT_FALSE(reader.read(damaged)) << damaged;
  EXPECT_EQ(reader.read("<Idle|MPos:1.0.0,0.000,0.000|FS:0,0>")->position, std::nullopt);
  EXPECT_EQ(reader.read("\xfe garbage <Idle|MPos:1.000,0.000,0.000|FS:0,0>")->position, 1.0);
}

TEST(StatusReader, ReadsWhatOtherFirmwaresReport) {
  const TableProfile horus = profileOf("horus");
  const auto run = StatusReader(horus).read("<Run,MPos:12.500,0.000,0.000,WPos:12.500,0.000,0.000>");
  ASSERT_TRUE(run);
  EXPECT_EQ(run->state, TableState::Moving);
  EXPECT_EQ(run->position, 12.5);

  const TableProfile marlin = profileOf("marlin:axis=Y");
  const auto planned = StatusReader(marlin).read("X:0.00 Y:90.00 Z:0.00 E:0.00 Count X:0 Y:800 Z:0");
  ASSERT_TRUE(planned);
  EXPECT_EQ(planned->state, TableState::Unknown);
  EXPECT_EQ(planned->position, 90.0);
  EXPECT_EQ(planned->count, 800.0);
}

}  // namespace
}  // namespace vantage
