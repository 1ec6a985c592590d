#include "cli/batch/batch_jobs.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/errors.h"
#include "support/test_data.h"

namespace vantage {
namespace {

// A table of commands as small as the file needs.
class BatchJobs : public ::testing::Test {
 protected:
  BatchJobs() {
    CLI::App* acquire = app_.add_subcommand("acquire");
    acquire->add_option("--object", text_);
    acquire->add_option("--scanner", text_);
    acquire->add_option("--out", text_);
    acquire->add_option("--max-views", number_);
    acquire->add_option("--set", texts_);
    acquire->add_flag("--ideal", flag_);
    CLI::App* import = app_.add_subcommand("import");
    import->add_option("range", texts_);
    import->add_option("--poses", text_);
    import->add_option("--position", numbers_)->delimiter(',');
  }

  [[nodiscard]] BatchFile read(const std::string& json, const std::string& out = "") const {
    return readBatchFile(temporary_.write("jobs.json", json), out, app_);
  }
  [[nodiscard]] std::string refusal(const std::string& json) const {
    try {
      static_cast<void>(read(json));
    } catch (const InvalidInput& e) {
      return e.what();
    }
    return "accepted";
  }
  void expectRefusal(const std::string& jobs, const std::string& pointer, const std::string& expected) const {
    const std::string text = refusal(R"({"jobs": [)" + jobs + "]}");
    EXPECT_NE(text.find(pointer + ": expected"), std::string::npos) << text;
    EXPECT_NE(text.find(expected), std::string::npos) << text;
  }

  CLI::App app_;
  std::string text_;
  int number_ = 0;
  bool flag_ = false;
  std::vector<std::string> texts_;
  std::vector<int> numbers_;
  testing::TemporaryFolder temporary_;
};

using Arguments = std::vector<std::string>;

TEST_F(BatchJobs, OptionsAreThoseOfTheCommand) {
  const BatchFile file =
      read(R"({"jobs": [{"name": "mug", "acquire": {"object": "mug.ply", "max-views": 3, "ideal": true,
      "set": {"planner.tolerance": 0.3, "simulation.ideal": false}}, "export": "a.obj", "report": true}]})");
  ASSERT_EQ(file.jobs.size(), 1U);
  const BatchJob& job = file.jobs.front();
  EXPECT_EQ(file.out, temporary_.file("jobs"));
  EXPECT_EQ(job.session, temporary_.file("jobs/mug/session.vantage"));
  ASSERT_EQ(job.steps.size(), 3U);
  EXPECT_EQ(job.steps[0].command, "acquire");
  EXPECT_EQ(job.steps[0].arguments, (Arguments{"--object=mug.ply", "--max-views=3", "--ideal",
                                               "--set=planner.tolerance=0.3", "--set=simulation.ideal=false"}));
  EXPECT_EQ(job.steps[1].command, "export");
  EXPECT_EQ(job.steps[1].arguments, Arguments{"a.obj"});
  EXPECT_EQ(job.steps[2].command, "report");
  EXPECT_EQ(job.steps[2].arguments, Arguments{"report.html"});
}

TEST_F(BatchJobs, ScansOfAnImportComeLastAndPositionsInOneWord) {
  const BatchFile file = read(R"({"out": "there", "jobs": [
      {"name": "head", "import": {"range": ["-a.ply", "b.ply"], "position": [0, 4], "poses": "p.conf"}}]})");
  EXPECT_EQ(file.out, temporary_.file("there"));
  EXPECT_EQ(file.jobs[0].steps[0].arguments, (Arguments{"--position=0,4", "--poses=p.conf", "--", "-a.ply", "b.ply"}));
}

TEST_F(BatchJobs, WhatAllHaveIsOverruledOptionByOption) {
  const BatchFile file = read(R"({"all": {"acquire": {"scanner": "s.json", "max-views": 9}, "report": true}, "jobs": [
      {"name": "a", "acquire": {"object": "a.ply"}}, {"name": "b", "acquire": {"object": "b.ply", "max-views": 2}, "report": false},
      {"name": "c", "session": "c.vantage"}]})");
  EXPECT_EQ(file.jobs[0].steps[0].arguments, (Arguments{"--object=a.ply", "--scanner=s.json", "--max-views=9"}));
  EXPECT_EQ(file.jobs[1].steps[0].arguments, (Arguments{"--object=b.ply", "--max-views=2", "--scanner=s.json"}));
  EXPECT_EQ(file.jobs[1].steps.size(), 1U);
  EXPECT_EQ(file.jobs[2].session, temporary_.file("c.vantage"));
  ASSERT_EQ(file.jobs[2].steps.size(), 1U);
  EXPECT_EQ(file.jobs[2].steps[0].command, "report");
}

TEST_F(BatchJobs, TheFolderOfTheCommandLineIsTaken) {
  const std::string json = R"({"out": "there", "jobs": [{"name": "a", "acquire": {}}]})";
  EXPECT_EQ(read(json, "/elsewhere").jobs[0].session, "/elsewhere/a/session.vantage");
}

TEST_F(BatchJobs, WhatCannotBeUnderstoodIsNamed) {
  EXPECT_NE(refusal("{").find("is no JSON"), std::string::npos);
  EXPECT_NE(refusal("[]").find("expected an object"), std::string::npos);
  EXPECT_NE(refusal(R"({"jobs": []})").find("/jobs: expected a list of jobs"), std::string::npos);
  EXPECT_NE(refusal(R"({"jobs": [], "threads": 3})").find("/threads: expected one of"), std::string::npos);
  expectRefusal(R"({"name": "a"})", "/jobs/0", "one of acquire, import and session");
  expectRefusal(R"({"name": "a", "acquire": {}, "session": "s"})", "/jobs/0", "one of");
  expectRefusal(R"({"name": "a", "session": "s"})", "/jobs/0", "something to be done");
  expectRefusal(R"({"name": "a/b", "acquire": {}})", "/jobs/0/name", "a folder can have");
  expectRefusal(R"({"name": "..", "acquire": {}})", "/jobs/0/name", "a folder can have");
  expectRefusal(R"({"acquire": {}})", "/jobs/0/name", "a folder can have");
  expectRefusal(R"({"name": "a", "acquire": {"objekt": "x"}})", "/jobs/0/acquire/objekt", "an option of acquire");
  expectRefusal(R"({"name": "a", "acquire": {"out": "x"}})", "/jobs/0/acquire/out", "does not set itself");
  expectRefusal(R"({"name": "a", "acquire": {"ideal": 1}})", "/jobs/0/acquire/ideal", "true or false");
  expectRefusal(R"({"name": "a", "acquire": {"object": {}}})", "/jobs/0/acquire/object", "a text or a number");
  expectRefusal(R"({"name": "a", "acquire": {"set": ["x"]}})", "/jobs/0/acquire/set", "an object of settings");
  expectRefusal(R"({"name": "a", "import": {}})", "/jobs/0/import/range", "the files");
  expectRefusal(R"({"name": "a", "acquire": {}, "export": ["../x.ply"]})", "/jobs/0/export/0", "the name of a file");
  expectRefusal(R"({"name": "a", "acquire": {}, "report": 3})", "/jobs/0/report", "the name of a file");
  expectRefusal(R"({"name": "a", "acquire": {}}, {"name": "a", "acquire": {}})", "/jobs/1/name", "no other job");
  EXPECT_THROW(static_cast<void>(readBatchFile(temporary_.file("none.json"), "", app_)), IoError);
}

}  // namespace
}  // namespace vantage
