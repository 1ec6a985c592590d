#include <gtest/gtest.h>

#include "acquisition/apply_command.h"
#include "acquisition/step_options.h"
#include "session/session_blobs.h"
#include "session/state_hash.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::TemporaryFolder;

// A session of two views of the small object before a wall that is cut away.
class SessionCutTest : public ::testing::Test {
 protected:
  SessionCutTest() {
    AcquisitionSettings settings;
    settings.simulation.object = "small";
    settings.maxViews = 2;
    settings.cut = cutForRealScanners();
    Session session = testing::createSmallSession(path(), settings);
    AcquisitionTools tools = testing::smallTools(session.profile(), settings);
    tools.rig = testing::simulation(
        testing::joined(testing::smallObject(), testing::makeBox({-120, -70, 0}, {-110, 70, 110}, 8)),
        session.profile(), {1, true});
    Acquisition acquisition(session, tools);
    acquisition.runUntilTheEnd();
    saved_ = *session.state();
  }

  [[nodiscard]] std::string path() const { return folder_.file("cut.vantage"); }
  [[nodiscard]] Session reopened() const { return Session::open(path(), SessionAccess::Read); }

  TemporaryFolder folder_;
  AcquisitionState saved_;
};

TEST_F(SessionCutTest, TheFileHasTheScanAsItCame) {
  const Session session = reopened();
  const std::size_t used = session.state()->scans[0].view.image->sampleCount();
  EXPECT_GT(session.scan(0)->sampleCount(), used + 100);
  const auto reasons = cutOf(*session.scan(0), stepOptionsFor(*session.state()).cut);
  EXPECT_EQ(rangeBlob(withoutCut(*session.scan(0), reasons).range),
            rangeBlob(session.state()->scans[0].view.image->range));
}

TEST_F(SessionCutTest, ReopensToTheSameBytes) {
  const Session session = reopened();
  const auto loaded = session.state();
  ASSERT_EQ(countScans(*loaded, ScanStatus::In), 2U);
  EXPECT_EQ(stateHash(*loaded), stateHash(saved_));
  EXPECT_TRUE(session.losses().empty());
  for (std::size_t i = 0; i < saved_.scans.size(); ++i) {
    EXPECT_EQ(rangeBlob(loaded->scans[i].view.image->range), rangeBlob(saved_.scans[i].view.image->range));
    EXPECT_EQ(loaded->scans[i].view.mesh->mesh.vertices.size(), saved_.scans[i].view.mesh->mesh.vertices.size());
    EXPECT_EQ(loaded->scans[i].record.cut, saved_.scans[i].record.cut);
    EXPECT_GT(cutSamples(loaded->scans[i].record.cut), 0U);
  }
  EXPECT_EQ(session.state(1)->scans[0].view.image, loaded->scans[0].view.image);
}

TEST_F(SessionCutTest, ReplaysToTheSameBytes) {
  const Session session = reopened();
  const ScannerImages images = computeScannerImages(*session.profile());
  const CommandInput input{[&](std::int64_t number) { return session.scan(number); }, &images};
  AcquisitionState state;
  state.profile = session.profile();
  for (std::size_t i = 0; i < session.history().size(); ++i) {
    state = applyCommand(state, session.history().entry(i).command, input, {});
    EXPECT_EQ(stateHash(state), session.history().entry(i).hash) << i;
  }
}

TEST_F(SessionCutTest, TheCutStaysOnceThereAreScans) {
  Session session = Session::open(path(), SessionAccess::Write);
  Acquisition acquisition(session, {{}, testing::smallTools(session.profile()).images});
  AcquisitionSettings other = session.state()->settings;
  other.cut.tableMargin = 7.0;
  EXPECT_EQ(acquisition.mayDo(ChangeSettings{other})->reason, RefusalReason::MeshesMade);
  acquisition.undo();
  acquisition.undo();
  acquisition.carryOut(ChangeSettings{other});
  EXPECT_EQ(session.state()->settings.cut.tableMargin, 7.0);
}

}  // namespace
}  // namespace vantage
