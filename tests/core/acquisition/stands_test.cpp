#include <gtest/gtest.h>

#include "acquisition/acquisition.h"
#include "acquisition/memory_journal.h"
#include "acquisition/scan_placing.h"
#include "acquisition/stand_composites.h"
#include "acquisition/steps.h"
#include "base/errors.h"
#include "session/session.h"
#include "session/session_blobs.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

// The small object lying on its side: turned by 90 degrees about x, back on the table and about its axis.
Pose turnedOver() {
  Pose T_object_table = Pose::Identity();
  T_object_table.translate(Vec3(0.0, 75.0, 50.0));
  T_object_table.rotate(Eigen::AngleAxisd(radians(90.0), Vec3::UnitX()));
  return T_object_table;
}

// A rig before the small object as it lies then.
Rig rigBefore(const std::shared_ptr<const ScannerProfile>& profile, const Pose& T_object_table) {
  return testing::simulation(transformed(testing::smallObject(), T_object_table.inverse()), profile, {1, true});
}

AcquisitionTools toolsOf(const std::shared_ptr<const ScannerProfile>& profile, const Pose& T_object_table) {
  return {rigBefore(profile, T_object_table), std::make_shared<const ScannerImages>(computeScannerImages(*profile))};
}

AcquisitionSettings fewViews(int views) {
  AcquisitionSettings settings;
  settings.maxViews = views;
  return settings;
}

// Two views of the object upright, then two of it lying, in a journal.
void acquireTwoStands(Journal& journal, const std::shared_ptr<const ScannerProfile>& profile) {
  Acquisition upright(journal, toolsOf(profile, Pose::Identity()));
  upright.scanNext();
  upright.scanNext();
  upright.carryOut(TurnObject{turnedOver()});
  Acquisition lying(journal, toolsOf(profile, turnedOver()));
  lying.scanNext();
  lying.scanNext();
}

TEST(Stands, ViewsOfTwoStandsMakeOneModel) {
  const auto profile = testing::smallProfile();
  MemoryJournal journal(profile, fewViews(8));
  acquireTwoStands(journal, profile);
  const AcquisitionState& state = *journal.state();
  ASSERT_EQ(state.scans.size(), 4U);
  EXPECT_EQ(countScans(state, ScanStatus::In), 4U);
  EXPECT_EQ(state.scans[1].station().stand, 0);
  EXPECT_EQ(state.scans[2].station().stand, 1);
  // Every view is found where it was taken: the scanner moved without errors.
  for (const KeptScan& scan : state.scans) {
    const Pose truth = (scan.station().stand == 0 ? Pose::Identity() : turnedOver()) * scan.view.image->T_table_scanner;
    EXPECT_LT((scan.view.T_object_scanner.translation() - truth.translation()).norm(), 1.0) << scan.number;
  }
}

TEST(Stands, APlanIgnoresThePositionsThatWereTakenInAnotherStand) {
  const auto profile = testing::smallProfile();
  MemoryJournal journal(profile, fewViews(8));
  Acquisition upright(journal, toolsOf(profile, Pose::Identity()));
  upright.scanNext();
  const int first = *journal.state()->scans.back().station().position;
  EXPECT_EQ(journal.state()->plan->scores[static_cast<std::size_t>(first)].voidArea, 0.0);
  upright.carryOut(TurnObject{turnedOver()});
  ASSERT_TRUE(journal.state()->plan);
  EXPECT_GT(journal.state()->plan->scores[static_cast<std::size_t>(first)].voidArea, 0.0);
}

TEST(Stands, FailuresOfOneStandDoNotEndAnother) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  const auto failAt = [&](int stand) {
    auto image = std::make_shared<RangeImage>();
    image->station = {stand, 3};
    KeptScan scan;
    scan.number = static_cast<std::int64_t>(state.scans.size());
    scan.status = ScanStatus::Rejected;
    scan.view.image = image;
    state.scans.push_back(scan);
  };
  state.model = std::make_shared<const Model>();
  for (int i = 0; i < 4; ++i) failAt(0);
  EXPECT_EQ(terminationOf(nextScan(state)), Termination::RegistrationFailed);
  state.stands.push_back({turnedOver()});
  EXPECT_TRUE(std::holds_alternative<PlanFirst>(nextScan(state)));
  for (int i = 0; i < 4; ++i) failAt(1);
  EXPECT_EQ(terminationOf(nextScan(state)), Termination::RegistrationFailed);
}

TEST(Stands, MovesOfTheTableTieOnlyViewsOfOneStand) {
  const auto profile = testing::smallProfile();
  MemoryJournal journal(profile, fewViews(8));
  Acquisition(journal, toolsOf(profile, Pose::Identity())).scanNext();
  AcquisitionState state = *journal.state();
  state.stands.push_back({turnedOver()});
  RangeImage image = *state.scans[0].view.image;
  image.station = {1, 0};
  // The first of its stand stands where the object was said to stand, whatever the views before were found at.
  state.scans[0].view.T_object_scanner.translation().x() += 5.0;
  EXPECT_TRUE(expectedPose(state, image).isApprox(turnedOver() * image.T_table_scanner));
  image.station.stand = 0;
  EXPECT_NEAR(expectedPose(state, image).translation().x() - image.T_table_scanner.translation().x(), 5.0, 1e-9);
}

TEST(Stands, AStandThatNobodyKnowsIsACompositeOfItsOwnUntilItIsPlaced) {
  const auto profile = testing::smallProfile();
  MemoryJournal journal(profile, fewViews(8));
  Acquisition upright(journal, toolsOf(profile, Pose::Identity()));
  upright.scanNext();
  upright.carryOut(TurnObject{});
  const auto object = journal.state()->aside;
  ASSERT_EQ(object.size(), 1U);
  EXPECT_EQ(object[0].composite, 0);
  EXPECT_FALSE(journal.state()->model);
  EXPECT_FALSE(journal.state()->plan);
  Acquisition lying(journal, toolsOf(profile, turnedOver()));
  lying.scanNext();
  lying.scanNext();
  // As the first stand: its table is the frame, its plan speaks of it alone.
  const AcquisitionState composite = *journal.state();
  EXPECT_EQ(countScans(composite, ScanStatus::Aside), 1U);
  ASSERT_EQ(countScans(composite, ScanStatus::In), 2U);
  EXPECT_TRUE(composite.plan);
  EXPECT_EQ(composite.aside[0].model, object[0].model);
  const View& first = composite.scans[1].view;
  EXPECT_EQ(first.T_object_scanner.matrix(), first.image->T_table_scanner.matrix());
  EXPECT_EQ(standsToAlign(composite), std::vector<int>{1});
  EXPECT_EQ(withObject(composite).model, object[0].model);
  lying.carryOut(PlaceStand{1, turnedOver()});
  EXPECT_EQ(countScans(*journal.state(), ScanStatus::In), 3U);
  EXPECT_TRUE(journal.state()->aside.empty());
  EXPECT_TRUE(journal.state()->plan);
  const View& placed = journal.state()->scans[1].view;
  EXPECT_LT((placed.T_object_scanner.inverse() * turnedOver() * placed.image->T_table_scanner).translation().norm(),
            1.0);
  EXPECT_FALSE(lying.mayScan());
  EXPECT_EQ(lying.mayDo(PlaceStand{1, turnedOver()})->reason, RefusalReason::StandKnown);
  EXPECT_EQ(lying.mayDo(PlaceStand{2, turnedOver()})->reason, RefusalReason::NoSuchStand);
}

TEST(Stands, AreKeptUndoneAndReplayedToTheSameBytes) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("stands.vantage");
  std::uint64_t hash = 0;
  {
    Session session = testing::createSmallSession(path, fewViews(8));
    acquireTwoStands(session, session.profile());
    hash = stateHash(*session.state());
    Acquisition acquisition(session);
    for (int i = 0; i < 3; ++i) acquisition.undo();
    EXPECT_EQ(session.state()->stands.size(), 1U);
    EXPECT_EQ(countScans(*session.state(), ScanStatus::In), 2U);
    for (int i = 0; i < 3; ++i) acquisition.redo();
    EXPECT_EQ(stateHash(*session.state()), hash);
  }
  const Session read = Session::open(path, SessionAccess::Read);
  EXPECT_TRUE(read.losses().empty());
  EXPECT_EQ(stateHash(*read.state()), hash);
  const ScannerImages images = computeScannerImages(*read.profile());
  const CommandInput input{[&](std::int64_t number) { return read.scan(number); }, &images};
  AcquisitionState state;
  state.profile = read.profile();
  for (std::size_t i = 0; i < read.history().size(); ++i) {
    state = applyCommand(state, read.history().entry(i).command, input, {});
    EXPECT_EQ(stateHash(state), read.history().entry(i).hash) << i;
  }
  EXPECT_EQ(modelBlob(*state.model), modelBlob(*read.state()->model));
}

}  // namespace
}  // namespace vantage
