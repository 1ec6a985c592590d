#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "acquisition/next_scan.h"
#include "app/child_program.h"
#include "io/range_files.h"
#include "session/session.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

// An operator who turns the table by hand, and has the files of the scanner added one by one.
TEST(StepCommand, AddsTheScansOfAnOperatorUntilTheModelIsThere) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("assisted.vantage");
  AcquisitionSettings settings;
  settings.maxViews = 3;
  const auto profile = Session::create(path, {testing::smallProfileSource(), settings, nullptr}).profile();
  const Rig rig = testing::simulation(testing::smallObject(), profile);
  const auto state = [&] { return Session::open(path, SessionAccess::Read).state(); };

  for (int i = 0; i < 3; ++i) {
    const std::optional<int> next = nextPosition(*state());
    ASSERT_TRUE(next);
    const std::string range = folder.file("scan" + std::to_string(i) + ".ply");
    writeRangeFile(scanFrom(rig, *next, Progress()), range);
    testing::ChildProgram step(
        {VANTAGE_CLI, "step", path, "--range", range, "--position", std::to_string(*next), "--threads", "1"},
        folder.file("log"));
    const int code = step.wait();
    ASSERT_TRUE(code == 0 || code == 4) << code;
  }
  EXPECT_EQ(countScans(*state(), ScanStatus::In), 3U);
  EXPECT_EQ(state()->termination, Termination::MaxViews);
  EXPECT_TRUE(state()->scans[2].record.predicted);
  EXPECT_GT(state()->model->mesh.triangles.size(), 500U);
}

// A file of another position than was said: it is refused with the turn that it fits, and taken from there.
TEST(StepCommand, AScanOfAnotherPositionIsTakenAsFromThere) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("mixed_up.vantage");
  AcquisitionSettings settings;
  settings.registration.limits.fewPairs = 100;
  const auto profile = Session::create(path, {testing::smallProfileSource(), settings, nullptr}).profile();
  const Rig rig = testing::simulation(testing::smallObject(), profile);
  const auto run = [&](const std::vector<std::string>& arguments) {
    return testing::ChildProgram(arguments, folder.file("log")).wait();
  };
  const auto step = [&](int from, int said) {
    const std::string range = folder.file("scan" + std::to_string(said) + ".ply");
    writeRangeFile(scanFrom(rig, from, Progress()), range);
    return run({VANTAGE_CLI, "step", path, "--range", range, "--position", std::to_string(said), "--threads", "1"});
  };
  for (const int position : {0, 1, 2, 3}) static_cast<void>(step(position, position));
  EXPECT_EQ(run({VANTAGE_CLI, "take", path}), 1) << "nothing was refused";
  static_cast<void>(step(2, 8));
  const auto last = [&] { return Session::open(path, SessionAccess::Read).state()->scans.back(); };
  ASSERT_EQ(last().status, ScanStatus::Rejected);
  EXPECT_EQ(run({VANTAGE_CLI, "take", path, "--table-deg", "200"}), 1) << "it fits elsewhere";
  EXPECT_NE(run({VANTAGE_CLI, "take", path}), 1);
  EXPECT_EQ(last().status, ScanStatus::In);
  EXPECT_EQ(last().record.registration.finding.reason, VerdictReason::TakenElsewhere);
}

}  // namespace
}  // namespace vantage
