#include "session/session_states.h"

#include <gtest/gtest.h>

#include "acquisition/acquisition_state.h"
#include "core/io/expect_error.h"
#include "session/loss.h"
#include "session/session.h"
#include "session/session_blobs.h"
#include "session/session_schema.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;

// The states of a session of two views, straight from its file.
class SessionStatesTest : public ::testing::Test {
 protected:
  SessionStatesTest() : saved_(acquired(path())), store_(Database(path(), Database::Mode::Write)) {
    states_.setProfile(SessionStates::parsed(store_.profileSource()));
    StoredHistory stored = store_.history();
    history_.restore(std::move(stored.entries), stored.cursor);
  }

  static AcquisitionState acquired(const std::string& path) {
    AcquisitionSettings settings;
    settings.maxViews = 2;
    Session session = testing::createSmallSession(path, settings);
    return testing::runSmallSession(session);
  }

  [[nodiscard]] std::string path() const { return folder_.file("states.vantage"); }

  [[nodiscard]] AcquisitionState stateAt(std::size_t index) { return states_.state(history_, history_.entry(index)); }

  testing::TemporaryFolder folder_;
  AcquisitionState saved_;
  SessionStore store_;
  std::vector<Loss> losses_;
  SessionStates states_{store_, losses_};
  History history_{[this](const HistoryEntry& entry) {
    return std::make_shared<const AcquisitionState>(states_.state(history_, entry));
  }};
};

TEST_F(SessionStatesTest, AreBuiltFromTheirPiecesToTheSameBytes) {
  ASSERT_EQ(history_.size(), 3U);
  for (std::size_t i = 0; i < history_.size(); ++i)
    EXPECT_EQ(stateHash(states_.state(history_, history_.entry(i))), history_.entry(i).hash) << i;
  EXPECT_EQ(stateHash(stateAt(2)), stateHash(saved_));
  EXPECT_EQ(losses_, std::vector<Loss>());
}

TEST_F(SessionStatesTest, HandOutAgainWhatSomebodyHoldsAndNothingElse) {
  std::weak_ptr<const RangeImage> scan;
  {
    const AcquisitionState one = stateAt(1);
    const AcquisitionState two = stateAt(2);
    EXPECT_EQ(one.scans[0].view.image, two.scans[0].view.image);
    EXPECT_EQ(one.scans[0].view.mesh, two.scans[0].view.mesh);
    EXPECT_EQ(two.model, states_.model(3, 2));
    EXPECT_EQ(two.plan, states_.plan(3));
    scan = two.scans[0].view.image;
  }
  EXPECT_TRUE(scan.expired());
}

TEST_F(SessionStatesTest, AModelThatIsNotThereIsMadeAgainAndNoLoss) {
  store_.database().run("DELETE FROM model");
  EXPECT_EQ(states_.model(3, 2), nullptr);
  EXPECT_EQ(modelBlob(*stateAt(2).model), modelBlob(*saved_.model));
  EXPECT_EQ(losses_, std::vector<Loss>());
}

TEST_F(SessionStatesTest, AModelOfMoreViewsIsNamedOnceAndMadeAgain) {
  store_.database().run(
      "UPDATE model SET data = (SELECT data FROM model WHERE step = 3) WHERE step = (SELECT min(step) FROM model)");
  addSums(store_.database(), "model");
  const AcquisitionState one = stateAt(1);
  EXPECT_EQ(stateHash(one), history_.entry(1).hash);
  EXPECT_EQ(states_.model(2, 1), one.model);
  EXPECT_EQ(losses_, (std::vector<Loss>{{LossKind::ModelOfOtherViews, 2, {}, {}}}));
}

TEST_F(SessionStatesTest, AScanThatIsDamagedIsLeftOutAndNamedOnce) {
  store_.database().run("UPDATE scan SET range = x'00112233' WHERE id = 1");
  expectError<InvalidInput>([&] { static_cast<void>(states_.scan(1)); }, {"states.vantage", "scan 1"});
  for (int i = 0; i < 2; ++i) {
    const AcquisitionState state = stateAt(2);
    ASSERT_EQ(state.scans.size(), 1U);
    EXPECT_EQ(state.scans[0].number, 0);
    EXPECT_TRUE(state.model);
    EXPECT_FALSE(state.plan);
  }
  ASSERT_EQ(losses_.size(), 1U);
  EXPECT_EQ(losses_[0].kind, LossKind::ScanDamaged);
  EXPECT_EQ(losses_[0].number, 1);
}

TEST_F(SessionStatesTest, APlanOfOtherPositionsIsNamed) {
  ProfileSource coarse = testing::smallProfileSource();
  const std::string steps = "\"steps\": 24";
  coarse.text.replace(coarse.text.find(steps), steps.size(), "\"steps\": 12");
  states_.setProfile(SessionStates::parsed(coarse));
  EXPECT_EQ(states_.plan(0), nullptr);
  EXPECT_EQ(states_.plan(3), nullptr);
  EXPECT_EQ(losses_, (std::vector<Loss>{{LossKind::PlanOfOtherPositions, 3, {}, {}}}));
}

TEST_F(SessionStatesTest, StepsOfPositionsThatThereAreNotAreTakenOutAndTheCursorStaysInside) {
  store_.database().run("UPDATE step SET chosen = 24 WHERE id = 3");
  StoredHistory stored = store_.history();
  ASSERT_EQ(stored.cursor, 2U);
  states_.dropImpossible(stored);
  ASSERT_EQ(stored.entries.size(), 2U);
  EXPECT_EQ(stored.cursor, 1U);
  EXPECT_EQ(losses_, (std::vector<Loss>{{LossKind::StepImpossible, 3, {}, {}}}));
}

TEST_F(SessionStatesTest, KeepAScanUnderANumberOfItsOwnAndKnowItAgain) {
  const auto image = std::make_shared<const RangeImage>(*states_.scan(0));
  const StoredScan stored = states_.keep(*image);
  EXPECT_EQ(stored.number, 2);
  EXPECT_EQ(stored.rays, 0);
  states_.remember(stored, image);
  EXPECT_EQ(states_.scan(2), image);
  RangeImage elsewhere = *image;
  elsewhere.station.position = 24;
  expectError<InvalidInput>([&] { static_cast<void>(states_.keep(elsewhere)); }, {"position 24"});
}

TEST_F(SessionStatesTest, AnOutlineNamesTheStepsThatMadeWhatIsNew) {
  const AcquisitionState two = states_.state(history_, history_.entry(2));
  AcquisitionState chosen = two;
  chosen.chosenPosition = 5;
  const StateOutline outline = states_.outline(chosen, *history_.entry(2).outline, 4);
  EXPECT_EQ(outline.modelStep, 3);
  EXPECT_EQ(outline.planStep, 3);
  EXPECT_EQ(outline.scans[0].recordStep, 2);
  EXPECT_EQ(outline.scans[1].recordStep, 3);
  chosen.model = std::make_shared<const Model>(*two.model);
  chosen.plan = nullptr;
  const StateOutline other = states_.outline(chosen, *history_.entry(2).outline, 4);
  EXPECT_EQ(other.modelStep, 4);
  EXPECT_EQ(other.planStep, 0);
}

TEST(SessionStates, WorkOnScansAsThinlyAsTheyDidAndKeepThemWhole) {
  const testing::TemporaryFolder folder;
  AcquisitionSettings settings;
  settings.maxViews = 2;
  settings.thinning.spacing = 5.6;
  std::uint64_t hash = 0;
  std::size_t raysLeft = 0;
  {
    Session session = testing::createSmallSession(folder.file("thin.vantage"), settings);
    const AcquisitionState state = testing::runSmallSession(session);
    hash = stateHash(state);
    raysLeft = state.scans[0].view.image->rays->size();
    EXPECT_EQ(state.scans[0].view.image->rays, state.scans[1].view.image->rays);
  }
  const Session session = Session::open(folder.file("thin.vantage"), SessionAccess::Write);
  const auto state = session.state();
  EXPECT_EQ(stateHash(*state), hash);
  EXPECT_TRUE(session.losses().empty());
  EXPECT_EQ(state->scans[0].view.image->rays->size(), raysLeft);
  EXPECT_EQ(state->scans[0].view.image->rays, state->scans[1].view.image->rays);
  EXPECT_LT(raysLeft, session.profile()->rays->size() / 3);
  EXPECT_EQ(session.scan(0)->rays, session.profile()->rays);
}

TEST(SessionStates, OfNoProfileAreOfRecordedScans) {
  EXPECT_EQ(SessionStates::parsed(std::nullopt), nullptr);
  EXPECT_THROW(static_cast<void>(SessionStates::parsed(ProfileSource{"x", "{}", {}})), InvalidInput);
}

}  // namespace
}  // namespace vantage
