#include "acquisition/other_turn.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "acquisition/agreement_check.h"
#include "acquisition/hand_placing.h"
#include "acquisition/memory_journal.h"
#include "acquisition/scan_placing.h"
#include "core/io/expect_error.h"
#include "scanner/table_turn.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;

// A scan of the small object that a person took when asked for a position, with the table turned so many degrees
// farther.
RangeImage scanByHand(const std::shared_ptr<const ScannerProfile>& profile, int position, double tableOff) {
  ScannerProfile there = *profile;
  const Pose nominal = profile->workspace.poses[static_cast<std::size_t>(position)];
  there.workspace.poses = {Eigen::AngleAxisd(radians(-tableOff), Vec3::UnitZ()) * nominal};
  const Rig rig = testing::simulation(testing::smallObject(), std::make_shared<const ScannerProfile>(there), {1, true});
  RangeImage image = scanFrom(rig, 0, {});
  image.rays = profile->rays;
  image.T_table_scanner = nominal;
  image.station.position = position;
  image.poseKnownBy = PoseSource::ByHand;
  image.poseUncertainty = Mechanics{radians(7.5), 3.0};
  return image;
}

AcquisitionSettings smallScans() {
  AcquisitionSettings settings;
  settings.registration.limits.fewPairs = 100;
  return settings;
}

double angleOf(const AcquisitionState& state, int position) {
  return degrees(turnBetween(state.profile->workspace, 0, position).angle);
}

// How far a view was found from where it was taken, when the table had turned so much farther [deg].
double errorOf(const KeptScan& scan, double tableOff) {
  const Pose truth = Eigen::AngleAxisd(radians(-tableOff), Vec3::UnitZ()) * scan.view.image->T_table_scanner;
  const Eigen::Matrix3d off = scan.view.T_object_scanner.linear() * truth.linear().transpose();
  return degrees(Eigen::AngleAxisd(off).angle());
}

constexpr double kSlip = 55.0;  // farther than a scan is looked for by itself [deg]

class OtherTurnTest : public ::testing::Test {
 protected:
  void SetUp() override {
    acquisition_.carryOut(ChangeSettings{smallScans()});
    for (const int position : {0, 1, 2, 3}) acquisition_.addScan(scanByHand(profile_, position, 0.0));
    ASSERT_EQ(countScans(*journal_.state(), ScanStatus::In), 4U);
    // Asked for position 4 the person turned the table back.
    acquisition_.addScan(scanByHand(profile_, 4, kSlip));
    ASSERT_EQ(turnsThatFit(*journal_.state(), slipped()).size(), 1U);
  }
  [[nodiscard]] const KeptScan& slipped() const { return journal_.state()->scans[4]; }

  std::shared_ptr<const ScannerProfile> profile_ = testing::smallProfile();
  MemoryJournal journal_{profile_, {}};
  Acquisition acquisition_{journal_};
};

TEST_F(OtherTurnTest, AScanThatFitsElsewhereIsRefusedAndSaidWhere) {
  const AcquisitionState& state = *journal_.state();
  ASSERT_EQ(slipped().status, ScanStatus::Rejected);
  const std::vector<double> turns = turnsThatFit(state, slipped());
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_NEAR(turns[0], inOneTurn(angleOf(state, 4) + kSlip), 0.5);
  EXPECT_EQ(slipped().record.registration.finding.reason, VerdictReason::OtherTurn);
  EXPECT_TRUE(fitsTurn(state, slipped(), turns[0]));
  EXPECT_FALSE(fitsTurn(state, slipped(), turns[0] + 20.0));
}

TEST_F(OtherTurnTest, IsTakenAsFromThereWhenThePersonSaysSo) {
  const double turn = turnsThatFit(*journal_.state(), slipped()).front();
  acquisition_.carryOut(TakeAsFrom{4, turn});
  ASSERT_EQ(slipped().status, ScanStatus::In);
  EXPECT_EQ(slipped().record.registration.verdict, Verdict::Good);
  EXPECT_EQ(slipped().record.registration.finding, (Finding{VerdictReason::TakenElsewhere, turn, {}}));
  EXPECT_LT(errorOf(slipped(), kSlip), 0.3);
  EXPECT_EQ(positionTaken(*journal_.state(), slipped()), 0);
  EXPECT_TRUE(turnsThatFit(*journal_.state(), slipped()).empty());
  // Whoever turned it that far once turns on as asked.
  const RangeImage next = scanByHand(profile_, 5, 0.0);
  EXPECT_LT((expectedPose(*journal_.state(), next).translation() - next.T_table_scanner.translation()).norm(), 0.5);
  acquisition_.addScan(next);
  EXPECT_EQ(journal_.state()->scans[5].status, ScanStatus::In);
  acquisition_.undo();
  acquisition_.undo();
  EXPECT_EQ(slipped().status, ScanStatus::Rejected);
}

TEST_F(OtherTurnTest, NothingThatOthersLookedThroughAgreesWithThem) {
  const AcquisitionState& state = *journal_.state();
  KeptScan right = state.scans[2];
  checkAgainstOthers(state, right, stepOptionsFor(state), {});
  EXPECT_EQ(right.record.registration.verdict, state.scans[2].record.registration.verdict);
  KeptScan wrong = state.scans[2];
  wrong.record.registration.T_object_scanner =
      Eigen::AngleAxisd(radians(60.0), Vec3::UnitZ()) * wrong.record.registration.T_object_scanner;
  checkAgainstOthers(state, wrong, stepOptionsFor(state), {});
  EXPECT_EQ(wrong.record.registration.finding.reason, VerdictReason::ContradictsOthers);
}

TEST(InOneTurn, IsFromZeroToBelowAFullTurn) {
  EXPECT_DOUBLE_EQ(inOneTurn(-4.9), 355.1);
  EXPECT_DOUBLE_EQ(inOneTurn(28.0), 28.0);
  EXPECT_DOUBLE_EQ(inOneTurn(725.0), 5.0);
  EXPECT_DOUBLE_EQ(inOneTurn(-720.0), 0.0);
  // It would be shown as 360.0.
  EXPECT_DOUBLE_EQ(inOneTurn(-0.04), 0.0);
  EXPECT_DOUBLE_EQ(inOneTurn(359.9), 359.9);
}

// The scans of the acquisition as recorded ones, of which the last is said to be of another position.
TEST_F(OtherTurnTest, AnImportTellsHowFarItIsWhileItLooksWhereScansFit) {
  std::vector<RangeImage> images;
  for (std::int64_t i = 0; i < 5; ++i) {
    images.push_back(*journal_.scan(i));
    images.back().poseKnownBy = PoseSource::Reported;
    images.back().poseUncertainty.reset();
  }
  MemoryJournal journal(profile_, smallScans());
  std::vector<double> fractions;
  Acquisition(journal).importScans(
      std::move(images), Progress([&](double fraction, std::string_view) { fractions.push_back(fraction); }, {}, 1));
  const AcquisitionState& state = *journal.state();
  ASSERT_EQ(state.scans[4].status, ScanStatus::Rejected);
  EXPECT_EQ(turnsThatFit(state, state.scans[4]).size(), 1U);
  EXPECT_GT(std::count_if(fractions.begin(), fractions.end(), [](double f) { return f > 0.91 && f < 0.99; }), 3);
}

TEST_F(OtherTurnTest, IsTakenFromNowhereElse) {
  const auto refused = [&](std::int64_t scan, double turn) {
    const auto refusal = acquisition_.mayDo(TakeAsFrom{scan, turn});
    return refusal && refusal->reason == RefusalReason::FitsNoOtherTurn;
  };
  const double turn = turnsThatFit(*journal_.state(), slipped()).front();
  EXPECT_TRUE(refused(4, turn + 10.0));
  EXPECT_TRUE(refused(3, turn));
  EXPECT_TRUE(refused(17, turn));
  EXPECT_FALSE(refused(4, turn));
  expectError<InvalidInput>([&] { acquisition_.carryOut(TakeAsFrom{4, turn + 10.0}); }, {"scan 4"});
}

// Whether it is found or refused: it is never good where it is wrong.
TEST(HandSlip, OfFortyDegreesIsFoundOrSaid) {
  for (const double slip : {40.0, -40.0}) {
    const auto profile = testing::smallProfile();
    MemoryJournal journal(profile, {});
    Acquisition acquisition(journal);
    acquisition.carryOut(ChangeSettings{smallScans()});
    for (const int position : {0, 1, 2, 3}) acquisition.addScan(scanByHand(profile, position, 0.0));
    acquisition.addScan(scanByHand(profile, 4, slip));
    const KeptScan& scan = journal.state()->scans[4];
    if (scan.record.registration.verdict == Verdict::Good) {
      EXPECT_LT(errorOf(scan, slip), 0.3) << slip;
    }
    for (const double turn : turnsThatFit(*journal.state(), scan))
      EXPECT_NEAR(turn, inOneTurn(angleOf(*journal.state(), 4) + slip), 0.5);
  }
}

TEST(HandSession, GoesOnAsItWouldHaveWhenItIsResumed) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("hand.vantage");
  const auto profile = testing::smallProfile();
  MemoryJournal whole(profile, {});
  const auto turn = [&](Journal& journal, int position, double off) {
    Acquisition(journal).addScan(scanByHand(profile, position, off));
  };
  Acquisition(whole).carryOut(ChangeSettings{smallScans()});
  for (const auto& [position, off] : {std::pair{0, 0.0}, {1, 11.0}, {2, -9.0}, {3, 40.0}, {3, -12.0}})
    turn(whole, position, off);
  {
    Session session = Session::create(path, {testing::smallProfileSource(), smallScans(), nullptr});
    for (const auto& [position, off] : {std::pair{0, 0.0}, {1, 11.0}, {2, -9.0}, {3, 40.0}})
      turn(session, position, off);
  }
  Session session = Session::open(path, SessionAccess::Write);
  EXPECT_EQ(turnsThatFit(*session.state(), session.state()->scans[3]),
            turnsThatFit(*whole.state(), whole.state()->scans[3]));
  turn(session, 3, -12.0);
  const AcquisitionState& resumed = *session.state();
  ASSERT_EQ(resumed.scans.size(), whole.state()->scans.size());
  for (std::size_t i = 0; i < resumed.scans.size(); ++i) {
    const KeptScan& scan = resumed.scans[i];
    const KeptScan& other = whole.state()->scans[i];
    EXPECT_EQ(scan.status, other.status) << i;
    EXPECT_EQ(scan.record.registration.finding, other.record.registration.finding) << i;
    EXPECT_EQ(isLoose(scan), isLoose(other)) << i;
    EXPECT_TRUE(scan.view.T_object_scanner.isApprox(other.view.T_object_scanner, 1e-9)) << i;
  }
  EXPECT_LT(errorOf(resumed.scans[4], -12.0), 0.3);
}

}  // namespace
}  // namespace vantage
