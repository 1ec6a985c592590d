#include "report/warnings.h"

#include <gtest/gtest.h>

#include <set>

#include "report/wording.h"
#include "support/meshes.h"

namespace vantage {
namespace {

KeptScan scanWith(std::int64_t number, ScanStatus status, Verdict verdict) {
  KeptScan scan;
  scan.number = number;
  scan.status = status;
  scan.record.registration.verdict = verdict;
  scan.record.registration.finding = {VerdictReason::FewInliers, 0.2, {}};
  return scan;
}

// Of a triangle of 50 mm^2.
AcquisitionState finishedState() {
  AcquisitionState state;
  Model model;
  model.mesh = {{Vec3::Zero(), Vec3(10, 0, 0), Vec3(0, 10, 0)}, {{0, 1, 2}}};
  state.model = std::make_shared<const Model>(model);
  state.scans = {scanWith(0, ScanStatus::In, Verdict::Good)};
  state.termination = Termination::Finished;
  return state;
}

std::vector<WarningCode> codes(const AcquisitionState& state, std::size_t first = 0) {
  std::vector<WarningCode> all;
  for (const Warning& warning : warningsOf(state, first)) all.push_back(warning.code);
  return all;
}

TEST(Warnings, AreNotGivenOfWhatIsWell) {
  AcquisitionState state = finishedState();
  EXPECT_TRUE(codes(state).empty());
  state.scans.push_back(scanWith(1, ScanStatus::LeftOut, Verdict::Doubtful));
  EXPECT_TRUE(codes(state).empty());
}

TEST(Warnings, NameScansThatAreNotWell) {
  AcquisitionState state = finishedState();
  state.scans.push_back(scanWith(1, ScanStatus::Rejected, Verdict::Failed));
  state.scans.push_back(scanWith(4, ScanStatus::In, Verdict::Doubtful));
  EXPECT_EQ(codes(state), (std::vector{WarningCode::ScanRejected, WarningCode::ScanDoubtful}));
  EXPECT_EQ(codes(state, 2), (std::vector{WarningCode::ScanDoubtful}));
  EXPECT_EQ(describe(warningsOf(state)[1]), "scan 4 is doubtful: only 20 % of the expected overlap fits");
}

TEST(Warnings, OfAPoseThatMechanicsHoldAreNotSerious) {
  AcquisitionState state = finishedState();
  state.scans.push_back(scanWith(1, ScanStatus::In, Verdict::Doubtful));
  ASSERT_EQ(warningsOf(state).size(), 1U);
  EXPECT_TRUE(isSerious(warningsOf(state)[0]));
  state.scans[1].record.registration.finding.reason = VerdictReason::HeldByMechanics;
  ASSERT_EQ(warningsOf(state).size(), 1U);
  EXPECT_FALSE(isSerious(warningsOf(state)[0]));
}

TEST(Warnings, WhatNobodyKnowsOfAScanTurnedByHandIsSerious) {
  AcquisitionState state = finishedState();
  KeptScan scan = scanWith(1, ScanStatus::In, Verdict::Doubtful);
  scan.record.registration.finding = {VerdictReason::HeldByMechanics, {}, {{WeakMotion::Kind::Turn, Vec3::UnitZ()}}};
  scan.record.registration.poseSigma = 4.2;
  RangeImage image;
  image.poseKnownBy = PoseSource::ByHand;
  image.poseUncertainty = Mechanics{radians(7.5), 3.0};
  scan.view.image = std::make_shared<const RangeImage>(image);
  ViewMesh mesh;
  mesh.spacing = 1.0;
  scan.view.mesh = std::make_shared<const ViewMesh>(mesh);
  state.scans.push_back(scan);
  ASSERT_EQ(warningsOf(state).size(), 1U);
  EXPECT_TRUE(isSerious(warningsOf(state)[0]));
  EXPECT_NE(describe(warningsOf(state)[0]).find("by hand, is doubtful and may be off by 4.2 mm"), std::string::npos);
}

TEST(Warnings, SayThatAnAcquisitionIsNotFinished) {
  AcquisitionState state = finishedState();
  state.termination = Termination::NoOverlap;
  EXPECT_EQ(codes(state), (std::vector{WarningCode::EndedEarly}));
  state.termination = Termination::Running;
  EXPECT_TRUE(codes(state).empty());
}

TEST(Warnings, SayThatNothingOrLittleIsCovered) {
  AcquisitionState state = finishedState();
  Plan plan;
  plan.voidLeft = 2.0;
  state.plan = std::make_shared<const Plan>(plan);
  EXPECT_TRUE(codes(state).empty());
  plan.voidLeft = 10.0;
  state.plan = std::make_shared<const Plan>(plan);
  EXPECT_EQ(codes(state), (std::vector{WarningCode::LittleCovered}));
  EXPECT_NE(describe(warningsOf(state)[0]).find("20 %"), std::string::npos);
  state.model = std::make_shared<const Model>();
  EXPECT_EQ(codes(state), (std::vector{WarningCode::NothingCovered}));
}

TEST(Warnings, HaveACodeAndWordsEach) {
  std::set<std::string> texts;
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(kLastWarningCode); ++i) {
    const auto code = static_cast<WarningCode>(i);
    names.insert(name(code));
    const auto alignment = std::make_shared<const StandAlignment>();
    texts.insert(describe(Warning{code, 3, Finding{}, 0.1, Termination::MaxViews, 1, alignment}));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kLastWarningCode) + 1);
  EXPECT_EQ(texts.size(), names.size());
}

// The views of a table that says it turned by `said`, found as if it had turned by `found` [degrees].
std::vector<WarningCode> codesOfTurn(double said, double found) {
  AcquisitionState state = finishedState();
  state.scans.push_back(scanWith(1, ScanStatus::In, Verdict::Doubtful));
  state.scans[1].record.registration.finding = {VerdictReason::TableSlipped, said - found, {}};
  const Pose start = Eigen::Translation3d(Vec3(300.0, 0.0, 100.0)) * Pose::Identity();
  const double angles[][2] = {{0.0, 0.0}, {said, found}};
  for (std::size_t i = 0; i < 2; ++i) {
    RangeImage image;
    image.T_table_scanner = Eigen::AngleAxisd(radians(angles[i][0]), Vec3::UnitZ()) * start;
    state.scans[i].view.image = std::make_shared<const RangeImage>(std::move(image));
    state.scans[i].view.T_object_scanner = Eigen::AngleAxisd(radians(angles[i][1]), Vec3::UnitZ()) * start;
  }
  return codes(state);
}

TEST(Warnings, ATableThatTurnsTheOtherWayIsSaid) {
  EXPECT_EQ(codesOfTurn(40.0, -40.5), (std::vector{WarningCode::ScanDoubtful, WarningCode::TableTurnsBack}));
  EXPECT_EQ(codesOfTurn(40.0, 28.0), (std::vector{WarningCode::ScanDoubtful}));
  EXPECT_EQ(codesOfTurn(180.0, -180.0), (std::vector{WarningCode::ScanDoubtful}));
}

}  // namespace
}  // namespace vantage
