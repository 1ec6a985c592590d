#include "session/import_note.h"

#include <gtest/gtest.h>

#include "acquisition/acquisition.h"
#include "core/io/expect_error.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::TemporaryFolder;

// The scans of a small scene, taken from its first positions.
std::vector<RangeImage> someScans(int count) {
  const auto profile = testing::smallProfile();
  const Rig rig = testing::simulation(testing::smallObject(), profile);
  std::vector<RangeImage> scans;
  scans.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) scans.push_back(scanFrom(rig, i, Progress()));
  return scans;
}

TEST(InterruptedImport, GoesOnWithTheScansThatWereKept) {
  const TemporaryFolder folder;
  const std::string path = folder.file("s.vantage");
  ScanReading reading;
  reading.unit = 25.4;
  {
    Session session = Session::create(path, {testing::smallProfileSource(), {}, nullptr});
    EXPECT_FALSE(interruptedImport(session));
    noteImport(session, {reading, reading});
    for (RangeImage& scan : someScans(2)) session.keepScan(std::move(scan));
  }
  Session session = Session::open(path, SessionAccess::Write);
  const auto import = interruptedImport(session);
  ASSERT_TRUE(import);
  EXPECT_EQ(import->scans, (std::vector<std::int64_t>{0, 1}));
  Acquisition(session).carryOut(*import);
  EXPECT_EQ(session.state()->scans[1].record.reading->unit, 25.4);
  EXPECT_FALSE(interruptedImport(session));
}

TEST(InterruptedImport, SaysThatScansAreMissing) {
  const TemporaryFolder folder;
  Session session = Session::create(folder.file("s.vantage"), {testing::smallProfileSource(), {}, nullptr});
  noteImport(session, {{}, {}});
  for (RangeImage& scan : someScans(1)) session.keepScan(std::move(scan));
  testing::expectError<InvalidInput>([&] { static_cast<void>(interruptedImport(session)); },
                                     {"s.vantage", "1 of 2 scans", "once more"});
}

}  // namespace
}  // namespace vantage
