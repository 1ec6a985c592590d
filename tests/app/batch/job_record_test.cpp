#include "cli/batch/job_record.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using Json = nlohmann::ordered_json;

JobRecord recordOf(std::vector<StepRecord> steps, std::string message = "") {
  return {Json{{"name", "mug"}}, std::move(steps), std::move(message), Json::object()};
}

const BatchJob kJob{"mug", "s.vantage", {{"acquire", {}}, {"report", {"report.html"}}}, {}};

TEST(JobRecord, ComesBackFromItsFile) {
  const testing::TemporaryFolder folder;
  EXPECT_FALSE(readJobRecord(folder.file("")));
  JobRecord record = recordOf({{"acquire", 4, 1.5}, {"report", 1, 0.25}}, "disk full");
  record.figures["views"] = 8;
  writeJobRecord(record, folder.file(""));
  const auto read = readJobRecord(folder.file(""));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->described, record.described);
  EXPECT_EQ(read->figures, record.figures);
  EXPECT_EQ(read->message, "disk full");
  ASSERT_EQ(read->steps.size(), 2U);
  EXPECT_EQ(read->steps[1].command, "report");
  EXPECT_EQ(read->steps[1].exitCode, 1);
  EXPECT_EQ(read->steps[1].seconds, 0.25);
  EXPECT_EQ(read->done(), 1U);
}

TEST(JobRecord, AFileThatIsNoneIsSaid) {
  const testing::TemporaryFolder folder;
  folder.write("job.json", "{}");
  EXPECT_THROW(static_cast<void>(readJobRecord(folder.file(""))), InvalidInput);
}

TEST(JobRecord, StatusIsWhatTheStepsCameTo) {
  EXPECT_EQ(statusOf(std::nullopt, kJob), "not_run");
  EXPECT_EQ(statusOf(recordOf({}), kJob), "running");
  EXPECT_EQ(statusOf(recordOf({{"acquire", 0, 1}}), kJob), "running");
  EXPECT_EQ(statusOf(recordOf({{"acquire", 0, 1}, {"report", 0, 1}}), kJob), "done");
  EXPECT_EQ(statusOf(recordOf({{"acquire", 4, 1}, {"report", 0, 1}}), kJob), "done_but");
  EXPECT_EQ(statusOf(recordOf({{"acquire", 1, 1}}, "no such file"), kJob), "failed");
  EXPECT_EQ(statusOf(recordOf({{"acquire", 139, 1}}, "ended"), kJob), "failed");
  EXPECT_EQ(statusOf(recordOf({{"acquire", 3, 1}}, "cancelled"), kJob), "cancelled");
  EXPECT_EQ(statusOf(recordOf({}, "cannot be started"), kJob), "failed");
}

TEST(JobRecord, FiguresAreTakenFromWhatWasPrinted) {
  const Json figures = figuresOf(Json::parse(R"({"views": [{}, {}], "terminated_by": "finished",
      "model": {"triangles": 10, "boundary_edges": 2, "area_mm2": 1.5}, "completeness": {"scannable_covered": 0.9},
      "warnings": [{"code": "a"}, {"code": "b"}, {"code": "a"}]})"));
  EXPECT_EQ(figures, Json::parse(R"({"views": 2, "ended": "finished", "triangles": 10, "boundary_edges": 2,
      "area_mm2": 1.5, "covered": 0.9, "warnings": "a, b"})"));
  const Json import = figuresOf(Json::parse(R"({"scans": [{"verdict": "good"}, {"verdict": "failed"}]})"));
  EXPECT_EQ(import["views"], 1);
  EXPECT_EQ(import["rejected"], 1);
  EXPECT_TRUE(figuresOf(Json(Json::value_t::discarded)).empty());
}

}  // namespace
}  // namespace vantage
