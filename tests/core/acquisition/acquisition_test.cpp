#include "acquisition/acquisition.h"

#include <gtest/gtest.h>

#include "acquisition/memory_journal.h"
#include "acquisition/table_place.h"
#include "base/errors.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

class AcquisitionTest : public ::testing::Test {
 protected:
  explicit AcquisitionTest(int views = 8) : journal_(testing::smallProfile(), settings(views)) {}

  static AcquisitionSettings settings(int views) {
    AcquisitionSettings settings;
    settings.maxViews = views;
    return settings;
  }

  // A copy of what carries out: as a program that comes to the same journal later.
  [[nodiscard]] Acquisition acquisition() {
    const auto scans = static_cast<int>(journal_.scanCount());
    return Acquisition(journal_, testing::smallTools(testing::smallProfile(), settings(8), scans));
  }

  MemoryJournal journal_;
};

TEST_F(AcquisitionTest, EndedByTheOperatorIsNotFinishedAndCanBeOpenedAgain) {
  Acquisition acquisition = this->acquisition();
  acquisition.scanNext();
  ASSERT_FALSE(acquisition.mayDo(Finish{Termination::EndedByOperator}));
  acquisition.carryOut(Finish{Termination::EndedByOperator});
  EXPECT_EQ(journal_.state()->termination, Termination::EndedByOperator);
  EXPECT_EQ(acquisition.mayScan()->reason, RefusalReason::AlreadyEnded);
  EXPECT_EQ(acquisition.runUntilTheEnd(), Termination::EndedByOperator);
  EXPECT_EQ(journal_.scanCount(), 1);
  EXPECT_EQ(acquisition.mayDo(Finish{Termination::EndedByOperator})->reason, RefusalReason::AlreadyEnded);
  acquisition.carryOut(Finish{Termination::Running});
  EXPECT_FALSE(acquisition.mayScan());
  EXPECT_EQ(acquisition.mayDo(Finish{Termination::Running})->reason, RefusalReason::NotEnded);
}

TEST_F(AcquisitionTest, AChosenPositionOpensWhatWasEnded) {
  Acquisition acquisition = this->acquisition();
  acquisition.scanNext();
  acquisition.carryOut(Finish{Termination::EndedByOperator});
  acquisition.carryOut(ChoosePosition{7});
  EXPECT_EQ(nextPosition(*journal_.state()), 7);
  acquisition.scanNext();
  EXPECT_EQ(journal_.state()->scans.back().station().position, 7);
  EXPECT_EQ(journal_.state()->termination, Termination::Running);
}

TEST_F(AcquisitionTest, RaisingTheGreatestNumberOfViewsLetsARunGoOn) {
  Acquisition acquisition = this->acquisition();
  acquisition.carryOut(ChangeSettings{settings(1)});
  EXPECT_EQ(acquisition.runUntilTheEnd(), Termination::MaxViews);
  EXPECT_EQ(acquisition.mayScan()->reason, RefusalReason::LimitReached);
  EXPECT_EQ(acquisition.mayScan()->number, 1);
  EXPECT_EQ(acquisition.mayDo(Finish{Termination::Running})->reason, RefusalReason::LimitReached);
  acquisition.carryOut(ChangeSettings{settings(2)});
  EXPECT_EQ(acquisition.runUntilTheEnd(), Termination::MaxViews);
  EXPECT_EQ(countScans(*journal_.state(), ScanStatus::In), 2U);
}

TEST_F(AcquisitionTest, PausesAfterTheStepThatIsUnderWay) {
  Acquisition acquisition = this->acquisition();
  EXPECT_EQ(acquisition.runUntilTheEnd({}, [&] { return journal_.scanCount() == 2; }), Termination::Running);
  EXPECT_EQ(countScans(*journal_.state(), ScanStatus::In), 2U);
}

TEST_F(AcquisitionTest, RefusesWhatCannotBeDoneAndLeavesEverythingAsItWas) {
  Acquisition acquisition = this->acquisition();
  acquisition.scanNext();
  const std::uint64_t before = stateHash(*journal_.state());
  const std::pair<Command, RefusalReason> cases[] = {
      {ChoosePosition{24}, RefusalReason::NoSuchPosition}, {ChoosePosition{-1}, RefusalReason::NoSuchPosition},
      {LeaveOutView{0}, RefusalReason::OnlyView},          {LeaveOutView{5}, RefusalReason::NotAView},
      {TakeBackView{0}, RefusalReason::NotLeftOut},        {ImportScans{{0}}, RefusalReason::ScansBefore},
      {AddScan{0, {}}, RefusalReason::ScanUsed},           {TakeOver{}, RefusalReason::NotReplayable}};
  for (const auto& [command, reason] : cases) {
    const auto refusal = acquisition.mayDo(command);
    ASSERT_TRUE(refusal) << kindOf(command);
    EXPECT_EQ(refusal->reason, reason) << kindOf(command);
    EXPECT_THROW(acquisition.carryOut(command), InvalidInput) << kindOf(command);
  }
  EXPECT_EQ(stateHash(*journal_.state()), before);
  EXPECT_EQ(journal_.history().size(), 2U);
}

TEST_F(AcquisitionTest, TheObjectAndHowScansBecomeMeshesStayOnceThereAreScans) {
  AcquisitionSettings slack = settings(8);
  slack.triangulation.angleSlack = radians(2.0);
  AcquisitionSettings object = settings(8);
  object.simulation.object = "other.ply";
  AcquisitionSettings placement = settings(8);
  placement.simulation.placement = Placement::Fit;
  Acquisition acquisition = this->acquisition();
  EXPECT_FALSE(acquisition.mayDo(ChangeSettings{slack}));
  EXPECT_FALSE(acquisition.mayDo(ChangeSettings{object}));
  acquisition.scanNext();
  for (const AcquisitionSettings& changed : {slack, object, placement}) {
    EXPECT_EQ(acquisition.mayDo(ChangeSettings{changed})->reason, RefusalReason::MeshesMade);
    EXPECT_THROW(acquisition.carryOut(ChangeSettings{changed}), InvalidInput);
  }
  AcquisitionSettings tolerance = settings(8);
  tolerance.planner.tolerance = 0.3;
  acquisition.carryOut(ChangeSettings{tolerance});
  EXPECT_EQ(journal_.state()->settings.planner.tolerance, 0.3);
}

TEST_F(AcquisitionTest, SettingsThatContradictEachOtherAreRefused) {
  AcquisitionSettings contradicting = settings(8);
  contradicting.registration.coarseGate = 5.0;
  contradicting.registration.finalGate = 10.0;
  Acquisition acquisition = this->acquisition();
  EXPECT_EQ(acquisition.mayDo(ChangeSettings{contradicting})->reason, RefusalReason::Contradiction);
  EXPECT_THROW(acquisition.carryOut(ChangeSettings{contradicting}), InvalidInput);
  EXPECT_EQ(journal_.history().size(), 1);
}

TEST_F(AcquisitionTest, WithoutAScannerEverythingButScansCanBeDone) {
  this->acquisition().scanNext();
  Acquisition acquisition(journal_);
  EXPECT_EQ(acquisition.mayScan()->reason, RefusalReason::NothingToScanWith);
  EXPECT_THROW(acquisition.scanNext(), InvalidInput);
  EXPECT_FALSE(acquisition.mayUndo());
  acquisition.undo();
  EXPECT_EQ(acquisition.mayUndo()->reason, RefusalReason::NothingToUndo);
  EXPECT_THROW(acquisition.undo(), InvalidInput);
  acquisition.redo();
  EXPECT_EQ(acquisition.mayRedo()->reason, RefusalReason::NothingToRedo);
}

TEST_F(AcquisitionTest, KnowsWhereTheTableStandsWhateverBecameOfTheScans) {
  EXPECT_EQ(tablePosition(journal_), 0);
  Acquisition acquisition = this->acquisition();
  acquisition.scanNext();
  acquisition.carryOut(ChoosePosition{9});
  acquisition.scanNext();
  EXPECT_EQ(journal_.state()->scans[1].status, ScanStatus::Rejected);
  EXPECT_EQ(tablePosition(journal_), 9);
  acquisition.undo();
  EXPECT_EQ(tablePosition(journal_), 9);
}

TEST_F(AcquisitionTest, PlansFirstWhereThePlanIsMissing) {
  Acquisition(journal_, {testing::smallTools(testing::smallProfile()).rig, nullptr}).scanNext();
  EXPECT_FALSE(journal_.state()->plan);
  EXPECT_TRUE(std::holds_alternative<PlanFirst>(nextScan(*journal_.state())));
  Acquisition acquisition = this->acquisition();
  acquisition.scanNext();
  EXPECT_TRUE(journal_.state()->plan);
  EXPECT_TRUE(journal_.state()->scans[1].record.predicted);
}

TEST_F(AcquisitionTest, WhoTakesTheNextStepIsPartOfTheState) {
  Acquisition acquisition = this->acquisition();
  acquisition.carryOut(ChangeMode{Mode::Assisted});
  acquisition.scanNext();
  EXPECT_EQ(journal_.state()->mode, Mode::Assisted);
  acquisition.undo();
  acquisition.undo();
  EXPECT_EQ(journal_.state()->mode, Mode::Automatic);
}

TEST_F(AcquisitionTest, ThePlanBelongsToTheStateAndWhatWasPlannedThenStaysInTheRecord) {
  Acquisition acquisition = this->acquisition();
  acquisition.scanNext();
  acquisition.scanNext();
  const auto then = journal_.state()->plan;
  EXPECT_EQ(journal_.state()->scans[1].record.planAfter, then);
  acquisition.carryOut(LeaveOutView{0});
  EXPECT_NE(journal_.state()->plan, then);
  EXPECT_EQ(journal_.state()->scans[1].record.planAfter, then);
}

TEST(ImportedScans, EndAsWhatTheyAre) {
  MemoryJournal journal(nullptr, {});
  const auto profile = testing::smallProfile();
  const Rig rig = testing::simulation(testing::smallObject(), profile, {1, true});
  std::vector<RangeImage> images;
  for (const int position : {0, 2, 4}) {
    images.push_back(scanFrom(rig, position, {}));
    images.back().station.position.reset();
    images.back().poseKnownBy = PoseSource::Reported;
  }
  Acquisition(journal).importScans(std::move(images));
  EXPECT_EQ(journal.state()->termination, Termination::Imported);
  EXPECT_EQ(countScans(*journal.state(), ScanStatus::In), 3U);
  EXPECT_FALSE(nextPosition(*journal.state()));
  EXPECT_EQ(mayScan(*journal.state())->reason, RefusalReason::NoProfile);
  Acquisition(journal).carryOut(LeaveOutView{1});
  EXPECT_EQ(journal.state()->termination, Termination::Imported);
}

}  // namespace
}  // namespace vantage
