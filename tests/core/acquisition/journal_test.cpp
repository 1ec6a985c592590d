#include "acquisition/journal.h"

#include <gtest/gtest.h>

#include "acquisition/memory_journal.h"
#include "base/errors.h"
#include "session/session.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

AcquisitionSettings fourViews() {
  AcquisitionSettings settings;
  settings.maxViews = 4;
  return settings;
}

// What every journal keeps, whether in memory or in a file: the law is the same for both.
class JournalLaws : public ::testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (GetParam())
      journal_ = std::make_unique<Session>(testing::createSmallSession(folder_.file("laws.vantage"), fourViews()));
    else
      journal_ = std::make_unique<MemoryJournal>(testing::smallProfile(), fourViews());
  }

  [[nodiscard]] RangeImage scanAt(int position) const {
    return scanFrom(testing::simulation(testing::smallObject(), journal_->state()->profile), position, Progress());
  }

  testing::TemporaryFolder folder_;
  std::unique_ptr<Journal> journal_;
};

TEST_P(JournalLaws, BeginsWithItsSettings) {
  ASSERT_EQ(journal_->history().size(), 1U);
  EXPECT_EQ(kindOf(journal_->history().current().command), "change_settings");
  EXPECT_EQ(journal_->state()->settings, fourViews());
  EXPECT_EQ(journal_->scanCount(), 0);
  EXPECT_FALSE(journal_->unusedScan());
  EXPECT_FALSE(journal_->lastStation());
}

TEST_P(JournalLaws, AScanIsKeptBeforeAnyCommandUsesIt) {
  EXPECT_EQ(journal_->keepScan(scanAt(3)).number, 0);
  EXPECT_EQ(journal_->scanCount(), 1);
  ASSERT_TRUE(journal_->unusedScan());
  EXPECT_EQ(journal_->unusedScan()->number, 0);
  EXPECT_EQ(journal_->lastStation()->position, 3);
  EXPECT_TRUE(journal_->state()->scans.empty());
  Acquisition(*journal_).carryOut(AddScan{0, {}});
  EXPECT_FALSE(journal_->unusedScan());
  EXPECT_EQ(journal_->state()->scans[0].view.image, journal_->scan(0));
}

TEST_P(JournalLaws, KeepsNoScanOfAPositionThatThereIsNot) {
  RangeImage image = scanAt(3);
  for (const int position : {-1, 24}) {
    image.station.position = position;
    EXPECT_THROW(static_cast<void>(journal_->keepScan(image)), InvalidInput) << position;
  }
  EXPECT_EQ(journal_->scanCount(), 0);
  EXPECT_THROW(static_cast<void>(journal_->scan(0)), InvalidInput);
}

TEST_P(JournalLaws, UndoKeepsTheScansAndACommandCutsOffWhatCouldBeRedone) {
  Acquisition acquisition(*journal_);
  journal_->keepScan(scanAt(0));
  acquisition.carryOut(AddScan{0, {}});
  acquisition.carryOut(ChoosePosition{5});
  const std::uint64_t chosen = stateHash(*journal_->state());
  acquisition.undo();
  EXPECT_FALSE(journal_->state()->chosenPosition);
  acquisition.redo();
  EXPECT_EQ(stateHash(*journal_->state()), chosen);
  acquisition.undo();
  acquisition.undo();
  EXPECT_TRUE(journal_->state()->scans.empty());
  EXPECT_EQ(journal_->scanCount(), 1);
  acquisition.carryOut(ChangeMode{Mode::Assisted});
  EXPECT_TRUE(acquisition.mayRedo());
  ASSERT_EQ(journal_->history().size(), 2U);
  EXPECT_EQ(journal_->history().current().step, 4);
}

INSTANTIATE_TEST_SUITE_P(All, JournalLaws, ::testing::Bool(),
                         [](const auto& journal) { return journal.param ? "File" : "Memory"; });

TEST(Journal, MemoryAndFileComeToTheSameStates) {
  const testing::TemporaryFolder folder;
  Session file = testing::createSmallSession(folder.file("equal.vantage"), fourViews());
  MemoryJournal memory(file.profile(), fourViews());
  for (Journal* journal : {static_cast<Journal*>(&file), static_cast<Journal*>(&memory)}) {
    Acquisition acquisition(*journal, testing::smallTools(file.profile(), fourViews()));
    acquisition.scanNext();
    acquisition.scanNext();
    acquisition.carryOut(LeaveOutView{0});
    acquisition.carryOut(ChoosePosition{7});
    acquisition.undo();
  }
  ASSERT_EQ(memory.history().size(), file.history().size());
  EXPECT_EQ(memory.history().cursor(), file.history().cursor());
  for (std::size_t i = 0; i < file.history().size(); ++i)
    EXPECT_EQ(stateHash(*memory.history().state(i)), file.history().entry(i).hash) << i;
}

}  // namespace
}  // namespace vantage
