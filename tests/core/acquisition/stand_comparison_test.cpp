#include "acquisition/stand_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>

#include "acquisition/memory_journal.h"
#include "acquisition/stand_composites.h"
#include "base/errors.h"
#include "scanner/simulated_stand.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

Pose turnedOver() {
  return simulatedStand(testing::smallObject(), Vec3(Vec3::UnitX()), 1, 1);
}

// The small object with two views upright, then so many turned over.
AcquisitionState inTwoStands(int turned) {
  const auto profile = testing::smallProfile();
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*profile));
  MemoryJournal journal(profile, {});
  Acquisition upright(journal, {testing::simulation(testing::smallObject(), profile, {1, true}), images});
  for (int i = 0; i < 3; ++i) upright.scanNext();
  upright.carryOut(TurnObject{});
  Acquisition lying(
      journal, {testing::simulation(transformed(testing::smallObject(), turnedOver()), profile, {1, true}), images});
  for (int i = 0; i < turned; ++i) lying.scanNext();
  return *journal.state();
}

std::ptrdiff_t count(const PosePlaces& places, PlaceWord word) {
  return std::count(places.reference.begin(), places.reference.end(), word) +
         std::count(places.moved.begin(), places.moved.end(), word);
}

TEST(StandComparison, HasTheObjectAndTheStandBesideEachOther) {
  const AcquisitionState state = inTwoStands(3);
  const StandComparison comparison = compareStand(state, 1);
  EXPECT_EQ(comparison.stand, 1);
  EXPECT_EQ(comparison.object.composite().views.size(), 3U);
  EXPECT_EQ(comparison.composite.composite().views.size(), 3U);
  EXPECT_EQ(comparison.object.composite().model, withObject(state).model);
  const PosePlaces right = comparison.placesAt(turnedOver().inverse());
  const PosePlaces wrong = comparison.placesAt(Pose::Identity());
  EXPECT_GT(count(right, PlaceWord::OnIt), count(wrong, PlaceWord::OnIt));
  EXPECT_LT(10 * count(right, PlaceWord::Conflict), count(wrong, PlaceWord::Conflict));
}

TEST(StandComparison, IsOfAStandThatIsToBeAligned) {
  const AcquisitionState state = inTwoStands(0);
  EXPECT_THROW(static_cast<void>(compareStand(state, 0)), InvalidInput);
  EXPECT_THROW(static_cast<void>(compareStand(state, 1)), InvalidInput);
  EXPECT_THROW(static_cast<void>(compareStand(state, 2)), InvalidInput);
}

TEST(StandComparison, StopsWhenItIsAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(compareStand(inTwoStands(2), 1, Progress({}, source.get_token(), 1))), Cancelled);
}

}  // namespace
}  // namespace vantage
