#include "acquisition/apply_command.h"
#include "acquisition/stand_composites.h"

#include <gtest/gtest.h>

#include <stop_token>

#include "acquisition/acquisition_state.h"
#include "acquisition/command_tools.h"
#include "acquisition/course_commands.h"
#include "acquisition/scan_commands.h"
#include "core/io/expect_error.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

using testing::expectError;

// Scans of the small object that a command can ask for, and what it is carried out with.
class ApplyCommand : public ::testing::Test {
 protected:
  ApplyCommand() {
    const Rig rig = testing::simulation(testing::smallObject(), state_.profile, {1, true});
    for (const int position : {0, 2, 4})
      scans_.push_back(std::make_shared<const RangeImage>(scanFrom(rig, position, Progress())));
    input_ = {[this](std::int64_t number) { return scans_.at(static_cast<std::size_t>(number)); }, &images_, {}};
  }

  [[nodiscard]] AcquisitionState after(const AcquisitionState& state, const Command& command) const {
    return applyCommand(state, command, input_, {});
  }

  static AcquisitionState untouched() {
    AcquisitionState state;
    state.profile = testing::smallProfile();
    return state;
  }

  AcquisitionState state_ = untouched();
  std::vector<std::shared_ptr<const RangeImage>> scans_;
  ScannerImages images_ = computeScannerImages(*state_.profile);
  CommandInput input_;
};

TEST_F(ApplyCommand, AddsAScanWithModelPlanAndRecordAndLeavesTheStateBeforeAsItWas) {
  const std::uint64_t before = stateHash(state_);
  const AcquisitionState one = after(state_, AddScan{0, {}});
  EXPECT_EQ(stateHash(state_), before);
  ASSERT_EQ(countScans(one, ScanStatus::In), 1U);
  EXPECT_GT(one.model->mesh.triangles.size(), 100U);
  ASSERT_TRUE(one.plan);
  EXPECT_EQ(one.scans[0].record.planAfter, one.plan);
  EXPECT_EQ(one.scans[0].view.T_object_scanner.matrix(), scans_[0]->T_table_scanner.matrix());
  EXPECT_EQ(stateHash(after(state_, AddScan{0, {}})), stateHash(one));
}

TEST_F(ApplyCommand, WithoutImagesOrForABaselineNothingIsPlanned) {
  EXPECT_FALSE(applyCommand(state_, AddScan{0, {}}, {input_.scan, nullptr, {}}, {}).plan);
  state_.settings.strategy = parseStrategy("uniform:4");
  EXPECT_FALSE(after(state_, AddScan{0, {}}).plan);
}

TEST_F(ApplyCommand, AViewThatIsLeftOutAndTakenBackLeavesTheSameModel) {
  const AcquisitionState two = after(after(state_, AddScan{0, {}}), AddScan{1, {}});
  ASSERT_EQ(countScans(two, ScanStatus::In), 2U);
  const AcquisitionState without = after(two, LeaveOutView{0});
  EXPECT_EQ(without.scans[0].status, ScanStatus::LeftOut);
  EXPECT_LT(without.model->mesh.triangles.size(), two.model->mesh.triangles.size());
  EXPECT_NE(without.plan, two.plan);
  const AcquisitionState again = after(without, TakeBackView{0});
  EXPECT_EQ(again.scans[0].status, ScanStatus::In);
  EXPECT_EQ(stateHash(after(again, LeaveOutView{0})), stateHash(without));
}

TEST_F(ApplyCommand, AChosenPositionHoldsUntilTheNextScan) {
  AcquisitionState state = after(after(state_, AddScan{0, {}}), Finish{Termination::EndedByOperator});
  EXPECT_EQ(state.termination, Termination::EndedByOperator);
  state = after(state, ChoosePosition{2});
  EXPECT_EQ(state.termination, Termination::Running);
  EXPECT_EQ(state.chosenPosition, 2);
  EXPECT_FALSE(after(state, AddScan{1, {}}).chosenPosition);
  EXPECT_FALSE(after(state, ChoosePosition{}).chosenPosition);
}

TEST_F(ApplyCommand, ATurnedObjectStandsAnewAndIsPlannedForAnew) {
  const AcquisitionState one = after(after(state_, AddScan{0, {}}), ChoosePosition{5});
  const AcquisitionState unknown = after(one, TurnObject{});
  EXPECT_EQ(unknown.stand(), 1);
  EXPECT_FALSE(unknown.chosenPosition);
  EXPECT_FALSE(unknown.plan);
  EXPECT_FALSE(unknown.model);
  EXPECT_EQ(withObject(unknown).model, one.model);
  EXPECT_TRUE(after(unknown, PlaceStand{1, Pose::Identity()}).plan);
}

TEST_F(ApplyCommand, AScanOfAPositionThatThereIsNotIsRefused) {
  auto elsewhere = std::make_shared<RangeImage>(*scans_[0]);
  elsewhere->station.position = 24;
  scans_.push_back(elsewhere);
  expectError<InvalidInput>([&] { static_cast<void>(after(state_, AddScan{3, {}})); }, {"position 24", "0 to 23"});
}

TEST_F(ApplyCommand, ToolsPlanOnlyForAStandThatIsKnownAndEndWhatIsAtItsLimit) {
  AcquisitionState one = after(state_, AddScan{0, {}});
  const Progress progress;
  const CommandTools tools(input_, progress);
  EXPECT_TRUE(tools.planned(one, progress).plan);
  one.settings.maxViews = 1;
  EXPECT_EQ(tools.replanned(one).termination, Termination::MaxViews);
  EXPECT_EQ(CommandTools::judged(one).plan, one.plan);
  one.stands.emplace_back();
  EXPECT_FALSE(tools.planned(one, progress).plan);  // the model is not that of the stand of now
}

TEST_F(ApplyCommand, ThatIsCancelledThrows) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(static_cast<void>(applyCommand(state_, AddScan{0, {}}, input_, Progress({}, stop.get_token(), 1))),
               Cancelled);
}

}  // namespace
}  // namespace vantage
