#include <gtest/gtest.h>

#include "acquisition/acquisition.h"
#include "acquisition/model_colours.h"
#include "session/session.h"
#include "session/session_blobs.h"
#include "session/state_hash.h"
#include "support/coloured_scan.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

// Recorded scans of the small object, painted, the second one without colours.
Session importColoured(const std::string& path, bool mixed) {
  const Rig rig = testing::simulation(testing::smallObject(), testing::smallProfile(), {1, true});
  std::vector<RangeImage> images;
  for (const int position : {0, 3, 6}) {
    RangeImage image = scanFrom(rig, position, {});
    image.station.position.reset();
    image.poseKnownBy = PoseSource::Reported;
    images.push_back(mixed && position == 3 ? std::move(image) : testing::painted(std::move(image)));
  }
  Session session = Session::create(path, {{}, {}, nullptr, nullptr});
  Acquisition(session).importScans(std::move(images));
  return session;
}

TEST(SessionColours, OfTheModelAreThereAgainWhenItIsOpened) {
  const testing::TemporaryFolder folder;
  for (const bool mixed : {false, true}) {
    const std::string path = folder.file(mixed ? "mixed.vantage" : "all.vantage");
    const AcquisitionState saved = *importColoured(path, mixed).state();
    const VertexColours colours = coloursOf(saved);
    ASSERT_EQ(colours.size(), saved.model->mesh.vertices.size());
    EXPECT_EQ(countColourless(colours) > 0, mixed);

    const Session session = Session::open(path, SessionAccess::Read);
    session.check();
    const auto loaded = session.state();
    EXPECT_TRUE(session.losses().empty());
    EXPECT_EQ(modelBlob(*loaded->model), modelBlob(*saved.model));
    EXPECT_EQ(coloursOf(*loaded), colours);
    EXPECT_EQ(stateHash(*loaded), stateHash(saved));
  }
}

TEST(SessionColours, AreThoseOfThePaint) {
  const testing::TemporaryFolder folder;
  const auto state = importColoured(folder.file("all.vantage"), false).state();
  ASSERT_EQ(countScans(*state, ScanStatus::In), 3U);
  const VertexColours colours = coloursOf(*state);
  int most = 0;
  for (std::size_t v = 0; v < colours.size(); ++v)
    most = std::max(most, testing::differenceOf(*colours[v], testing::paintAt(state->model->mesh.vertices[v])));
  // 1.5 a millimetre: scans are registered to some tenths of one.
  EXPECT_LE(most, 3);
}

}  // namespace
}  // namespace vantage
