#include "present.h"

#include <gtest/gtest.h>

#include "acquisition/acquisition.h"
#include "positional_space/scanner_images.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

TEST(Present, BeforeASessionTheFirstViewComesNext) {
  const Present present = Present::before(5, 0);
  EXPECT_EQ(present.state(), nullptr);
  EXPECT_TRUE(present.moments().empty());
  EXPECT_EQ(present.nextPosition(), 5);
  EXPECT_EQ(present.furtherPosition(), 5);
  EXPECT_EQ(present.proposedPosition(), 5);
  EXPECT_EQ(present.tablePosition(), 0);
  EXPECT_FALSE(present.explained(5));
  EXPECT_FALSE(present.somethingBefore() || present.somethingUndone());
}

TEST(Present, OfASessionTellsWhatItsStateTells) {
  const testing::TemporaryFolder folder;
  const auto profile = testing::smallProfile();
  Session session = Session::create(folder.file("a.vantage"), {testing::smallProfileSource(), {}, nullptr, profile});
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*profile));
  Rig rig = opened(testing::simulation(testing::smallObject(), profile, {}));
  Acquisition acquisition(session, {rig, images});
  acquisition.scanNext();
  const Present scanned = Present::of(session);
  ASSERT_TRUE(scanned.nextPosition());
  EXPECT_EQ(scanned.tablePosition(), 0);
  EXPECT_EQ(scanned.moments().size(), session.history().size());
  EXPECT_TRUE(scanned.explained(*scanned.nextPosition()));
  EXPECT_FALSE(scanned.explained(-1));
  const int other = (*scanned.nextPosition() + 1) % static_cast<int>(profile->workspace.size());
  acquisition.carryOut(ChoosePosition{other});
  const Present chosen = Present::of(session);
  EXPECT_EQ(chosen.nextPosition(), other);
  EXPECT_EQ(chosen.proposedPosition(), scanned.nextPosition());
  acquisition.carryOut(Finish{Termination::EndedByOperator});
  const Present ended = Present::of(session);
  EXPECT_TRUE(ended.furtherPosition());
  acquisition.undo();
  EXPECT_TRUE(Present::of(session).somethingUndone());
}

}  // namespace
}  // namespace vantage
