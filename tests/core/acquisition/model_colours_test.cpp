#include "acquisition/model_colours.h"

#include <gtest/gtest.h>

#include "acquisition/memory_journal.h"
#include "support/coloured_scan.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

AcquisitionState imported(bool coloured) {
  const Rig rig = testing::simulation(testing::smallObject(), testing::smallProfile(), {1, true});
  std::vector<RangeImage> images;
  for (const int position : {0, 2}) {
    RangeImage image = scanFrom(rig, position, {});
    image.station.position.reset();
    image.poseKnownBy = PoseSource::Reported;
    images.push_back(coloured ? testing::painted(std::move(image)) : std::move(image));
  }
  MemoryJournal journal(nullptr, {});
  Acquisition(journal).importScans(std::move(images));
  return *journal.state();
}

TEST(ModelColours, AreNoneWithoutAModelOrColours) {
  EXPECT_TRUE(coloursOf({}).empty());
  EXPECT_TRUE(coloursOf(imported(false)).empty());
}

TEST(ModelColours, AreThoseOfTheScansThatAreIn) {
  const AcquisitionState state = imported(true);
  const VertexColours colours = coloursOf(state);
  ASSERT_EQ(colours.size(), state.model->mesh.vertices.size());
  EXPECT_EQ(countColourless(colours), 0U);
  EXPECT_EQ(colours, colourVertices(*state.model, viewsOf(state), state.settings.consensus));
}

}  // namespace
}  // namespace vantage
