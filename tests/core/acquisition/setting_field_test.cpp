#include "acquisition/setting_field.h"

#include <gtest/gtest.h>

#include "core/io/expect_error.h"

namespace vantage {
namespace {

using testing::expectError;

// An angle of the settings, as a field that no table has.
SettingField angleField() {
  SettingField field;
  field.key = "made_up.angle";
  field.unit = "deg";
  field.least = 1.0;
  field.most = 90.0;
  field.get = [](const AcquisitionSettings& s) { return SettingValue(s.registration.finalAngle); };
  field.set = [](AcquisitionSettings& s, const SettingValue& v) { s.registration.finalAngle = std::get<double>(v); };
  return field;
}

TEST(SettingField, NamesItsGroupBeforeTheDot) {
  SettingField field = angleField();
  EXPECT_EQ(groupOf(field), "made_up");
  field.key = "max_views";
  EXPECT_EQ(groupOf(field), "");
}

TEST(SettingField, EveryAngleInDegreesComesBackAsItWasGiven) {
  const SettingField field = angleField();
  AcquisitionSettings settings;
  for (const double angle : {1.0, 7.3, 12.345, 33.333333, 89.9}) {
    setValue(field, settings, angle);
    EXPECT_EQ(settings.registration.finalAngle, radians(angle));
    EXPECT_EQ(std::get<double>(valueOf(field, settings)), angle);
  }
}

TEST(SettingField, WholeNumbersAreNumbersAndOtherKindsAreNot) {
  const SettingField field = angleField();
  AcquisitionSettings settings;
  setValue(field, settings, std::uint64_t{30});
  EXPECT_EQ(textOf(field, settings), "30");
  expectError<InvalidInput>([&] { setValue(field, settings, true); }, {"made_up.angle is true", "from 1 to 90 deg"});
  expectError<InvalidInput>([&] { setValue(field, settings, {}); }, {"made_up.angle is auto"});
  expectError<InvalidInput>([&] { setText(field, settings, "0.5"); }, {"made_up.angle is 0.5"});
  EXPECT_EQ(textOf(field, settings), "30");
}

TEST(SettingField, TextsOfNumbersComeBackToTheLastBit) {
  EXPECT_EQ(settingText(0.1), "0.1");
  EXPECT_EQ(settingText(0.0), "0");
  EXPECT_EQ(settingText({}), "auto");
  EXPECT_EQ(settingText(false), "false");
  for (const double number : {1.0 / 3.0, 1e-9, 123456789.125, 6.02e23})
    EXPECT_EQ(std::stod(settingText(number)), number) << settingText(number);
}

TEST(SettingField, SaysWhatItExpects) {
  SettingField field = angleField();
  EXPECT_EQ(expectationOf(field), "a number from 1 to 90 deg");
  field.automatic = true;
  EXPECT_EQ(expectationOf(field), "a number from 1 to 90 deg, or auto");
  field = {};
  field.kind = SettingField::Kind::Choice;
  field.choices = {"here", "there"};
  EXPECT_EQ(expectationOf(field), "one of here, there");
}

}  // namespace
}  // namespace vantage
