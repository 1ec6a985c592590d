#include "report/html_report.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "report/svg_chart.h"

namespace vantage {
namespace {

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) ++count;
  return count;
}

bool contains(const std::string& text, const std::string& what) {
  return occurrences(text, what) > 0;
}

// Two views, of which the plan after the second left three edges.
AcquisitionState twoViews() {
  AcquisitionState state;
  auto voids = std::make_shared<VoidSurface>();
  for (const double width : {1.0, 2.0, 4.0}) {
    VoidPatch patch;
    patch.width = width;
    voids->patches.push_back(patch);
  }
  auto plan = std::make_shared<Plan>();
  plan->terminationThreshold = 20.0;
  plan->leastOverlap = 150.0;
  plan->position = 1;
  for (int i = 0; i < 4; ++i) {
    PositionScore score;
    score.position = i;
    score.voidArea = 10.0 * i;
    plan->scores.push_back(score);
  }
  plan->voids = voids;
  plan->outlook.resize(3);
  plan->outlook[0].reason = plan->outlook[2].reason = EdgeReason::OutOfReach;
  plan->outlook[1].reason = EdgeReason::ReceiverBlocked;
  for (const double area : {1200.0, 345.0}) {
    auto image = std::make_shared<RangeImage>();
    image->station.position = static_cast<int>(area) % 7;
    KeptScan scan;
    scan.number = static_cast<std::int64_t>(state.scans.size());
    scan.view.image = image;
    scan.record.newArea = area;
    scan.record.seconds = {{Phase::Scan, 0.25}, {Phase::Choose, 1.5}};
    state.scans.push_back(scan);
  }
  state.scans.back().record.planAfter = plan;
  state.plan = plan;
  state.settings.simulation.object = "a<b>&.ply";
  state.termination = Termination::Finished;
  return state;
}

TEST(HtmlReport, SumsTheTimesOfEachPhase) {
  const std::string html = makeHtmlReport(twoViews(), {});
  EXPECT_TRUE(contains(html, "<th>All</th><th>0.50</th>"));
  EXPECT_TRUE(contains(html, "<th>3.00</th></tr>"));
}

TEST(HtmlReport, SumsTheLengthThatIsLeftByReason) {
  const std::string html = makeHtmlReport(twoViews(), {});
  EXPECT_TRUE(contains(html, "reaches it.</td><td>2</td><td>5</td>"));
  EXPECT_TRUE(contains(html, "every receiver.</td><td>1</td><td>2</td>"));
  EXPECT_FALSE(contains(html, "breakdown angle."));
}

TEST(HtmlReport, DrawsOnePointPerViewAndOneBarPerPosition) {
  const std::string html = makeHtmlReport(twoViews(), {});
  EXPECT_EQ(occurrences(html, "<circle"), 2U);
  EXPECT_EQ(occurrences(html, "<rect"), 4U);
  EXPECT_EQ(occurrences(html, "<rect class=\"marked\""), 1U);
}

TEST(HtmlReport, NeedsNoOtherFileAndEscapesNames) {
  HtmlReportOptions options;
  options.pictures.push_back({"The \"model\"", "Man"});
  const std::string html = makeHtmlReport(twoViews(), options);
  EXPECT_TRUE(contains(html, "a&lt;b&gt;&amp;.ply"));
  EXPECT_TRUE(contains(html, "alt=\"The &quot;model&quot;\" src=\"data:image/png;base64,TWFu\""));
  EXPECT_FALSE(contains(html, "http"));
  EXPECT_FALSE(contains(html, "src=\"/"));
}

// It is handed on, and printed.
TEST(HtmlReport, NamesTheObjectWithoutItsFolderAndSaysHowCompleteTheModelIs) {
  AcquisitionState state = twoViews();
  state.settings.simulation.object = "/home/somebody/secret/mug.ply";
  auto model = std::make_shared<Model>();
  model->mesh.vertices = {{0, 0, 0}, {20, 0, 0}, {0, 10, 0}};
  model->mesh.triangles = {{0, 1, 2}};
  state.model = model;
  const std::string html = makeHtmlReport(state, {});
  EXPECT_TRUE(contains(html, "<td>mug.ply</td>"));
  EXPECT_FALSE(contains(html, "somebody"));
  EXPECT_TRUE(contains(html, "20.0 × 10.0 × 0.0 mm, all lengths in millimetres"));
  EXPECT_TRUE(contains(html, "<td>Openings</td><td>1</td>"));
  EXPECT_TRUE(contains(html, "<td>Loose pieces</td><td>1</td>"));
  EXPECT_TRUE(contains(html, "<td>Closed</td><td>no</td>"));
  EXPECT_TRUE(contains(html, "@media print"));
  EXPECT_TRUE(contains(html, "much larger"));
}

TEST(HtmlReport, CountsScansByTheirNumbers) {
  AcquisitionState state = twoViews();
  state.scans.front().status = ScanStatus::LeftOut;
  const std::string html = makeHtmlReport(state, {});
  EXPECT_TRUE(contains(html, "<td>0, left out</td>"));
  EXPECT_TRUE(contains(html, "<tr><td>1</td>"));
}

TEST(HtmlReport, EncodesPicturesOfAnyLength) {
  for (const auto& [bytes, text] : {std::pair{"M", "TQ=="}, std::pair{"Ma", "TWE="}, std::pair{"Many", "TWFueQ=="}}) {
    HtmlReportOptions options;
    options.pictures.push_back({"", bytes});
    EXPECT_TRUE(contains(makeHtmlReport({}, options), std::string("base64,") + text + "\"")) << bytes;
  }
}

TEST(HtmlReport, DescribesASessionWithoutViews) {
  const std::string html = makeHtmlReport({}, {});
  EXPECT_TRUE(contains(html, "The acquisition goes on."));
  EXPECT_TRUE(contains(html, "recorded scans"));
  EXPECT_TRUE(contains(html, "</html>"));
}

TEST(HtmlReport, RefusesPicturesThatAreNotOnePerView) {
  HtmlReportOptions options;
  options.viewPictures.resize(1);
  EXPECT_THROW(static_cast<void>(makeHtmlReport(twoViews(), options)), InvalidInput);
}

TEST(SvgChart, EndsItsAxisAtARoundNumberAboveTheLargestValue) {
  EXPECT_TRUE(contains(drawChart(LineChart{"l", {25058.0}}), ">30000</text>"));
  EXPECT_TRUE(contains(drawChart(BarChart{"b", {3.0, 42.0}, {}, "", -1}), ">50</text>"));
  EXPECT_TRUE(contains(drawChart(LineChart{"l", {180.0}}), ">200</text>"));
  EXPECT_TRUE(contains(drawChart(LineChart{"l", {}}), ">1.0</text>"));
}

TEST(SvgChart, RefusesWhatCannotBeDrawn) {
  EXPECT_THROW(static_cast<void>(drawChart(BarChart{"b", {-1.0}, {}, "", -1})), InvalidInput);
  EXPECT_THROW(static_cast<void>(drawChart(LineChart{"l", {1.0 / 0.0}})), InvalidInput);
}

TEST(HtmlReport, SaysWhatAFurtherViewWouldShowWhenTheOperatorEndedIt) {
  AcquisitionState state = twoViews();
  auto plan = std::make_shared<Plan>(*state.plan);
  plan->outcome = PlanOutcome::Found;
  state.plan = plan;
  state.profile = std::make_shared<const ScannerProfile>();
  state.termination = Termination::EndedByOperator;
  const std::string html = makeHtmlReport(state, {});
  EXPECT_TRUE(contains(html, "<p>Ended by the operator. A view from position 1 would still show 10 mm².</p>"));
  EXPECT_FALSE(contains(html, "chosen"));
}

TEST(HtmlReport, ClaimsNoAreasForRecordedScans) {
  AcquisitionState state = twoViews();
  for (KeptScan& scan : state.scans) scan.record.newArea = 0.0;
  state.termination = Termination::Imported;
  const std::string html = makeHtmlReport(state, {});
  EXPECT_FALSE(contains(html, "<h2>Coverage"));
  EXPECT_TRUE(contains(html, "<td>–</td><td>–</td><td>–</td><td>–</td><td>0.000</td>"));
}

}  // namespace
}  // namespace vantage
