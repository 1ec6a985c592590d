#include "acquisition/settings_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "acquisition/setting_lookup.h"
#include "acquisition/settings_json.h"
#include "base/errors.h"

namespace vantage {
namespace {

using Kind = SettingField::Kind;

// Values that a field can have besides its default, the bounds among them.
std::vector<SettingValue> otherValues(const SettingField& field) {
  std::vector<SettingValue> values;
  switch (field.kind) {
    case Kind::Switch:
      return {true, false};
    case Kind::Whole:
      values = {static_cast<std::uint64_t>(field.least), static_cast<std::uint64_t>(field.least) + 7};
      break;
    case Kind::Number:
      values = {field.least, field.most, field.least + (field.most - field.least) / 3.0};
      break;
    case Kind::Choice:
      for (const std::string_view choice : field.choices) values.emplace_back(std::string(choice));
      break;
    case Kind::Text:
      values = {std::string("uniform:5")};
      break;
  }
  return values;
}

// Does something with every field and every value that differs from the default.
template <typename Law>
void forAllChanges(const Law& law) {
  for (const SettingField& field : settingFields()) {
    SCOPED_TRACE(field.key);
    int changes = 0;
    for (const SettingValue& value : otherValues(field)) {
      AcquisitionSettings changed;
      setValue(field, changed, value);
      if (valueOf(field, changed) == valueOf(field, AcquisitionSettings())) continue;
      ++changes;
      law(field, changed);
    }
    EXPECT_GT(changes, 0);
  }
}

std::string refusalOf(std::string_view key, std::string_view text) {
  AcquisitionSettings settings;
  try {
    setText(settingField(key), settings, text);
  } catch (const InvalidInput& e) {
    EXPECT_EQ(settings, AcquisitionSettings());
    return e.what();
  }
  return "";
}

TEST(SettingsTable, KeysAreUniqueAndInLowerCase) {
  std::set<std::string_view> keys;
  for (const SettingField& field : settingFields()) {
    EXPECT_TRUE(keys.insert(field.key).second) << field.key;
    EXPECT_TRUE(std::all_of(field.key.begin(), field.key.end(), [](char c) {
      return std::islower(static_cast<unsigned char>(c)) || c == '_' || c == '.';
    })) << field.key;
  }
}

TEST(SettingsTable, EveryGroupHasALabelAndStandsTogether) {
  std::set<std::string_view> seen;
  std::string_view last = "none";
  for (const SettingField& field : settingFields()) {
    EXPECT_FALSE(groupLabel(groupOf(field)).empty());
    if (groupOf(field) != last) {
      EXPECT_TRUE(seen.insert(groupOf(field)).second) << field.key;
    }
    last = groupOf(field);
  }
}

TEST(SettingsTable, HelpIsOneSentence) {
  for (const SettingField& field : settingFields()) {
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(field.help.front()))) << field.key;
    EXPECT_TRUE(field.help.ends_with('.')) << field.key;
    EXPECT_EQ(field.help.find(". "), std::string_view::npos) << field.key;
    EXPECT_FALSE(field.label.empty()) << field.key;
  }
}

TEST(SettingsTable, DefaultsAreWithinTheirBounds) {
  for (const SettingField& field : settingFields()) {
    AcquisitionSettings settings;
    EXPECT_NO_THROW(setValue(field, settings, valueOf(field, settings))) << field.key;
    EXPECT_EQ(settings, AcquisitionSettings()) << field.key;
  }
  EXPECT_NO_THROW(checkSettings(AcquisitionSettings()));
}

TEST(SettingsTable, TextLeadsBackToTheSameSettings) {
  forAllChanges([](const SettingField& field, const AcquisitionSettings& changed) {
    AcquisitionSettings read;
    setText(field, read, textOf(field, changed));
    EXPECT_EQ(read, changed) << textOf(field, changed);
  });
}

TEST(SettingsTable, JsonLeadsBackToTheLastBit) {
  forAllChanges([](const SettingField& field, const AcquisitionSettings& changed) {
    const AcquisitionSettings read = settingsFromJson(nlohmann::json::parse(settingsJson(changed).dump()), "settings");
    EXPECT_EQ(read, changed);
    EXPECT_EQ(field.get(read), field.get(changed));
  });
}

TEST(SettingsTable, HashAndEqualityNoticeEveryChange) {
  forAllChanges([](const SettingField& /*field*/, const AcquisitionSettings& changed) {
    EXPECT_FALSE(changed == AcquisitionSettings());
    EXPECT_NE(settingsHash(changed), settingsHash(AcquisitionSettings()));
  });
}

TEST(SettingsTable, RefusalsNameKeyValueAndWhatWasExpected) {
  EXPECT_EQ(refusalOf("planner.overlap_share", "7"), "planner.overlap_share is 7, expected a number from 0 to 1");
  EXPECT_EQ(refusalOf("planner.overlap_share", "much"),
            "planner.overlap_share is 'much', expected a number from 0 to 1");
  EXPECT_EQ(refusalOf("registration.coarse_angle", "120"),
            "registration.coarse_angle is 120, expected a number from 1 to 90 deg");
  EXPECT_EQ(refusalOf("planner.least_overlap", "-1"),
            "planner.least_overlap is -1, expected a number from 0 to 1000000000 mm2, or auto");
  EXPECT_EQ(refusalOf("max_views", "2.5"), "max_views is '2.5', expected a whole number from 1 to 1000000");
  EXPECT_EQ(refusalOf("max_views", "auto"), "max_views is 'auto', expected a whole number from 1 to 1000000");
  EXPECT_EQ(refusalOf("planner.look_ahead", "1"), "planner.look_ahead is '1', expected true or false");
  EXPECT_EQ(refusalOf("simulation.placement", "middle"), "simulation.placement is middle, expected one of as-is, fit");
  EXPECT_NE(refusalOf("strategy", "best").find("uniform:N"), std::string::npos);
  EXPECT_NE(refusalOf("planner.overlap_share", "nan"), "");
}

TEST(SettingsTable, UnknownKeyIsToldTheNearestOne) {
  try {
    static_cast<void>(settingField("planner.overlapshare"));
    FAIL() << "the key was taken";
  } catch (const InvalidInput& e) {
    EXPECT_STREQ(e.what(), "there is no option 'planner.overlapshare', the nearest is planner.overlap_share");
  }
}

TEST(SettingsTable, AnglesAreDegreesForPeopleAndRadiansInside) {
  AcquisitionSettings settings;
  EXPECT_EQ(textOf(settingField("registration.final_angle"), settings), "35");
  setText(settingField("registration.final_angle"), settings, "30");
  EXPECT_EQ(settings.registration.finalAngle, radians(30.0));
}

TEST(SettingsTable, UnsetIsAutomatic) {
  AcquisitionSettings settings;
  const SettingField& field = settingField("planner.least_overlap");
  EXPECT_EQ(textOf(field, settings), "auto");
  setText(field, settings, "12.5");
  EXPECT_EQ(settings.planner.leastOverlap, 12.5);
  setText(field, settings, "auto");
  EXPECT_EQ(settings.planner.leastOverlap, std::nullopt);
}

TEST(SettingsTable, ContradictionIsRefused) {
  AcquisitionSettings settings;
  settings.registration.coarseGate = 10.0;
  settings.registration.finalGate = 12.0;
  try {
    checkSettings(settings);
    FAIL() << "a final gate of 12 mm was taken";
  } catch (const InvalidInput& e) {
    EXPECT_STREQ(e.what(),
                 "registration.final_gate is 12, expected no more than registration.coarse_gate, which is 10");
  }
}

}  // namespace
}  // namespace vantage
