#include "report/stands_html.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "report/html_report.h"

namespace vantage {
namespace {

KeptScan scanOf(std::int64_t number, int stand, ScanStatus status) {
  auto image = std::make_shared<RangeImage>();
  image->station.stand = stand;
  KeptScan scan;
  scan.number = number;
  scan.status = status;
  scan.view.image = image;
  return scan;
}

bool contains(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

StandAlignment alignmentOf(AlignmentVerdict verdict, AlignmentReason reason, std::optional<int> used,
                           PoseChoice choice) {
  StandAlignment alignment{verdict, reason, 2.0, {}, false, false, used, choice};
  for (const bool possible : {true, false}) {
    StandPose pose;
    pose.overlap = possible ? 0.456 : 0.123;
    pose.conflict = possible ? 0.0 : 0.07;
    pose.possible = possible;
    alignment.candidates.push_back(pose);
  }
  return alignment;
}

std::shared_ptr<const StandAlignment> shared(const StandAlignment& alignment) {
  return std::make_shared<const StandAlignment>(alignment);
}

// A first stand, one for every way to come into the model, and one that is not in it.
AcquisitionState manyStands() {
  AcquisitionState state;
  const auto several = AlignmentReason::SeveralPoses;
  for (const PoseChoice choice : {PoseChoice::Evidence, PoseChoice::Operator, PoseChoice::Despite})
    state.stands.push_back(
        {Pose::Identity(), {}, shared(alignmentOf(AlignmentVerdict::Ambiguous, several, 1, choice))});
  state.stands.push_back({{}, {}, shared(alignmentOf(AlignmentVerdict::Ambiguous, several, {}, PoseChoice::Evidence))});
  state.stands.push_back({Pose::Identity()});
  state.stands.emplace_back();
  state.scans = {scanOf(0, 0, ScanStatus::In), scanOf(1, 1, ScanStatus::In), scanOf(2, 1, ScanStatus::Rejected),
                 scanOf(3, 4, ScanStatus::Aside)};
  return state;
}

TEST(StandsHtml, SaysNothingOfAnObjectThatWasNotTurnedOver) {
  EXPECT_EQ(standsHtml({}, {}), "");
  EXPECT_FALSE(contains(makeHtmlReport({}, {}), "<h2>Stands</h2>"));
}

TEST(StandsHtml, SaysOfEveryStandWhatCameOfItAndWhoDecided) {
  const std::string html = standsHtml(manyStands(), {});
  EXPECT_TRUE(contains(html, "<h2>Stands</h2>"));
  EXPECT_TRUE(contains(html, "1 view in the model. The reference"));
  EXPECT_TRUE(contains(html,
                       "1 view in the model, 1 not used. Verdict ambiguous: 2 poses are possible. Pose 2, decided "
                       "by the evidence."));
  EXPECT_TRUE(contains(html, "Pose 2, chosen by the operator among the possible poses."));
  EXPECT_TRUE(contains(html, "Pose 2, used by the operator although something speaks against it."));
  EXPECT_TRUE(contains(html,
                       "0 views in the model, 1 set aside. Verdict ambiguous: 2 poses are possible. Its scans are "
                       "not in the model."));
  EXPECT_TRUE(contains(html, "In place, as the operator said."));
  EXPECT_TRUE(contains(html, "Not aligned yet: its scans are not in the model."));
  EXPECT_TRUE(contains(html, "<td>1</td><td>45.6</td><td>0.000</td><td>0.0</td><td>0.0</td><td>0.0</td><td>yes</td>"));
  EXPECT_TRUE(contains(html, "<td>2, in use</td><td>12.3</td>"));
  EXPECT_TRUE(contains(html, "<td>7.0</td>"));
}

TEST(StandsHtml, IsASectionOfTheReportWithAPictureOfEveryStand) {
  HtmlReportOptions options;
  options.standPictures.assign(7, {"As it stood", "ABC"});
  const std::string html = makeHtmlReport(manyStands(), options);
  EXPECT_TRUE(contains(html, "<h2>Stands</h2>"));
  EXPECT_TRUE(contains(html, "As it stood"));
  options.standPictures.pop_back();
  EXPECT_THROW(static_cast<void>(makeHtmlReport(manyStands(), options)), InvalidInput);
}

}  // namespace
}  // namespace vantage
