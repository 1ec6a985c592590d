#include <gtest/gtest.h>

#include <algorithm>

#include "acquisition/acquisition.h"
#include "acquisition/memory_journal.h"
#include "acquisition/stand_advice.h"
#include "acquisition/stand_aligner.h"
#include "acquisition/stand_alignment.h"
#include "acquisition/stand_composites.h"
#include "acquisition/stand_course.h"
#include "acquisition/stand_merging.h"
#include "core/io/expect_error.h"
#include "report/stands_html.h"
#include "report/stands_report.h"
#include "scanner/simulated_stand.h"
#include "session/session.h"
#include "session/session_schema.h"
#include "session/state_hash.h"
#include "support/scenes/knowing_aligner.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::KnowingAligner;
using testing::poseAt;

const Vec3 kDown = Vec3::UnitX();

Pose standOf(int stand) {
  return simulatedStand(testing::smallObject(), kDown, stand, 1);
}

// The small object upright, then turned over, and an aligner that knows how.
class CompositeStands : public ::testing::Test {
 protected:
  [[nodiscard]] AcquisitionTools tools(int stand, std::shared_ptr<const StandAligner> aligner = {}) const {
    return {testing::simulation(transformed(testing::smallObject(), standOf(stand)), profile_, {1, true}), images_,
            std::move(aligner)};
  }

  [[nodiscard]] static std::shared_ptr<const KnowingAligner> knowing(AlignmentVerdict verdict, bool possible = true) {
    return std::make_shared<const KnowingAligner>(
        verdict, std::vector{poseAt(standOf(1).inverse(), possible), poseAt(Pose::Identity(), false)});
  }

  // Two views upright, then so many turned over, nobody knows how.
  void acquire(Journal& journal, int turned) const {
    Acquisition upright(journal, tools(0));
    upright.scanNext();
    upright.scanNext();
    upright.carryOut(TurnObject{{}, kDown});
    Acquisition lying(journal, tools(1));
    for (int i = 0; i < turned; ++i) lying.scanNext();
  }

  static AcquisitionSettings fewViews() {
    AcquisitionSettings settings;
    settings.maxViews = 8;
    return settings;
  }

  // The worst distance of a view from where it was taken [mm].
  static double worstError(const AcquisitionState& state) {
    double worst = 0.0;
    for (const KeptScan* scan : scansOf(state, ScanStatus::In)) {
      const Pose truth = standOf(scan->station().stand).inverse() * scan->view.image->T_table_scanner;
      worst = std::max(worst, (scan->view.T_object_scanner.translation() - truth.translation()).norm());
    }
    return worst;
  }

  std::shared_ptr<const ScannerProfile> profile_ = testing::smallProfile();
  std::shared_ptr<const ScannerImages> images_ = std::make_shared<const ScannerImages>(computeScannerImages(*profile_));
};

TEST_F(CompositeStands, AreAcquiredAsAFirstStandIs) {
  MemoryJournal journal(profile_, fewViews());
  acquire(journal, 2);
  const AcquisitionState state = *journal.state();
  EXPECT_EQ(countScans(state, ScanStatus::In), 2U);
  EXPECT_EQ(countScans(state, ScanStatus::Aside), 2U);
  EXPECT_EQ(compositeInWork(state), 1);
  EXPECT_EQ(tableOf(state, 1).matrix(), Pose::Identity().matrix());
  EXPECT_EQ(state.stands[1].down, kDown);
  EXPECT_TRUE(state.plan);
  const AcquisitionState object = withObject(state);
  EXPECT_EQ(compositeInWork(object), referenceOf(object.stands));
  EXPECT_EQ(object.model, state.aside[0].model);
  EXPECT_FALSE(object.plan);
  const AcquisitionState back = withComposite(object, 1);
  EXPECT_EQ(back.model, state.model);
  EXPECT_EQ(countScans(back, ScanStatus::In), 2U);
}

TEST_F(CompositeStands, ComeToTheAlignerInTheFrameOfTheirTable) {
  MemoryJournal journal(profile_, fewViews());
  acquire(journal, 2);
  const Composite composite = compositeForAligner(*journal.state(), stepOptionsFor(*journal.state()));
  ASSERT_EQ(composite.views.size(), 2U);
  ASSERT_EQ(composite.tables.size(), 1U);
  EXPECT_EQ(composite.tables[0].height, 0.0);
  ASSERT_EQ(composite.ties.size(), 1U);
  EXPECT_EQ(composite.ties[0].to, 1U);
}

TEST_F(CompositeStands, ThatAreAlignedBecomePartOfTheObject) {
  MemoryJournal journal(profile_, fewViews());
  acquire(journal, 3);
  const auto aligner = knowing(AlignmentVerdict::Good);
  Acquisition acquisition(journal, tools(1, aligner));
  ASSERT_TRUE(mayFindItsPlace(*journal.state()));
  EXPECT_TRUE(alignStands(acquisition, false));
  EXPECT_EQ(aligner->objectViews, 2U);
  EXPECT_EQ(aligner->standViews, 3U);
  const AcquisitionState state = *journal.state();
  EXPECT_EQ(countScans(state, ScanStatus::In), 5U);
  EXPECT_TRUE(state.aside.empty());
  EXPECT_TRUE(standsToAlign(state).empty());
  EXPECT_LT(worstError(state), 1.0);
  ASSERT_TRUE(state.stands[1].T_object_table);
  EXPECT_TRUE(state.stands[1].T_object_table->isApprox(standOf(1).inverse(), 0.02));
  // What was found is said of the one that is no reference any more.
  EXPECT_FALSE(state.stands[0].alignment);
  ASSERT_TRUE(state.stands[1].alignment);
  EXPECT_EQ(state.stands[1].alignment->verdict, AlignmentVerdict::Good);
  const StandPose& used = state.stands[1].alignment->candidates.at(state.stands[1].alignment->used.value());
  EXPECT_TRUE(used.T_object_stand.isApprox(*state.stands[1].T_object_table, 0.02));
  EXPECT_NE(standsHtml(state, {}).find("Verdict good"), std::string::npos);
  EXPECT_EQ(standsJson(state)[1]["verdict"], "good");
  EXPECT_EQ(state.stands[1].alignment->used, 0);
  // The table goes on from where it is, for what the whole object lacks.
  ASSERT_TRUE(state.plan);
  EXPECT_FALSE(mayFindItsPlace(state));
  if (state.termination == Termination::Running) acquisition.scanNext();
  EXPECT_LT(worstError(*journal.state()), 1.0);
}

TEST_F(CompositeStands, ThatFindNoPlaceAreKeptWithWhatWasFound) {
  MemoryJournal journal(profile_, fewViews());
  acquire(journal, 3);
  Acquisition acquisition(journal, tools(1, knowing(AlignmentVerdict::Failed, false)));
  const std::size_t steps = journal.history().size();
  EXPECT_FALSE(alignStands(acquisition, false));
  EXPECT_EQ(journal.history().size(), steps);  // nothing worth recording
  EXPECT_FALSE(alignStands(acquisition, true));
  EXPECT_EQ(journal.history().size(), steps + 1);
  ASSERT_TRUE(journal.state()->stands[1].alignment);
  EXPECT_FALSE(journal.state()->stands[1].alignment->used);
  EXPECT_EQ(countScans(*journal.state(), ScanStatus::In), 3U);
  EXPECT_EQ(acquisition.mayDo(ChooseStandPose{1, 0})->reason, RefusalReason::PoseContradicted);
  EXPECT_EQ(acquisition.mayDo(ChooseStandPose{1, 2, true})->reason, RefusalReason::NoSuchPose);
  EXPECT_EQ(acquisition.mayDo(AlignStand{0})->reason, RefusalReason::StandKnown);
  acquisition.carryOut(ChooseStandPose{1, 0, true});
  EXPECT_EQ(journal.state()->stands[1].alignment->choice, PoseChoice::Despite);
  EXPECT_EQ(countScans(*journal.state(), ScanStatus::In), 5U);
  acquisition.undo();
  EXPECT_EQ(countScans(*journal.state(), ScanStatus::Aside), 2U);
}

TEST_F(CompositeStands, OfSeveralPosesTheOperatorChooses) {
  MemoryJournal journal(profile_, fewViews());
  acquire(journal, 2);
  Acquisition acquisition(journal, tools(1, knowing(AlignmentVerdict::Ambiguous)));
  EXPECT_EQ(acquisition.mayDo(ChooseStandPose{1, 0})->reason, RefusalReason::NotAligned);
  acquisition.carryOut(AlignStand{1, {{Vec3::Zero(), Vec3::Zero()}}});
  EXPECT_TRUE(journal.state()->stands[1].alignment->picked);
  EXPECT_EQ(standsToAlign(*journal.state()), std::vector<int>{1});
  acquisition.carryOut(ChooseStandPose{1, 0});
  EXPECT_EQ(journal.state()->stands[1].alignment->choice, PoseChoice::Operator);
  EXPECT_LT(worstError(*journal.state()), 1.0);
}

TEST_F(CompositeStands, OneThatWaitsIsTriedAgainOnceThereIsMoreOfTheObject) {
  MemoryJournal journal(profile_, fewViews());
  acquire(journal, 2);
  Acquisition failing(journal, tools(1, knowing(AlignmentVerdict::Failed, false)));
  EXPECT_FALSE(alignStands(failing, true));
  failing.carryOut(TurnObject{{}, kDown});
  EXPECT_EQ(journal.state()->aside.size(), 2U);
  EXPECT_FALSE(journal.state()->model);
  Acquisition last(journal, tools(1, knowing(AlignmentVerdict::Good)));  // the object stands as before
  last.scanNext();
  last.scanNext();
  EXPECT_TRUE(alignStands(last, true));
  EXPECT_EQ(countScans(*journal.state(), ScanStatus::In), 6U);
  EXPECT_TRUE(journal.state()->aside.empty());
}

// The first stand shows too little to fit others to: it waits itself, until the others make enough of the object.
TEST_F(CompositeStands, TheObjectIsKnownByTheStandThatShowsMost) {
  MemoryJournal journal(profile_, fewViews());
  Acquisition upright(journal, tools(0));
  upright.scanNext();
  upright.carryOut(TurnObject{{}, kDown});
  Acquisition failing(journal, tools(1, knowing(AlignmentVerdict::Failed, false)));
  for (int i = 0; i < 5; ++i) failing.scanNext();
  EXPECT_EQ(failing.mayDo(TakeReference{0})->reason, RefusalReason::StandKnown);
  EXPECT_FALSE(alignStands(failing, false));
  EXPECT_EQ(referenceOf(journal.state()->stands), 0);
  EXPECT_TRUE(alignStands(failing, true));
  AcquisitionState state = *journal.state();
  EXPECT_EQ(referenceOf(state.stands), 1);
  EXPECT_FALSE(isOfObject(state, 0));
  EXPECT_EQ(standsToAlign(state), std::vector<int>{0});
  EXPECT_EQ(countScans(state, ScanStatus::In), 5U);
  EXPECT_TRUE(state.plan);
  EXPECT_FALSE(sideMeant(state, 1));  // it was told in the coordinates of a stand that is not known

  // Sides are told in the coordinates of the object as it is known now.
  failing.carryOut(TurnObject{{}, Vec3::UnitY()});
  EXPECT_EQ(journal.state()->stands[2].reference, 1);
  EXPECT_EQ(sideMeant(*journal.state(), 2), Vec3(Vec3::UnitY()));
  failing.undo();

  // Once it is aligned, the object is known by the first one again.
  const auto first =
      std::make_shared<const KnowingAligner>(AlignmentVerdict::Good, std::vector{poseAt(standOf(1), true)});
  Acquisition last(journal, tools(1, first));
  last.carryOut(AlignStand{0});
  state = *journal.state();
  EXPECT_EQ(referenceOf(state.stands), 0);
  EXPECT_EQ(state.stands[0].T_object_table->matrix(), Pose::Identity().matrix());
  EXPECT_TRUE(state.stands[1].T_object_table->isApprox(standOf(1).inverse(), 0.02));
  // What was found is said of the one that is no reference any more.
  EXPECT_FALSE(state.stands[0].alignment);
  ASSERT_TRUE(state.stands[1].alignment);
  EXPECT_EQ(state.stands[1].alignment->verdict, AlignmentVerdict::Good);
  const StandPose& used = state.stands[1].alignment->candidates.at(state.stands[1].alignment->used.value());
  EXPECT_TRUE(used.T_object_stand.isApprox(*state.stands[1].T_object_table, 0.02));
  EXPECT_NE(standsHtml(state, {}).find("Verdict good"), std::string::npos);
  EXPECT_EQ(standsJson(state)[1]["verdict"], "good");
  EXPECT_EQ(countScans(state, ScanStatus::In), 6U);
  EXPECT_TRUE(state.aside.empty());
  EXPECT_LT(worstError(state), 1.0);
  EXPECT_EQ(sideMeant(state, 1), kDown);
}

TEST_F(CompositeStands, StandsThatAreTogetherKeepTheirReference) {
  MemoryJournal journal(profile_, fewViews());
  acquire(journal, 2);
  Acquisition acquisition(journal, tools(1, knowing(AlignmentVerdict::Good)));
  acquisition.carryOut(AlignStand{1});
  acquisition.carryOut(TurnObject{{}, kDown});
  EXPECT_EQ(acquisition.mayDo(TakeReference{2})->reason, RefusalReason::NothingToAlign);
  Acquisition last(journal, tools(2));
  last.scanNext();
  EXPECT_EQ(last.mayDo(TakeReference{2})->reason, RefusalReason::StandsTogether);
}

TEST_F(CompositeStands, AScanThatWasLeftOutStaysWithItsStand) {
  MemoryJournal journal(profile_, fewViews());
  Acquisition upright(journal, tools(0));
  upright.scanNext();
  upright.scanNext();
  upright.carryOut(LeaveOutView{1});
  upright.carryOut(TurnObject{{}, kDown});
  EXPECT_EQ(upright.mayDo(TakeBackView{1})->reason, RefusalReason::OtherStand);
}

TEST_F(CompositeStands, AreKeptInTheSessionFile) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("composites.vantage");
  std::vector<std::uint64_t> hashes;
  {
    Session session = testing::createSmallSession(path, fewViews());
    acquire(session, 2);
    Acquisition failing(session, tools(1, knowing(AlignmentVerdict::Failed, false)));
    failing.carryOut(AlignStand{1});
    failing.carryOut(ChooseStandPose{1, 0, true});
    for (std::size_t i = 0; i < session.history().size(); ++i) hashes.push_back(stateHash(*session.state(i)));
  }
  {
    const Session read = Session::open(path, SessionAccess::Read);
    read.check();
    EXPECT_TRUE(read.losses().empty());
    ASSERT_EQ(read.history().size(), hashes.size());
    for (std::size_t i = 0; i < hashes.size(); ++i) EXPECT_EQ(stateHash(*read.state(i)), hashes[i]) << i;
  }
  // Models that are lost are made again, also those that were set aside.
  {
    Database database(path, Database::Mode::Write);
    database.run("DELETE FROM model");
  }
  const Session again = Session::open(path, SessionAccess::Read);
  for (std::size_t i = 0; i < hashes.size(); ++i) EXPECT_EQ(stateHash(*again.state(i)), hashes[i]) << i;
}

TEST_F(CompositeStands, ThatFindNoPlaceAreRecordedWhenTheyHaveEnded) {
  MemoryJournal journal(profile_, fewViews());
  acquire(journal, 3);
  Acquisition acquisition(journal, tools(1, knowing(AlignmentVerdict::Failed, false)));
  EXPECT_TRUE(hasUntriedStand(*journal.state()));
  EXPECT_TRUE(findPlaces(acquisition));
  EXPECT_EQ(journal.state()->stands[1].alignment, nullptr);
  acquisition.carryOut(Finish{Termination::EndedByOperator});
  EXPECT_TRUE(findPlaces(acquisition));
  EXPECT_NE(journal.state()->stands[1].alignment, nullptr);
  EXPECT_FALSE(hasUntriedStand(*journal.state()));
  EXPECT_FALSE(findPlaces(acquisition)) << "it was tried";
}

TEST_F(CompositeStands, HideWhatNoSideShows) {
  MemoryJournal journal(profile_, fewViews());
  acquire(journal, 0);
  const StandOutlook outlook = lookAtStands(*journal.state());
  ASSERT_FALSE(outlook.sides.empty());
  EXPECT_GT(outlook.left, 0.0);
  EXPECT_GE(outlook.hidden, 0.0);
  for (const StandAdvice& side : outlook.sides) {
    EXPECT_LE(side.gain, (outlook.left - outlook.hidden) * (1.0 + 1e-9));
    EXPECT_NEAR(side.share, side.gain / outlook.left, 1e-12);
  }
}

TEST(StandCourse, IsANumberOrGoesByItself) {
  EXPECT_FALSE(parseStandCourse("auto").stands);
  EXPECT_EQ(parseStandCourse("3").stands, 3);
  EXPECT_EQ(name(parseStandCourse("auto")), "auto");
  EXPECT_EQ(name(StandCourse{3}), "3");
  for (const char* text : {"", "0", "-1", "many", "2x", "1001"})
    EXPECT_THROW(static_cast<void>(parseStandCourse(text)), InvalidInput) << text;
}

TEST_F(CompositeStands, ANextOneIsAdvisedUntilThereAreEnough) {
  MemoryJournal journal(profile_, fewViews());
  Acquisition upright(journal, tools(0));
  for (int i = 0; i < 3; ++i) upright.scanNext();
  const std::vector<StandAdvice> advice = adviseStands(*journal.state());
  ASSERT_GE(advice.size(), 2U);
  for (std::size_t i = 0; i < advice.size(); ++i) {
    EXPECT_NEAR(advice[i].down.norm(), 1.0, 1e-9);
    EXPECT_GE(advice[i].gain, 0.0);
    EXPECT_LE(advice[i].share, 1.0);
    // It is down when the object stands so.
    EXPECT_LT((advice[i].T_object_table.linear() * -Vec3::UnitZ() - advice[i].down).norm(), 1e-6);
    if (i > 0 && advice[i - 1].isNew == advice[i].isNew) {
      EXPECT_GE(advice[i - 1].gain, advice[i].gain);
    }
  }
  EXPECT_FALSE(nextStand(*journal.state(), {1}));
  ASSERT_TRUE(nextStand(*journal.state(), {2}));
  EXPECT_EQ(nextStand(*journal.state(), {2})->down, advice.front().down);
  EXPECT_TRUE(adviseStands(AcquisitionState{}).empty());
}

}  // namespace
}  // namespace vantage
