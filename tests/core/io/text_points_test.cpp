#include "io/text_points.h"

#include <cmath>

#include "core/io/expect_error.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

GridFile read(const std::string& text, const std::optional<GridSize>& size = {}) {
  const TemporaryFolder folder;
  return readTextPoints(FileBytes(folder.write("a.xyz", text)), size);
}

std::string plane(int rows, int columns, const std::string& head, const char* divider = " ") {
  std::string text = head;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      text += std::to_string(0.5 * c) + divider + std::to_string(0.6 * r) + divider + std::to_string(100.0 + 0.1 * c) +
              "\n";
  return text;
}

TEST(TextPoints, ReadsEveryNotation) {
  for (const char* text :
       {"1.5 2 -3\n4 5 6\n", "1.5,2,-3\r\n4,5,6\r\n", "1.5;2;-3\n4;5;6", "1,5 2 -3\n4 5 6\n", "1,5;2;-3\n4;5;6\n",
        "1.5, 2, -3\n4, 5, 6\n", "# made by\n//X Y Z\nX Y Z\n\n  1.5\t2\t-3 \n4 5 6\n", "2\n1.5 2 -3\n4 5 6\n"}) {
    const GridFile file = read(text);
    EXPECT_FALSE(file.organised) << text;
    ASSERT_EQ(file.samples.points.size(), 2U) << text;
    EXPECT_EQ(file.samples.points[0], Vec3(1.5, 2, -3)) << text;
    EXPECT_EQ(file.samples.points[1], Vec3(4, 5, 6)) << text;
  }
}

TEST(TextPoints, KeepsColoursButNotNormals) {
  EXPECT_EQ(read("1 2 3 255 128 0\n").samples.colours, (std::vector<Colour>{{255, 128, 0}}));
  EXPECT_EQ(read("1 2 3 0.5 255 128 0\n").samples.colours, (std::vector<Colour>{{255, 128, 0}}));
  EXPECT_TRUE(read("1 2 3 0 0 1\n").samples.colours.empty());
  EXPECT_TRUE(read("1 2 3 0.6 0 0.8\n").samples.colours.empty());
}

TEST(TextPoints, TakesRowsAndColumnsAsSaidOrAsTheOrderTells) {
  for (const char* head : {"12 20\n", "20 12\n", ""}) {
    const GridFile file = read(plane(20, 12, head));
    ASSERT_TRUE(file.organised) << head;
    EXPECT_EQ(file.samples.rows, 20) << head;
    EXPECT_EQ(file.samples.columns, 12) << head;
  }
  const GridFile said = read(plane(20, 12, ""), GridSize{40, 6});
  EXPECT_EQ(said.samples.rows, 40);
  expectError<InvalidInput>(
      [] {
        static_cast<void>(read(plane(20, 12, ""), GridSize{40, 7}));
      },
      {"a.xyz", "240 points", "40 x 7"});
}

TEST(TextPoints, RecognisesNoGridInPointsWithoutOrder) {
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) points.emplace_back(std::fmod(i * 37.7, 11.0), std::fmod(i * 17.3, 13.0), 5.0);
  EXPECT_FALSE(recogniseGrid(points));
}

TEST(TextPoints, TakesMissingValuesForNoSamples) {
  const GridFile file = read("2 2\n1 2 3\nnan nan nan\n-9999 -9999 -9999\n4 5 6\n");
  ASSERT_TRUE(file.organised);
  EXPECT_EQ(file.samples.cell[1], kNoIndex);
  EXPECT_EQ(file.samples.cell[2], kNoIndex);
}

TEST(TextPoints, SaysWhereAFileEndsOrIsNoPoints) {
  expectError<InvalidInput>([] { static_cast<void>(read("12 20\n1 2 3\n4 5 6\n")); }, {"a.xyz", "2 points", "240"});
  expectError<InvalidInput>([] { static_cast<void>(read("1.25 2.25 3.25\n4.25 5.25\n")); }, {"a.xyz", "line 2"});
  expectError<InvalidInput>([] { static_cast<void>(read("1.25 2.25 3.25\n1.25 2.25 3.25\n4.25 5.25 6.2")); },
                            {"a.xyz", "ends within a number"});
  expectError<InvalidInput>([] { static_cast<void>(read("1 2 3\nfour 5 6\n")); }, {"line 2", "'four 5 6'"});
}

}  // namespace
}  // namespace vantage
