#include "cli/batch/batch_summary.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

using Json = nlohmann::ordered_json;

class BatchSummary : public ::testing::Test {
 protected:
  BatchSummary() {
    JobRecord done{{}, {{"acquire", 4, 1.25}, {"report", 0, 0.5}}, "", Json::object()};
    done.figures = Json{{"views", 8}, {"covered", 0.98765}, {"warnings", "ended_early, rejected"}};
    const JobRecord failed{{}, {{"import", 1, 0.1}}, "=cmd(\"x\"), <b>", Json::object()};
    results_ = {{&jobs_[0], done}, {&jobs_[1], failed}, {&jobs_[2], std::nullopt}};
  }

  std::vector<BatchJob> jobs_{{"mug", "", {{"acquire", {}}, {"report", {"report.html"}}}, {}},
                              {"he,ad", "", {{"import", {}}}, {}},
                              {"later", "", {{"import", {}}}, {}}};
  std::vector<BatchResult> results_;
};

TEST_F(BatchSummary, SaysOfEveryJobWhatIsKnown) {
  const Json jobs = summaryJson(results_)["jobs"];
  ASSERT_EQ(jobs.size(), 3U);
  EXPECT_EQ(jobs[0]["status"], "done_but");
  EXPECT_EQ(jobs[0]["exit_code"], 4);
  EXPECT_EQ(jobs[0]["seconds"], 1.75);
  EXPECT_EQ(jobs[0]["views"], 8);
  EXPECT_TRUE(jobs[0]["message"].is_null());
  EXPECT_EQ(jobs[1]["status"], "failed");
  EXPECT_EQ(jobs[1]["exit_code"], 1);
  EXPECT_EQ(jobs[1]["failed_step"], "import");
  EXPECT_EQ(jobs[2]["status"], "not_run");
  EXPECT_TRUE(jobs[2]["exit_code"].is_null());
  EXPECT_EQ(countStatus(results_, "failed"), 1U);
}

TEST_F(BatchSummary, TheTableKeepsItsColumnsWhateverIsWrittenInIt) {
  const std::string csv = summaryCsv(summaryJson(results_));
  EXPECT_EQ(csv,
            "job,status,exit_code,failed_step,seconds,views,rejected,ended,covered,triangles,boundary_edges,area_mm2,"
            "warnings,message\n"
            "mug,done_but,4,,1.8,8,,,0.9877,,,,\"ended_early, rejected\",\n"
            "\"he,ad\",failed,1,import,0.1,,,,,,,,,\"'=cmd(\"\"x\"\"), <b>\"\n"
            "later,not_run,,,,,,,,,,,,\n");
}

TEST_F(BatchSummary, ThePageEscapesAndLinks) {
  const std::string html = summaryHtml(summaryJson(results_), {"mug/report 1.html", "", ""});
  EXPECT_NE(html.find("<a href=\"mug/report%201.html\">mug</a>"), std::string::npos);
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_NE(html.find("&lt;b&gt;"), std::string::npos);
  EXPECT_NE(html.find("<tr class=\"failed\">"), std::string::npos);
}

}  // namespace
}  // namespace vantage
