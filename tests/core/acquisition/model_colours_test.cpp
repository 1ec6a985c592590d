#include "acquisition/model_colours.h"

#include <gtest/gtest.h>

#include <vector>

#include "acquisition/memory_journal.h"
#include "support/coloured_scan.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

AcquisitionState imported(bool coloured, const AcquisitionSettings& settings = {},
                          const std::vector<int>& positions = {0, 2}) {
  const Rig rig = testing::simulation(testing::smallObject(), testing::smallProfile(), {1, true});
  std::vector<RangeImage> images;
  for (const int position : positions) {
    RangeImage image = scanFrom(rig, position, {});
    image.station.position.reset();
    image.poseKnownBy = PoseSource::Reported;
    images.push_back(coloured ? testing::painted(std::move(image)) : std::move(image));
  }
  MemoryJournal journal(nullptr, settings);
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

TEST(ModelColours, AreThoseOfTheSamplesThatAreWorkedOn) {
  AcquisitionSettings settings;
  settings.thinning.spacing = 7.0;
  const AcquisitionState state = imported(true, settings, {0});
  ASSERT_GT(state.scans[0].record.everyNth, 1);
  const VertexColours colours = coloursOf(state);
  ASSERT_EQ(colours.size(), state.model->mesh.vertices.size());
  ASSERT_EQ(countColourless(colours), 0U);
  int most = 0;
  for (std::size_t v = 0; v < colours.size(); ++v)
    most = std::max(most, testing::differenceOf(*colours[v], testing::paintAt(state.model->mesh.vertices[v])));
  EXPECT_LE(most, 3);
}

}  // namespace
}  // namespace vantage
