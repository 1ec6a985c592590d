#include <gtest/gtest.h>

#include <algorithm>

#include "acquisition/acquisition.h"
#include "acquisition/erased_regions.h"
#include "acquisition/memory_journal.h"
#include "acquisition/stand_composites.h"
#include "scanner/simulated_stand.h"
#include "session/state_hash.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// How the small object lies on its side in stand 1: T_table_object.
Pose lying() {
  return simulatedStand(testing::smallObject(), Vec3::UnitX(), 1, 1);
}

// Putty that the object stands in upright, in object coordinates, and the block that holds it when it lies.
Mesh putty() {
  return testing::makeBox({-16, -30, 0}, {26, 14, 20}, 6);
}
Mesh holder() {
  return testing::makeBox({-40, -20, 0}, {-18, 20, 18}, 6);
}

OrientedBox around(const Vec3& low, const Vec3& high) {
  OrientedBox box;
  box.T_region_box.translation() = 0.5 * (low + high);
  box.size = high - low + Vec3::Constant(3.0);
  return box;
}

// Some views upright in putty, then some lying in a holder, with both erased.
class ErasedStands : public ::testing::Test {
 protected:
  ErasedStands() : journal_(testing::smallProfile(), settings()) {
    Acquisition upright = acquisition(testing::joined(testing::smallObject(), putty()));
    for (int i = 0; i < 4; ++i) upright.scanNext();
    upright.carryOut(EraseRegion{0, around({-16, -30, 0}, {26, 14, 20}), false});
    upright.carryOut(TurnObject{{}, Vec3::UnitX()});
    Acquisition turned = acquisition(testing::joined(transformed(testing::smallObject(), lying()), holder()));
    for (int i = 0; i < 4; ++i) turned.scanNext();
    turned.carryOut(EraseRegion{1, around({-40, -20, 0}, {-18, 20, 18}), false});
  }

  static AcquisitionSettings settings() {
    AcquisitionSettings settings;
    settings.strategy = parseStrategy("uniform:4");
    return settings;
  }
  Acquisition acquisition(const Mesh& scene) {
    return Acquisition(journal_, {testing::simulation(scene, testing::smallProfile(), {1, true}), nullptr});
  }
  [[nodiscard]] const AcquisitionState& state() const { return *journal_.state(); }

  // Vertices of the model farther than so much from the object: what is not the object.
  [[nodiscard]] std::size_t beside(double most) const {
    const auto distance = [](const Vec3& v) {
      return std::min({std::abs((v - Vec3(5, -8, 40)).norm() - 32), std::abs((v - Vec3(-30, 12, 55)).norm() - 20),
                       std::abs((v - Vec3(30, 25, 30)).norm() - 14)});
    };
    const std::vector<Vec3>& vertices = state().model->mesh.vertices;
    return static_cast<std::size_t>(
        std::count_if(vertices.begin(), vertices.end(), [&](const Vec3& v) { return distance(v) > most; }));
  }

  MemoryJournal journal_;
};

TEST_F(ErasedStands, EachStandHasItsOwn) {
  ASSERT_EQ(state().stands.size(), 2U);
  EXPECT_EQ(state().stands[0].erased.size(), 1U);
  EXPECT_EQ(state().stands[1].erased.size(), 1U);
  const AcquisitionState object = withObject(state());
  const Composite upright = compositeForAligner(object, stepOptionsFor(object));
  const ErasedSpace space = erasedSpaceOf(state().stands);
  for (const View& view : upright.views)
    for (const Vec3& v : view.mesh->mesh.vertices) ASSERT_FALSE(space.holds(0, view.T_object_scanner * v));
  EXPECT_EQ(upright.views[0].image, scansOf(object, ScanStatus::In)[0]->view.image) << "what rays saw stays";
}

TEST_F(ErasedStands, PutTogetherNeitherHolderIsLeftAndWhatItHidIsThere) {
  Acquisition acquisition(journal_);
  acquisition.carryOut(PlaceStand{1, lying().inverse()});
  ASSERT_TRUE(isOfObject(state(), 1));
  EXPECT_EQ(beside(3.0), 0U) << "of either holder";
  // The bottom of the object, which stood in putty, is of the second stand.
  const std::vector<View> views = viewsOf(state());
  const Model& model = *state().model;
  std::size_t bottom = 0;
  for (std::size_t v = 0; v < model.mesh.vertices.size(); ++v) {
    if (model.mesh.vertices[v].z() > 14.0) continue;
    EXPECT_EQ(views[model.vertexView[v]].image->station.stand, 1);
    ++bottom;
  }
  EXPECT_GT(bottom, 10U);
}

TEST_F(ErasedStands, RegionsGoWithTheirTables) {
  Acquisition acquisition(journal_);
  acquisition.carryOut(PlaceStand{1, lying().inverse()});
  const Vec3 middle(-29, 0, 9);  // of the holder, on its table
  const ErasedSpace space = erasedSpaceOf(state().stands);
  EXPECT_TRUE(space.holds(1, *state().stands[1].T_object_table * middle));
  EXPECT_FALSE(space.holds(0, *state().stands[1].T_object_table * middle));
  // A lasso on what is put together takes from both.
  const EraseRegion both{1, around({-200, -200, -200}, {200, 200, 40}), false};
  acquisition.carryOut(both);
  EXPECT_EQ(state().stands[0].erased.size(), 2U);
  EXPECT_EQ(state().stands[1].erased.size(), 2U);
  EXPECT_EQ(state().stands[0].erased[1].number, state().stands[1].erased[1].number);
  acquisition.carryOut(TakeBackErasure{state().stands[1].erased[1].number});
  EXPECT_EQ(state().stands[0].erased.size(), 1U);
  EXPECT_EQ(beside(3.0), 0U);
}

}  // namespace
}  // namespace vantage
