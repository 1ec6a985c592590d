#include "session/earlier_wording.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "session/session_json.h"

namespace vantage {
namespace {

using Kind = WeakMotion::Kind;

TEST(EarlierWording, EveryVerdictThatWasEverStoredIsUnderstood) {
  const std::vector<std::pair<std::string, Finding>> sentences{
      {"", {VerdictReason::NotRegistered, {}, {}}},
      {"the first view defines the frame", {VerdictReason::FirstView, {}, {}}},
      {"the first view is where the others go", {VerdictReason::FirstImported, {}, {}}},
      {"registered by an earlier version", {VerdictReason::EarlierVersion, {}, {}}},
      {"97 % of the expected overlap fits", {VerdictReason::Inliers, 0.97, {}}},
      {"100 % of the expected overlap fits", {VerdictReason::Inliers, 1.0, {}}},
      {"only 31 % of the expected overlap fits", {VerdictReason::FewInliers, 0.31, {}}},
      {"only 12 points overlap with the model", {VerdictReason::FewPairs, 12.0, {}}},
      {"the scanner looked through 8 % of the model's surface", {VerdictReason::Conflicts, 0.08, {}}},
      {"the surfaces differ 2.6 times as much as their noise explains", {VerdictReason::Residual, 2.6, {}}},
      {"it moved 11.4 sigma away from where the mechanics put it", {VerdictReason::Motion, 11.4, {}}},
      {"a pose 12.3 mm away fits as well", {VerdictReason::Rival, 12.3, {}}},
      {"the surface turns about z: that part of the pose is the mechanics' word alone",
       {VerdictReason::HeldByMechanics, {}, {{Kind::Turn, Vec3::UnitZ()}}}},
      {"the surface moves freely: that part of the pose is the mechanics' word alone",
       {VerdictReason::HeldByMechanics, {}, {{Kind::Free, Vec3::Zero()}}}},
      {"the pose had not come to rest when the iterations ran out", {VerdictReason::NotSettled, {}, {}}}};
  // Reasons after this one were never sentences.
  std::vector<bool> seen(static_cast<std::size_t>(VerdictReason::NotSettled) + 1, false);
  for (const auto& [sentence, finding] : sentences) {
    EXPECT_EQ(findingFromEarlier(sentence), finding) << sentence;
    seen[static_cast<std::size_t>(finding.reason)] = true;
  }
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_TRUE(seen[i]) << name(static_cast<VerdictReason>(i));
}

TEST(EarlierWording, InfiniteFiguresAreKept) {
  const Finding finding = findingFromEarlier("the surfaces differ inf times as much as their noise explains");
  EXPECT_EQ(finding.reason, VerdictReason::Residual);
  EXPECT_EQ(finding.value, std::numeric_limits<double>::infinity());
}

TEST(EarlierWording, ASentenceThatNobodyKnowsIsOfAnEarlierVersion) {
  for (const char* sentence :
       {"the moon stood low", "only points overlap with the model", "only 12 points overlap with the model today",
        " 97 % of the expected overlap fits", "x % of the expected overlap fits", "a pose  mm away fits as well"})
    EXPECT_EQ(findingFromEarlier(sentence), (Finding{VerdictReason::EarlierVersion, {}, {}})) << sentence;
}

TEST(EarlierWording, WeakMotionsAreUnderstoodInAnyNumber) {
  const std::vector<std::pair<std::string, WeakMotions>> sentences{
      {"", {}},
      {"moves freely", {{Kind::Free, Vec3::Zero()}}},
      {"slides along z", {{Kind::Slide, Vec3::UnitZ()}}},
      {"turns about (0.7, 0.7, 0.0)", {{Kind::Turn, Vec3(0.7, 0.7, 0.0)}}},
      {"slides along (0.9, -0.4, 0.1)", {{Kind::Slide, Vec3(0.9, -0.4, 0.1)}}},
      {"slides along x and slides along y and turns about z",
       {{Kind::Slide, Vec3::UnitX()}, {Kind::Slide, Vec3::UnitY()}, {Kind::Turn, Vec3::UnitZ()}}},
      {"turns about (0.7, 0.7, 0.0) and slides along y",
       {{Kind::Turn, Vec3(0.7, 0.7, 0.0)}, {Kind::Slide, Vec3::UnitY()}}}};
  for (const auto& [sentence, motions] : sentences) EXPECT_EQ(weakMotionsFromEarlier(sentence), motions) << sentence;
}

TEST(EarlierWording, MotionsThatNobodyKnowsAreNone) {
  for (const char* sentence : {"wobbles", "slides along w", "slides along z and", "slides along z or turns about z",
                               "turns about (0.7, 0.7)", "turns about (a, b, c)", "turns about (inf, 0.0, 0.0)"})
    EXPECT_TRUE(weakMotionsFromEarlier(sentence).empty()) << sentence;
}

TEST(EarlierWording, FinerStepsBelongToTheirPhase) {
  for (int i = 0; i < kPhases; ++i) EXPECT_EQ(phaseFromEarlier(name(static_cast<Phase>(i))), static_cast<Phase>(i));
  EXPECT_EQ(phaseFromEarlier("Registering"), Phase::Register);
  EXPECT_EQ(phaseFromEarlier("Refining all views"), Phase::Register);
  EXPECT_EQ(phaseFromEarlier("Preparing the views"), Phase::Register);
  EXPECT_EQ(phaseFromEarlier("zippering"), Phase::Integrate);
  EXPECT_EQ(phaseFromEarlier("consensus"), Phase::Integrate);
  EXPECT_EQ(phaseFromEarlier("lunch"), std::nullopt);
}

ScanRecord doubtfulRecord() {
  ScanRecord record;
  record.registration.verdict = Verdict::Doubtful;
  record.registration.finding = {VerdictReason::HeldByMechanics, {}, {{Kind::Turn, Vec3(0.7, 0.7, 0.0)}}};
  record.registration.stability.weakMotions = record.registration.finding.motions;
  record.predicted.emplace();
  record.predicted->weakMotions = {{Kind::Slide, Vec3::UnitX()}, {Kind::Slide, Vec3::UnitY()}};
  record.seconds = {{Phase::Register, 1.5}, {Phase::Choose, 0.25}};
  return record;
}

std::string textOf(const ScanRecord& record) {
  OutlinedScan scan;
  scan.scan = 4;
  scan.station.position = 7;
  scan.record = std::make_shared<const ScanRecord>(record);
  return recordText(scan);
}

TEST(EarlierWording, ARecordComesBackFromItsCodes) {
  const ScanRecord record = doubtfulRecord();
  const std::string text = textOf(record);
  EXPECT_NE(text.find(R"("code":"held_by_mechanics")"), std::string::npos) << text;
  const ScanRecord read = recordFromText(text, "record");
  EXPECT_EQ(read.registration.finding, record.registration.finding);
  EXPECT_EQ(read.registration.stability.weakMotions, record.registration.stability.weakMotions);
  EXPECT_EQ(read.predicted->weakMotions, record.predicted->weakMotions);
  EXPECT_EQ(read.seconds, record.seconds);
}

TEST(EarlierWording, ARecordWithSentencesReadsAsOneWithCodes) {
  const ScanRecord record = doubtfulRecord();
  auto json = nlohmann::json::parse(textOf(record));
  auto& registration = json["registration"];
  registration["reason"] =
      "the surface turns about (0.7, 0.7, 0.0): that part of the pose is the mechanics' word alone";
  registration["stability"].erase("weak_motions");
  registration["stability"]["weak_name"] = "turns about (0.7, 0.7, 0.0)";
  json["predicted"].erase("weak_motions");
  json["predicted"]["worst_direction"] = "slides along x and slides along y";
  json["seconds"] = {{"register", 0.5}, {"Registering", 0.75}, {"Refining all views", 0.25}, {"choose", 0.25}};
  EXPECT_EQ(textOf(recordFromText(json.dump(), "record")), textOf(record));
}

}  // namespace
}  // namespace vantage
