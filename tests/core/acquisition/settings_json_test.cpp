#include "acquisition/settings_json.h"

#include <gtest/gtest.h>

#include <string>

#include "acquisition/settings_table.h"
#include "acquisition/step_options.h"
#include "base/errors.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

// As sessions of schema 2 have it.
const char* const kFlat = R"({"object": "mug.ply", "placement": "fit", "seed": 3, "ideal": true, "first_view": 5,
                              "max_views": 12, "tolerance": 0.3, "strategy": "uniform:8"})";

// The same with what nobody changed.
const char* const kUnchanged = R"({"object": "", "placement": "as-is", "seed": 1, "ideal": false, "first_view": 0,
                                   "max_views": 40, "tolerance": 0, "strategy": "ps"})";

// What earlier sessions mean by everything else. These stay, whatever becomes of the defaults.
const char* const kBefore = R"({
  "max_views": 40, "first_view": 0, "strategy": "ps", "simulation.object": "", "simulation.placement": "as-is",
  "simulation.seed": 1, "simulation.ideal": false, "planner.tolerance": 0, "planner.overlap_share": 0.1,
  "planner.overlap_samples": 300, "planner.least_overlap": "auto", "planner.pose_sigma_share": 0.2,
  "planner.border_rings": 2, "planner.max_relaxations": 3, "planner.overlap_elements": 2000,
  "planner.pairs_per_observation": 20, "planner.least_range_sigma": 0.05, "planner.facing_angle": 60,
  "planner.opening_angle": 85, "planner.surface_offset": 0.25, "planner.sight_margin": 0.5,
  "history.grazing_angle": 85, "planner.look_ahead": true, "planner.look_ahead_reach": 3, "planner.widest_hole": 16, "planner.traced_positions": 16,
  "planner.planning_triangles": 30000, "planner.traced_triangles": 300000, "planner.planning_error": 0.1,
  "termination.threshold": "auto", "termination.edges": 17, "termination.share": 0.0005,
  "history.clear_of_breakdown": 6, "history.most_looks": 2, "history.cosine_gain": 0.07, "void.jump_factor": 1.5,
  "void.shadow_reach": 4, "void.normal_rings": 2, "void.weight": "spacing", "triangulation.angle_slack": "auto",
  "triangulation.discontinuity_factor": 1.4, "registration.coarse_gate": 10, "registration.final_gate": 0.8,
  "registration.coarse_angle": 45, "registration.final_angle": 35, "registration.hidden_depth": 10,
  "registration.coarse_points": 4000, "registration.fine_points": 60000, "registration.max_iterations": 60,
  "registration.tolerance": 0.001, "registration.search_rivals": true, "verdict.min_pairs": 100,
  "verdict.few_pairs": 400, "verdict.min_inlier_share": 0.4, "verdict.low_inlier_share": 0.75,
  "verdict.doubtful_conflicts": 0.04, "verdict.max_conflicts": 0.15, "verdict.doubtful_residual": 2,
  "verdict.max_residual": 4, "verdict.doubtful_motion": 4, "verdict.max_motion": 7, "verdict.max_pose_sigma": 0.1,
  "refinement.coarse_gate": 2, "refinement.final_gate": 0.8, "refinement.max_angle": 35, "refinement.hidden_depth": 10,
  "refinement.min_overlap": 0.03, "refinement.coarse_points": 30000, "refinement.fine_points": 300000,
  "refinement.least_points": 500, "refinement.max_iterations": 40, "refinement.tolerance": 0.002,
  "alignment.points_per_view": 8000, "alignment.fine_points": 15000, "zipper.surface_tolerance": 1,
  "zipper.spacing_tolerance": 1, "zipper.normal_tolerance": 72, "zipper.steepest": 85, "zipper.confidence_margin": 0.1,
  "zipper.clearance": 0.35, "zipper.discontinuity_factor": 1.4, "zipper.shortest_edge": 0.3, "zipper.max_hole_edges": 16,
  "zipper.max_hole_chord": 2.5, "zipper.min_island_triangles": 6, "consensus.max_offset": 0.6,
  "consensus.spacing_offset": 0.8, "consensus.normal_tolerance": 60, "consensus.passes": 1})";

std::string refusalOf(const std::string& text) {
  try {
    static_cast<void>(withOptions({}, text, "o.json"));
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}

TEST(SettingsJson, NamesOfEarlierVersionsAreUnderstood) {
  const AcquisitionSettings settings = settingsFromJson(Json::parse(kFlat), "step 1");
  EXPECT_EQ(settings.simulation.object, "mug.ply");
  EXPECT_EQ(settings.simulation.placement, Placement::Fit);
  EXPECT_EQ(settings.simulation.seed, 3U);
  EXPECT_TRUE(settings.simulation.ideal);
  EXPECT_EQ(settings.firstView, 5);
  EXPECT_EQ(settings.maxViews, 12);
  EXPECT_EQ(settings.planner.tolerance, 0.3);
  EXPECT_EQ(name(settings.strategy), "uniform:8");
}

TEST(SettingsJson, ALaterDefaultDoesNotChangeWhatAnEarlierSessionMeans) {
  const AcquisitionSettings earlier = settingsFromJson(Json::parse(kUnchanged), "step 1");
  const Json before = Json::parse(kBefore);
  for (const auto& [key, value] : before.items()) {
    const AcquisitionSettings named = withOptions(earlier, Json{{key, value}}.dump(), "before");
    EXPECT_EQ(named, earlier) << key;
  }
}

TEST(SettingsJson, WithoutWhatEveryVersionNamedSettingsAreDamaged) {
  const Json whole = Json::parse(kUnchanged);
  for (const auto& [key, value] : whole.items()) {
    Json part = whole;
    part.erase(key);
    EXPECT_THROW(static_cast<void>(settingsFromJson(part, "step 1")), InvalidInput) << key;
  }
}

TEST(SettingsJson, WhatIsNotNamedMeansWhatTheTableSaysOfBefore) {
  const AcquisitionSettings earlier = settingsFromJson(Json::parse(kUnchanged), "step 1");
  for (const SettingField& field : settingFields()) EXPECT_EQ(textOf(field, earlier), field.before) << field.key;
}

TEST(SettingsJson, EveryFieldIsWritten) {
  const auto json = settingsJson({});
  for (const SettingField& field : settingFields()) EXPECT_TRUE(json.contains(std::string(field.key))) << field.key;
  EXPECT_EQ(json.size(), settingFields().size());
}

TEST(SettingsJson, ProfileOfOptionsLeavesOutWhatBelongsToOneSession) {
  AcquisitionSettings settings;
  settings.simulation.object = "mug.ply";
  settings.planner.overlapShare = 0.25;
  const std::string text = optionsText(settings);
  EXPECT_EQ(text.find("mug.ply"), std::string::npos);
  AcquisitionSettings other;
  other.simulation.object = "cup.ply";
  other = withOptions(other, text, "o.json");
  EXPECT_EQ(other.simulation.object, "cup.ply");
  EXPECT_EQ(other.planner.overlapShare, 0.25);
}

TEST(SettingsJson, RefusalsNameTheFile) {
  EXPECT_EQ(refusalOf("{"), "o.json: is no JSON, expected one object of keys and values");
  EXPECT_EQ(refusalOf("[1]"), "o.json: is no JSON object, expected one of keys and values");
  EXPECT_EQ(refusalOf(R"({"max_views": "many"})"),
            "o.json: max_views is many, expected a whole number from 1 to 1000000");
  EXPECT_EQ(refusalOf(R"({"max_views": -3})"), "o.json: max_views is -3, expected a whole number from 1 to 1000000");
  EXPECT_EQ(refusalOf(R"({"max_views": null})"),
            "o.json: max_views is no value, expected a whole number from 1 to 1000000");
  EXPECT_EQ(refusalOf(R"({"max_vews": 3})"), "o.json: there is no option 'max_vews', the nearest is max_views");
  EXPECT_NE(refusalOf(std::string(100'000, '[')), "");
}

TEST(StepOptions, RecordedScansWithoutAProfileReachFartherRound) {
  AcquisitionState state;
  ImportOptions options = importOptionsFor(state);
  EXPECT_EQ(options.triangulation.breakdownAngle, radians(75.0));
  EXPECT_EQ(options.zipper.breakdownAngle, radians(75.0));
  EXPECT_EQ(options.voidSpace.breakdownAngle, radians(75.0));
  EXPECT_EQ(options.triangulation.angleSlack, radians(5.0));
  state.settings.triangulation.angleSlack = radians(3.0);
  EXPECT_EQ(importOptionsFor(state).triangulation.angleSlack, radians(3.0));
}

TEST(StepOptions, WhatFollowsFromTheScannerIsNoSetting) {
  AcquisitionSettings settings;
  settings.triangulation.breakdownAngle = radians(10.0);
  settings.planner.overlapShare = 0.25;
  ScannerProfile profile;
  profile.breakdownAngle = radians(65.0);
  const StepOptions options = stepOptionsFor(profile, settings);
  EXPECT_EQ(options.triangulation.breakdownAngle, radians(65.0));
  EXPECT_EQ(options.zipper.breakdownAngle, radians(65.0));
  EXPECT_EQ(options.planner.voidSpace.breakdownAngle, radians(65.0));
  EXPECT_EQ(options.planner.overlapShare, 0.25);
  EXPECT_FALSE(options.triangulation.angleSlack.has_value());
}

}  // namespace
}  // namespace vantage
