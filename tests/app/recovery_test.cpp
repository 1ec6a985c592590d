#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/child_program.h"
#include "base/random.h"
#include "io/mesh_writer.h"
#include "session/database.h"
#include "session/session.h"
#include "session/session_blobs.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

// An acquisition that is killed, or whose last write is cut, goes on to what it would have become.
// VANTAGE_RECOVERY_RUNS tells how many are killed, and cut (default 6).

namespace vantage {
namespace {

namespace fs = std::filesystem;

int runs() {
  const char* count = std::getenv("VANTAGE_RECOVERY_RUNS");
  return count == nullptr ? 6 : std::atoi(count);
}

std::string bytesOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A report without what depends on the machine.
nlohmann::json reportOf(const std::string& path) {
  nlohmann::json report = nlohmann::json::parse(bytesOf(path));
  report.erase("peak_memory_mb");
  for (auto& view : report["views"]) view.erase("seconds");
  return report;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

bool intact(const std::string& path) {
  Database database(path, Database::Mode::Write);
  Statement check = database.prepare("PRAGMA integrity_check");
  return check.step() && check.text(0) == "ok";
}

constexpr int kDoneBut = 4;  // the greatest number of views ends it

class Recovery : public ::testing::Test {
 protected:
  void SetUp() override {
    exportMesh(testing::smallObject(), folder_.file("small.ply"));
    folder_.write("small.json", testing::smallProfileSource().text);
  }

  [[nodiscard]] testing::ChildProgram acquire(const std::string& out) const {
    return testing::ChildProgram({VANTAGE_CLI, "acquire", "--object", folder_.file("small.ply"), "--scanner",
                                  folder_.file("small.json"), "--out", folder_.file(out), "--threads", "1"},
                                 folder_.file(out + ".log"));
  }

  [[nodiscard]] int resume(const std::string& out) const {
    return testing::ChildProgram({VANTAGE_CLI, "resume", folder_.file(out + "/session.vantage"), "--threads", "1"},
                                 folder_.file(out + ".resume.log"))
        .wait();
  }

  void expectSameResults(const std::string& out, const std::string& reference) const {
    EXPECT_TRUE(bytesOf(folder_.file(out + "/model.ply")) == bytesOf(folder_.file(reference + "/model.ply")));
    EXPECT_TRUE(reportOf(folder_.file(out + "/report.json")) == reportOf(folder_.file(reference + "/report.json")));
  }

  testing::TemporaryFolder folder_;
};

TEST_F(Recovery, KilledAtAnyMomentItGoesOnToTheSameModel) {
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(acquire("whole").wait(), kDoneBut);
  const auto whole = std::chrono::steady_clock::now() - begin;
  Random random(5);
  int killed = 0;
  // A run that ended before its moment counts as none, but must be as good.
  for (int i = 0; killed < runs() && i < 4 * runs(); ++i) {
    const std::string out = "run" + std::to_string(i);
    SCOPED_TRACE(out);
    testing::ChildProgram run = acquire(out);
    std::this_thread::sleep_for(whole * random.uniform());
    killed += run.kill() ? 1 : 0;
    const std::string log = bytesOf(folder_.file(out + ".log"));
    const std::size_t reported = count(log, "view ") + count(log, "scan at position");
    const std::string session = folder_.file(out + "/session.vantage");
    if (!fs::exists(session)) {
      // Killed before there was one: nothing was reported either.
      EXPECT_EQ(reported, 0U);
      continue;
    }
    EXPECT_TRUE(intact(session));
    EXPECT_GE(Session::open(session, SessionAccess::Read).scanCount(), static_cast<std::int64_t>(reported));
    EXPECT_EQ(resume(out), kDoneBut) << bytesOf(folder_.file(out + ".resume.log"));
    expectSameResults(out, "whole");
    fs::remove_all(folder_.file(out));
  }
  EXPECT_EQ(killed, runs());
}

TEST_F(Recovery, CutAnywhereInTheLastWriteItGoesOnToTheSameModel) {
  // The session after every step, as it lies on the disk.
  std::vector<std::string> databases;
  std::vector<std::string> logs;
  std::vector<std::byte> model;
  {
    const std::string path = folder_.file("whole.vantage");
    Session session = testing::createSmallSession(path, {});
    const auto look = [&] {
      // Two files cannot be read at once: nothing may be written between them.
      session.settle();
      databases.push_back(bytesOf(path));
      logs.push_back(bytesOf(path + "-wal"));
    };
    look();
    const auto observer = [&](const Command&, const AcquisitionState&, const AcquisitionState&) { look(); };
    model = modelBlob(*testing::runSmallSession(session, observer).model);
  }
  Random random(11);
  for (int i = 0; i < runs(); ++i) {
    const std::size_t step = 1 + random.below(logs.size() - 1);
    // A log that began anew after a checkpoint is cut anywhere.
    const std::size_t from = logs[step].size() > logs[step - 1].size() ? logs[step - 1].size() : 0;
    const std::size_t cut = from + random.below(logs[step].size() - from);
    const std::string path = folder_.write("cut.vantage", databases[step]);
    fs::remove(path + "-shm");
    folder_.write("cut.vantage-wal", logs[step].substr(0, cut));
    {
      Session session = Session::open(path, SessionAccess::Write);
      EXPECT_TRUE(session.losses().empty());
      EXPECT_GE(session.history().size(), step) << "step " << step << " cut at byte " << cut;
      const AcquisitionState end = testing::runSmallSession(session);
      EXPECT_EQ(modelBlob(*end.model), model) << "step " << step << " cut at byte " << cut;
    }
    EXPECT_TRUE(intact(path));
  }
}

}  // namespace
}  // namespace vantage
