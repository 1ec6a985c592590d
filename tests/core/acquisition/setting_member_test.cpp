#include "acquisition/setting_member.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

using Kind = SettingField::Kind;
using setting_member::choice;
using setting_member::number;
using setting_member::onOff;
using setting_member::text;

constexpr SettingAudience kBasic = SettingAudience::Basic;

TEST(SettingMember, TheKindFollowsFromTheTypeOfTheMember) {
  EXPECT_EQ(number<&AcquisitionSettings::maxViews>(kBasic, "a", "A", "", 1, 9, "4", "Help.").kind, Kind::Whole);
  const SettingField area = number<&AcquisitionSettings::planner, &PlannerOptions::leastOverlap>(
      kBasic, "b", "B", "mm2", 0, 100, "auto", "Help.");
  EXPECT_EQ(area.kind, Kind::Number);
  EXPECT_TRUE(area.automatic);
  const SettingField share =
      number<&AcquisitionSettings::planner, &PlannerOptions::tolerance>(kBasic, "c", "C", "", 0, 1, "0.1", "Help.");
  EXPECT_EQ(share.kind, Kind::Number);
  EXPECT_FALSE(share.automatic);
}

TEST(SettingMember, ReadsAndWritesTheMemberThatThePathLeadsTo) {
  AcquisitionSettings settings;
  const SettingField seed =
      number<&AcquisitionSettings::simulation, &SimulationSettings::seed>(kBasic, "a", "A", "", 0, 99, "1", "Help.");
  setText(seed, settings, "17");
  EXPECT_EQ(settings.simulation.seed, 17U);
  const SettingField area = number<&AcquisitionSettings::planner, &PlannerOptions::leastOverlap>(
      kBasic, "b", "B", "mm2", 0, 100, "auto", "Help.");
  setText(area, settings, "12.5");
  EXPECT_EQ(settings.planner.leastOverlap, 12.5);
  setText(area, settings, "auto");
  EXPECT_FALSE(settings.planner.leastOverlap);
  const SettingField ideal =
      onOff<&AcquisitionSettings::simulation, &SimulationSettings::ideal>(kBasic, "c", "C", "false", "Help.");
  setText(ideal, settings, "true");
  EXPECT_TRUE(settings.simulation.ideal);
  EXPECT_EQ(textOf(ideal, settings), "true");
}

TEST(SettingMember, TypesOfTheirOwnAreGivenByName) {
  AcquisitionSettings settings;
  const SettingField strategy = text<&AcquisitionSettings::strategy>(kBasic, "a", "A", "ps", "Help.");
  setText(strategy, settings, "uniform:5");
  EXPECT_EQ(settings.strategy.uniformViews, 5);
  EXPECT_EQ(textOf(strategy, settings), "uniform:5");
  const SettingField placement = choice<&AcquisitionSettings::simulation, &SimulationSettings::placement>(
      kBasic, "b", "B", {"as-is", "fit"}, "as-is", "Help.");
  setText(placement, settings, "fit");
  EXPECT_EQ(settings.simulation.placement, Placement::Fit);
  EXPECT_EQ(textOf(placement, settings), "fit");
}

}  // namespace
}  // namespace vantage
