#include "acquisition/history.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "session/state_hash.h"

namespace vantage {
namespace {

std::shared_ptr<const AcquisitionState> stateWithMaxViews(int maxViews) {
  AcquisitionState state;
  state.settings.maxViews = maxViews;
  return std::make_shared<const AcquisitionState>(std::move(state));
}

// Steps 1, 2, ... with 10, 20, ... views at most.
void addSteps(History& history, std::int64_t count) {
  for (std::int64_t step = 1; step <= count; ++step)
    history.add({step, ChoosePosition{}, nullptr, {}}, stateWithMaxViews(static_cast<int>(10 * step)));
}

TEST(History, UndoAndRedoMoveBetweenTheStatesAndTheFirstStays) {
  History history;
  addSteps(history, 3);
  EXPECT_FALSE(history.canRedo());
  EXPECT_THROW(history.redo(), InvalidInput);
  history.undo();
  EXPECT_EQ(history.current().step, 2);
  EXPECT_EQ(history.state(history.cursor())->settings.maxViews, 20);
  history.undo();
  EXPECT_FALSE(history.canUndo());
  EXPECT_THROW(history.undo(), InvalidInput);
  history.redo();
  history.redo();
  EXPECT_EQ(history.state(history.cursor())->settings.maxViews, 30);
}

TEST(History, ACommandAfterUndoCutsOffWhatCouldBeRedone) {
  History history;
  addSteps(history, 3);
  history.undo();
  history.undo();
  history.add({4, ChoosePosition{}, nullptr, {}}, stateWithMaxViews(40));
  EXPECT_EQ(history.size(), 2U);
  EXPECT_FALSE(history.canRedo());
  EXPECT_EQ(history.current().step, 4);
}

TEST(History, WithALoaderOnlyTheStateAtTheCursorStaysInMemory) {
  int loaded = 0;
  History history([&](const HistoryEntry& entry) {
    ++loaded;
    return stateWithMaxViews(static_cast<int>(10 * entry.step));
  });
  addSteps(history, 3);
  const std::weak_ptr<const AcquisitionState> last = history.state(2);
  EXPECT_EQ(loaded, 0);
  history.undo();
  EXPECT_EQ(loaded, 1);
  EXPECT_TRUE(last.expired());
  EXPECT_EQ(history.state(0)->settings.maxViews, 10);
  EXPECT_EQ(loaded, 2);
  const auto held = history.state(0);
  EXPECT_EQ(held, history.state(0));
}

TEST(History, RefusesACursorThatIsNoEntry) {
  History history;
  EXPECT_THROW(history.restore({}, 0), InvalidInput);
}

TEST(StateHash, TellsStatesApartAndIgnoresTimes) {
  AcquisitionState a;
  a.scans.resize(1);
  AcquisitionState b = a;
  b.scans[0].record.seconds[Phase::Scan] = 3.0;
  EXPECT_EQ(stateHash(a), stateHash(b));
  b.scans[0].record.newArea = 1e-300;
  EXPECT_NE(stateHash(a), stateHash(b));
  b = a;
  b.scans[0].view.T_object_scanner.translation().z() = -0.0;  // other bytes
  EXPECT_NE(stateHash(a), stateHash(b));
  b = a;
  b.scans[0].record.registration.finding = {VerdictReason::Inliers, 0.5, {}};
  AcquisitionState c = b;
  EXPECT_NE(stateHash(a), stateHash(b));
  c.scans[0].record.registration.finding.value = 0.25;
  EXPECT_NE(stateHash(b), stateHash(c));
  b = a;
  b.chosenPosition = 0;
  EXPECT_NE(stateHash(a), stateHash(b));
}

}  // namespace
}  // namespace vantage
