#include <gtest/gtest.h>

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
  SimulatedScanner scanner(testing::smallObject(), profile, {});
  const auto state = [&] { return Session::open(path, SessionAccess::Read).state(); };

  for (int i = 0; i < 3; ++i) {
    const NextScan next = nextScan(*state());
    ASSERT_GE(next.position, 0);
    const std::string range = folder.file("scan" + std::to_string(i) + ".ply");
    writeRangeFile(scanner.scan(next.position, Progress()), range);
    testing::ChildProgram step(
        {VANTAGE_CLI, "step", path, "--range", range, "--position", std::to_string(next.position), "--threads", "1"},
        folder.file("log"));
    ASSERT_EQ(step.wait(), 0);
  }
  EXPECT_EQ(state()->views.size(), 3U);
  EXPECT_EQ(state()->termination, Termination::MaxViews);
  EXPECT_TRUE(state()->records[2].predicted);
  EXPECT_GT(state()->model->mesh.triangles.size(), 500U);
}

}  // namespace
}  // namespace vantage
