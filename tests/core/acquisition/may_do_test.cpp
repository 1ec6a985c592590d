#include "acquisition/may_do.h"

#include <gtest/gtest.h>

#include <set>

#include "acquisition/apply_command.h"
#include "acquisition/next_scan.h"
#include "acquisition/refusal.h"
#include "acquisition/refusal_error.h"
#include "core/io/expect_error.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

using testing::expectError;

// A state with scans that nothing was made of but what decides how it goes on.
AcquisitionState stateWith(const std::vector<std::pair<ScanStatus, int>>& scans) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  for (const auto& [status, position] : scans) {
    RangeImage image;
    image.station.position = position;
    KeptScan scan;
    scan.number = static_cast<std::int64_t>(state.scans.size());
    scan.status = status;
    scan.view.image = std::make_shared<const RangeImage>(std::move(image));
    state.scans.push_back(std::move(scan));
  }
  if (!scans.empty()) state.model = std::make_shared<const Model>();
  return state;
}

TEST(MayDo, AppliesWhatItAllowsAndRefusesWhatItForbids) {
  AcquisitionState state = stateWith({{ScanStatus::In, 0}, {ScanStatus::LeftOut, 1}});
  const std::vector<Command> commands{ChoosePosition{23},
                                      ChoosePosition{24},
                                      ChoosePosition{},
                                      LeaveOutView{0},
                                      LeaveOutView{1},
                                      TakeBackView{0},
                                      Finish{Termination::EndedByOperator},
                                      Finish{Termination::Running},
                                      TakeOver{},
                                      TurnObject{},
                                      ImportScans{{0}},
                                      PlaceStand{0, Pose::Identity()},
                                      AlignStand{0},
                                      ChooseStandPose{0, 0},
                                      TakeReference{0},
                                      ChangeMode{Mode::Assisted}};
  int allowed = 0;
  for (const Command& command : commands) {
    if (mayDo(state, command)) {
      EXPECT_THROW(static_cast<void>(applyCommand(state, command, {}, {})), InvalidInput) << kindOf(command);
    } else {
      EXPECT_NO_THROW(static_cast<void>(applyCommand(state, command, {}, {}))) << kindOf(command);
      ++allowed;
    }
  }
  EXPECT_EQ(allowed, 5);
}

TEST(MayDo, WithoutAProfileThereIsNoPosition) {
  const AcquisitionState state;
  EXPECT_EQ(mayDo(state, ChoosePosition{0})->reason, RefusalReason::NoProfile);
  EXPECT_EQ(mayDo(state, AddScan{0, {}})->reason, RefusalReason::NoProfile);
  EXPECT_EQ(mayScan(state)->reason, RefusalReason::NoProfile);
  EXPECT_FALSE(mayDo(state, ImportScans{{0}}));
}

TEST(MayDo, EveryReasonHasACodeAndASentenceOfItsOwn) {
  std::set<std::string> codes;
  std::set<std::string> sentences;
  for (int i = 0; i <= static_cast<int>(kLastRefusalReason); ++i) {
    const auto reason = static_cast<RefusalReason>(i);
    codes.insert(std::string(name(reason)));
    try {
      throwRefusal({reason, 17});
    } catch (const InvalidInput& e) {
      sentences.insert(e.what());
    }
  }
  EXPECT_EQ(codes.size(), static_cast<std::size_t>(kLastRefusalReason) + 1);
  EXPECT_EQ(sentences.size(), codes.size());
  expectError<InvalidInput>([] { throwRefusal({RefusalReason::NoSuchPosition, 17}); }, {"position 17"});
}

TEST(NextScan, BeginsWithTheFirstViewAndFollowsTheOperator) {
  AcquisitionState state = stateWith({});
  state.settings.firstView = 4;
  EXPECT_EQ(nextPosition(state), 4);
  state.chosenPosition = 9;
  EXPECT_EQ(nextPosition(state), 9);
  state.termination = Termination::EndedByOperator;
  EXPECT_EQ(nextPosition(state), 9);
  state.chosenPosition.reset();
  EXPECT_EQ(terminationOf(nextScan(state)), Termination::EndedByOperator);
}

TEST(NextScan, ABaselineTakesItsPositionsInOrder) {
  AcquisitionState state = stateWith({{ScanStatus::In, 0}});
  state.settings.strategy = parseStrategy("uniform:4");
  EXPECT_EQ(nextPosition(state), 6);
  state = stateWith({{ScanStatus::In, 0}, {ScanStatus::In, 6}, {ScanStatus::In, 12}, {ScanStatus::In, 18}});
  state.settings.strategy = parseStrategy("uniform:4");
  EXPECT_EQ(terminationOf(nextScan(state)), Termination::Finished);
  state.settings.strategy = parseStrategy("random");
  state.settings.maxViews = 4;
  EXPECT_EQ(terminationOf(nextScan(state)), Termination::MaxViews);
}

// Scans by hand that overlap too little.
AcquisitionState turnedTooFar(const std::vector<std::pair<ScanStatus, int>>& scans) {
  AcquisitionState state = stateWith(scans);
  state.settings.strategy = parseStrategy("uniform:6");
  for (KeptScan& scan : state.scans) {
    RangeImage image = *scan.view.image;
    image.poseKnownBy = PoseSource::ByHand;
    image.poseUncertainty = Mechanics{radians(7.5), 3.0};
    scan.view.image = std::make_shared<const RangeImage>(std::move(image));
    scan.record.registration.finding.reason = VerdictReason::FewPairs;
  }
  return state;
}

TEST(NextScan, APersonWhoTurnedTooFarIsAskedForHalfTheTurn) {
  const auto in = ScanStatus::In;
  const auto out = ScanStatus::Rejected;
  EXPECT_EQ(nextPosition(turnedTooFar({{in, 0}, {out, 4}})), 2);
  EXPECT_EQ(nextPosition(turnedTooFar({{in, 0}, {out, 4}, {out, 2}})), 1);
  EXPECT_EQ(nextPosition(turnedTooFar({{in, 0}, {out, 20}})), 22);
  // What was in between is none of the six.
  EXPECT_EQ(nextPosition(turnedTooFar({{in, 0}, {in, 4}, {in, 2}})), 8);
  AcquisitionState contradicts = turnedTooFar({{in, 0}, {out, 4}});
  contradicts.scans[1].record.registration.finding.reason = VerdictReason::Conflicts;
  EXPECT_EQ(nextPosition(contradicts), 8);
}

// Scans with a plan by which no position overlaps more than another.
AcquisitionState planned(AcquisitionState state, VerdictReason reason) {
  state.settings.strategy = {};
  Plan plan;
  plan.outcome = PlanOutcome::Found;
  for (int i = 0; i < static_cast<int>(state.profile->workspace.size()); ++i) {
    PositionScore score;
    score.position = i;
    score.overlapArea = 100.0;
    score.constraint = Constraint::Outscored;
    plan.scores.push_back(score);
  }
  state.plan = std::make_shared<const Plan>(std::move(plan));
  for (KeptScan& scan : state.scans) scan.record.registration.finding.reason = reason;
  return state;
}

TEST(NextScan, APersonWhoTurnedWrongIsAskedOnceMoreThenForHalfTheTurn) {
  const auto in = ScanStatus::In;
  const auto out = ScanStatus::Rejected;
  const auto reason = VerdictReason::OtherTurn;
  const auto byHand = [&](const std::vector<std::pair<ScanStatus, int>>& scans, VerdictReason why) {
    return planned(turnedTooFar(scans), why);
  };
  EXPECT_EQ(nextPosition(byHand({{in, 0}, {out, 4}}, reason)), 4);
  EXPECT_EQ(nextPosition(byHand({{in, 0}, {out, 4}, {out, 4}}, reason)), 2);
  EXPECT_EQ(nextPosition(byHand({{in, 0}, {out, 4}, {out, 4}, {out, 2}}, reason)), 2);
  EXPECT_EQ(terminationOf(nextScan(byHand({{in, 0}, {out, 4}, {out, 4}, {out, 2}, {out, 2}}, reason))),
            Termination::RegistrationFailed);
  // Where no position lies between, the same again.
  EXPECT_EQ(nextPosition(byHand({{in, 0}, {out, 1}, {out, 1}}, reason)), 1);
  // Too little overlap gets no better by turning there again.
  EXPECT_EQ(nextPosition(byHand({{in, 0}, {out, 4}}, VerdictReason::FewPairs)), 2);
}

TEST(NextScan, ATableThatTurnedTooFarTurnsHalfAsFar) {
  const auto in = ScanStatus::In;
  const auto out = ScanStatus::Rejected;
  const auto byTable = [](const std::vector<std::pair<ScanStatus, int>>& scans, VerdictReason why) {
    return planned(stateWith(scans), why);
  };
  EXPECT_EQ(nextPosition(byTable({{in, 0}, {out, 8}}, VerdictReason::FewPairs)), 4);
  EXPECT_EQ(nextPosition(byTable({{in, 0}, {out, 8}, {out, 4}}, VerdictReason::FewPairs)), 2);
  // A table that moves by itself would do the same again.
  EXPECT_EQ(terminationOf(nextScan(byTable({{in, 0}, {out, 8}}, VerdictReason::OtherTurn))),
            Termination::RegistrationFailed);
  // Where clearly more is to overlap, it is not the turn.
  AcquisitionState better = byTable({{in, 0}, {out, 8}}, VerdictReason::FewPairs);
  Plan plan = *better.plan;
  plan.scores[21].overlapArea = 900.0;
  better.plan = std::make_shared<const Plan>(plan);
  EXPECT_EQ(nextPosition(better), 21);
}

TEST(NextScan, FourFailuresInARowEndIt) {
  std::vector<std::pair<ScanStatus, int>> scans{{ScanStatus::In, 0}};
  for (int i = 1; i <= 4; ++i) {
    AcquisitionState state = stateWith(scans);
    EXPECT_EQ(terminationOf(nextScan(state)), Termination::Running) << i;
    scans.emplace_back(ScanStatus::Rejected, i);
  }
  EXPECT_EQ(terminationOf(nextScan(stateWith(scans))), Termination::RegistrationFailed);
  scans.emplace_back(ScanStatus::In, 5);
  EXPECT_EQ(terminationOf(nextScan(stateWith(scans))), Termination::Running);
}

TEST(NextScan, WithoutAPlanOneIsMadeFirst) {
  EXPECT_TRUE(std::holds_alternative<PlanFirst>(nextScan(stateWith({{ScanStatus::In, 0}}))));
}

}  // namespace
}  // namespace vantage
