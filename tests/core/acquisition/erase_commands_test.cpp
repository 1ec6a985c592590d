#include "acquisition/erase_commands.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "acquisition/acquisition.h"
#include "acquisition/erased_regions.h"
#include "acquisition/memory_journal.h"
#include "core/io/expect_error.h"
#include "geometry/geometry_hash.h"
#include "geometry/measures.h"
#include "report/completeness.h"
#include "report/edges_left.h"
#include "report/report.h"
#include "session/session.h"
#include "session/state_hash.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;

// A block of putty at the side of the small object, and what of the scene is putty.
const Vec3 kPuttyLow(24, -28, 4);
const Vec3 kPuttyHigh(52, 4, 44);

Mesh objectWithPutty() {
  return testing::joined(testing::smallObject(), testing::makeBox(kPuttyLow, kPuttyHigh, 6));
}

OrientedBox aroundPutty() {
  OrientedBox box;
  box.T_region_box.translation() = 0.5 * (kPuttyLow + kPuttyHigh);
  box.size = kPuttyHigh - kPuttyLow + Vec3::Constant(4.0);
  return box;
}

EraseRegion erasePutty() {
  return {0, aroundPutty(), false};
}

// The small object with putty at it, scanned a few times.
class EraseCommands : public ::testing::Test {
 protected:
  static AcquisitionTools tools(int scansBefore = 0) {
    static const auto profile = testing::smallProfile();
    static const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*profile));
    return {testing::simulation(objectWithPutty(), profile, {1, true}, scansBefore), images};
  }

  EraseCommands() : journal_(testing::smallProfile(), settings()), acquisition_(journal_, tools()) {
    for (int i = 0; i < 3; ++i) acquisition_.scanNext();
  }

  static AcquisitionSettings settings() {
    AcquisitionSettings settings;
    settings.maxViews = 14;
    return settings;
  }

  [[nodiscard]] std::size_t verticesInPutty() const {
    const RegionProbe putty{Region(aroundPutty())};
    const std::vector<Vec3>& vertices = acquisition_.state()->model->mesh.vertices;
    return static_cast<std::size_t>(
        std::count_if(vertices.begin(), vertices.end(), [&](const Vec3& v) { return putty.holds(v); }));
  }

  MemoryJournal journal_;
  Acquisition acquisition_;
};

TEST_F(EraseCommands, TakesItOutOfTheModelAndUndoRestoresTheSameBytes) {
  const std::uint64_t before = stateHash(*acquisition_.state());
  ASSERT_GT(verticesInPutty(), 50U);
  const Erasure announced = erasureOf(*acquisition_.state(), {0, aroundPutty(), false});
  const std::size_t firstView = acquisition_.state()->scans[0].view.mesh->mesh.vertices.size();
  const std::size_t triangles = acquisition_.state()->model->mesh.triangles.size();
  const double areaBefore = area(acquisition_.state()->model->mesh);
  acquisition_.carryOut(erasePutty());
  EXPECT_EQ(verticesInPutty(), 0U);
  const auto marked = static_cast<std::size_t>(std::count(announced.triangles.begin(), announced.triangles.end(), 1));
  EXPECT_NEAR(static_cast<double>(triangles - acquisition_.state()->model->mesh.triangles.size()),
              static_cast<double>(marked), 6.0);
  EXPECT_NEAR(areaBefore - area(acquisition_.state()->model->mesh), announced.area, 0.01 * announced.area);
  EXPECT_EQ(acquisition_.state()->scans[0].view.mesh->mesh.vertices.size(), firstView) << "scans stay whole";
  acquisition_.undo();
  EXPECT_EQ(stateHash(*acquisition_.state()), before);
  acquisition_.redo();
  EXPECT_EQ(verticesInPutty(), 0U);
}

TEST_F(EraseCommands, HoldsForLaterScansWhichFindTheirPlacesAsWell) {
  MemoryJournal kept(testing::smallProfile(), settings());
  Acquisition whole(kept, tools());
  for (int i = 0; i < 3; ++i) whole.scanNext();
  acquisition_.carryOut(erasePutty());
  for (int i = 0; i < 3; ++i) {
    // The same scan without anything erased.
    const int position = *nextPosition(*acquisition_.state());
    acquisition_.scanNext();
    whole.carryOut(ChoosePosition{position});
    whole.scanNext();
    EXPECT_EQ(verticesInPutty(), 0U);
    const KeptScan& erased = acquisition_.state()->scans.back();
    const KeptScan& other = whole.state()->scans.back();
    ASSERT_EQ(erased.station().position, other.station().position);
    EXPECT_EQ(erased.status, ScanStatus::In);
    EXPECT_EQ(erased.record.registration.verdict, other.record.registration.verdict);
    const Vec3 middle(0, 0, 40);
    const Pose T_scanner_object = other.view.T_object_scanner.inverse();
    EXPECT_LT((erased.view.T_object_scanner * (T_scanner_object * middle) - middle).norm(), 0.2);
  }
}

TEST_F(EraseCommands, WhatIsErasedCountsForRegistrationAsItDid) {
  const std::size_t before = targetInStand(*acquisition_.state(), 0).size();
  acquisition_.carryOut(erasePutty());
  const AcquisitionState& state = *acquisition_.state();
  EXPECT_LT(RegistrationTarget(state.model->mesh).size(), before);
  EXPECT_GE(targetInStand(state, 0).size(), before);
  EXPECT_GT(surfaceInStand(state, 0).triangles.size(), state.model->mesh.triangles.size());
}

TEST_F(EraseCommands, PlansDoNotGoBackToTheBorderThatItMade) {
  acquisition_.carryOut(erasePutty());
  const auto state = acquisition_.state();
  ASSERT_TRUE(state->plan && state->plan->voids);
  const ErasedSpace space = erasedSpaceOf(state->stands);
  const auto border = erasedBorderNow(*state);
  std::size_t erased = 0;
  for (std::size_t p = 0; p < state->plan->voids->patches.size(); ++p) {
    const VoidPatch& patch = state->plan->voids->patches[p];
    if (border[patch.from] == 0 || border[patch.to] == 0) continue;
    ++erased;
    EXPECT_EQ(state->plan->outlook[p].reason, EdgeReason::Erased);
    EXPECT_EQ(state->plan->outlook[p].promise, 0.0);
    for (const PositionScore& score : state->plan->scores)
      EXPECT_EQ(std::count(score.patches.begin(), score.patches.end(), static_cast<std::uint32_t>(p)), 0)
          << "position " << score.position << " is to show it";
  }
  EXPECT_GT(erased, 5U);
}

TEST_F(EraseCommands, TheRunEndsWithAnHonestCertificate) {
  acquisition_.carryOut(erasePutty());
  const Termination ended = acquisition_.runUntilTheEnd();
  EXPECT_EQ(ended, Termination::Finished) << name(ended);
  const auto state = acquisition_.state();
  EXPECT_EQ(verticesInPutty(), 0U);
  const auto left = edgesLeft(*state->plan);
  const auto isErased = [](const EdgesLeft& l) { return l.reason == EdgeReason::Erased; };
  ASSERT_EQ(std::count_if(left.begin(), left.end(), isErased), 1);
  EXPECT_GT(std::find_if(left.begin(), left.end(), isErased)->length, 10.0);
  const Completeness complete = completenessOf(*state);
  EXPECT_GE(complete.erasedHoles, 1U);
  EXPECT_GT(complete.wholeCovered, completenessOf(state->model->mesh, state->plan.get()).wholeCovered);
  EXPECT_EQ(makeReport(*state, "test")["completeness"]["erased_holes"], complete.erasedHoles);
}

TEST_F(EraseCommands, AnErasureIsTakenBackAfterFurtherScans) {
  acquisition_.carryOut(erasePutty());
  EXPECT_EQ(erasuresOf(acquisition_.state()->stands), std::vector<int>{0});
  acquisition_.scanNext();
  acquisition_.carryOut(TakeBackErasure{0});
  EXPECT_TRUE(erasuresOf(acquisition_.state()->stands).empty());
  EXPECT_GT(verticesInPutty(), 50U);
  EXPECT_EQ(acquisition_.mayDo(TakeBackErasure{0})->reason, RefusalReason::NotErased);
  EXPECT_EQ(countScans(*acquisition_.state(), ScanStatus::In), 4U);
}

TEST_F(EraseCommands, WhatWouldLeaveNothingIsRefused) {
  expectError<InvalidInput>(
      [&] {
        acquisition_.carryOut(EraseRegion{0, BelowPlane{Vec3(0, 0, 1000), Vec3::UnitZ()}});
      },
      {"nothing"});
  EXPECT_TRUE(erasuresOf(acquisition_.state()->stands).empty());
  EXPECT_EQ(acquisition_.mayDo(EraseRegion{1, BelowPlane{}})->reason, RefusalReason::NoSuchStand);
  EXPECT_EQ(EraseRegion{}.mayDo(AcquisitionState{})->reason, RefusalReason::NothingScanned);
}

TEST_F(EraseCommands, ViewsLeftOutAndTakenBackKeepItErased) {
  acquisition_.carryOut(erasePutty());
  acquisition_.carryOut(LeaveOutView{acquisition_.state()->scans[1].number});
  EXPECT_EQ(verticesInPutty(), 0U);
  acquisition_.carryOut(TakeBackView{acquisition_.state()->scans[1].number});
  EXPECT_EQ(verticesInPutty(), 0U);
}

TEST(ErasedRegions, LoosePiecesGoAndNothingElse) {
  MemoryJournal journal(testing::smallProfile(), {});
  const Mesh scene = testing::joined(testing::smallObject(), testing::makeSphere(7, 10, {55, -30, 70}));
  AcquisitionTools tools = testing::smallTools(testing::smallProfile());
  tools.rig = testing::simulation(scene, testing::smallProfile(), {1, true});
  Acquisition acquisition(journal, tools);
  for (int i = 0; i < 3; ++i) acquisition.scanNext();
  const auto before = acquisition.state();
  EXPECT_FALSE(loosePiecesRegion(*before, 0.0));
  const auto pieces = loosePiecesRegion(*before, 1000.0);
  ASSERT_TRUE(pieces);
  const Erasure erasure = erasureOf(*before, {0, *pieces, false});
  EXPECT_GE(erasure.pieces, 1U);
  acquisition.carryOut(EraseRegion{0, *pieces, false});
  const auto near = [](const AcquisitionState& state) {
    return std::count_if(state.model->mesh.vertices.begin(), state.model->mesh.vertices.end(),
                         [](const Vec3& v) { return (v - Vec3(55, -30, 70)).norm() < 9.0; });
  };
  EXPECT_GT(near(*before), 10);
  EXPECT_EQ(near(*acquisition.state()), 0);
  EXPECT_EQ(acquisition.state()->model->mesh.vertices.size() + erasure.samples, before->model->mesh.vertices.size());
  EXPECT_FALSE(loosePiecesRegion(*acquisition.state(), 1000.0));
}

TEST(ErasedRegions, NumbersGoOnAndAreToldApart) {
  std::vector<Stand> stands{{Pose::Identity()}, {}};
  EXPECT_EQ(nextErasure(stands), 0);
  const auto probe = std::make_shared<const RegionProbe>(BelowPlane{});
  stands[0].erased = {{0, probe}, {2, probe}};
  stands[1].erased = {{2, probe}};
  EXPECT_EQ(nextErasure(stands), 3);
  EXPECT_EQ(erasuresOf(stands), (std::vector<int>{0, 2}));
  const ErasedSpace space = erasedSpaceOf(stands);
  EXPECT_EQ(space.regions().size(), 3U);
  EXPECT_TRUE(space.isIn(1));
}

TEST(ErasedSession, ReopensToTheSameBytesAndGoesOn) {
  testing::TemporaryFolder folder;
  const std::string path = folder.file("erased.vantage");
  AcquisitionSettings settings;
  settings.simulation.object = "small";
  std::uint64_t hash = 0;
  std::uint64_t before = 0;
  OrientedBox box;
  box.T_region_box.translation() = Vec3(30, 25, 30);
  box.size = Vec3::Constant(34);
  {
    Session session = testing::createSmallSession(path, settings);
    Acquisition acquisition(session, testing::smallTools(session.profile(), settings));
    acquisition.scanNext();
    acquisition.scanNext();
    before = stateHash(*session.state());
    acquisition.carryOut(EraseRegion{0, box, true});
    acquisition.scanNext();
    hash = stateHash(*session.state());
  }
  Session session = Session::open(path, SessionAccess::Write);
  EXPECT_TRUE(session.losses().empty());
  EXPECT_EQ(stateHash(*session.state()), hash);
  ASSERT_EQ(session.state()->stands[0].erased.size(), 1U);
  EXPECT_TRUE(session.state()->stands[0].erased[0].region->region() == Region(box));
  EXPECT_TRUE(std::get<EraseRegion>(session.history().entry(3).command).region == Region(box));
  Acquisition acquisition(session, testing::smallTools(session.profile(), settings, 3));
  acquisition.undo();
  acquisition.undo();
  EXPECT_EQ(stateHash(*session.state()), before);
  EXPECT_TRUE(session.losses().empty());
}

}  // namespace
}  // namespace vantage
