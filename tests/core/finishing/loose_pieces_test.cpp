#include "finishing/loose_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeBox;

Mesh threeBoxes() {
  return joined(joined(makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1)), makeBox(Vec3(5, 0, 0), Vec3(8, 3, 3))),
                makeBox(Vec3(10, 0, 0), Vec3(12, 2, 2)));
}

TEST(LoosePieces, AreInOrderOfTheirArea) {
  const auto pieces = piecesOf(threeBoxes());
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_NEAR(pieces[0].area, 54.0, 1e-9);
  EXPECT_NEAR(pieces[1].area, 24.0, 1e-9);
  EXPECT_NEAR(pieces[2].area, 6.0, 1e-9);
}

TEST(LoosePieces, UpToAnAreaAndNeverTheLargest) {
  const auto count = [](double area) {
    const auto loose = loosePieces(threeBoxes(), area);
    return std::count(loose.begin(), loose.end(), 1);
  };
  EXPECT_EQ(count(5.0), 0);
  EXPECT_EQ(count(6.5), 12);
  EXPECT_EQ(count(std::numeric_limits<double>::infinity()), 24);
}

TEST(LoosePieces, AVolumeIsNegativeInsideOut) {
  Mesh box = makeBox(Vec3(1000, 0, 0), Vec3(1002, 3, 4));
  const std::vector<std::uint32_t> all = piecesOf(box)[0].triangles;
  EXPECT_NEAR(signedVolume(box, all), 24.0, 1e-9);
  for (Triangle& t : box.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(signedVolume(box, all), -24.0, 1e-9);
}

}  // namespace
}  // namespace vantage
