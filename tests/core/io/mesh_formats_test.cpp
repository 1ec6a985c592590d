#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <numeric>

#include "core/io/expect_error.h"
#include "io/obj_reader.h"
#include "io/off_reader.h"
#include "io/ply_mesh.h"
#include "io/stl_reader.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

template <typename Reader>
PolygonSoup parse(const Reader& reader, const std::string& bytes) {
  const TemporaryFolder folder;
  return reader(FileBytes(folder.write("file", bytes)), Progress());
}

template <typename Reader>
void expectRefused(const Reader& reader, const std::string& bytes, const std::vector<std::string>& parts) {
  expectError<InvalidInput>([&] { static_cast<void>(parse(reader, bytes)); }, parts);
}

std::string binaryStl(std::uint32_t declared, std::size_t written, const std::string& header = "") {
  std::string bytes = header;
  bytes.resize(80, '\0');
  bytes.append(reinterpret_cast<const char*>(&declared), 4);
  const std::array<float, 12> triangle{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  for (std::size_t i = 0; i < written; ++i) {
    bytes.append(reinterpret_cast<const char*>(triangle.data()), sizeof(triangle));
    bytes.append(2, '\0');
  }
  return bytes;
}

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TEST(StlReader, ReadsBinaryFilesWhateverTheirHeaderSays) {
  for (const char* header : {"", "solid of rust", "COLOR="}) {
    const PolygonSoup soup = parse(readStlSoup, binaryStl(2, 2, header));
    EXPECT_EQ(soup.points.size(), 6U);
    EXPECT_EQ(soup.ends, (std::vector<std::size_t>{3, 6}));
    EXPECT_EQ(soup.points[1], Vec3(1, 0, 0));
  }
}

TEST(StlReader, RefusesBinaryFilesOfAnotherSizeThanTheyDeclare) {
  expectRefused(readStlSoup, binaryStl(2, 1), {"file", "byte 80", "2 triangles", "184 bytes", "has 134"});
  expectRefused(readStlSoup, binaryStl(0xffffffffU, 0), {"4294967295 triangles"});
  expectRefused(readStlSoup, std::string(80, '\0'), {"80 bytes", "at least 84"});
  expectRefused(readStlSoup, "abc", {"3 bytes"});
}

TEST(StlReader, ReadsTextInAnySpelling) {
  const std::string solid = "solid vertex facet name\n" + kFacet + "endsolid x\n";
  std::string upper = solid;
  for (char& c : upper) c = static_cast<char>(std::toupper(c));
  std::string macintosh = solid;
  for (char& c : macintosh) c = c == '\n' ? '\r' : c;
  std::string chatty = solid;
  chatty.replace(chatty.find("0 0 1"), 5, "weird");
  chatty.replace(chatty.find("endloop\n"), 8, "endloop foo\n");
  chatty.replace(chatty.find("endfacet\n"), 9, "endfacet bar\n");
  for (const std::string& text :
       {solid, upper, macintosh, chatty, "\n\t " + solid, solid + "solid empty\nendsolid\n"}) {
    const PolygonSoup soup = parse(readStlSoup, text);
    EXPECT_EQ(soup.ends, (std::vector<std::size_t>{3})) << text;
    EXPECT_EQ(soup.points[2], Vec3(0, 1, 0)) << text;
  }
}

TEST(StlReader, SaysWhatIsLeftBehindItsTriangles) {
  const PolygonSoup soup = parse(readStlSoup, binaryStl(2, 2) + std::string(20, 'x'));
  EXPECT_EQ(soup.ends.size(), 2U);
  EXPECT_EQ(soup.bytesLeftOver, 20U);
  EXPECT_EQ(parse(readStlSoup, binaryStl(2, 2)).bytesLeftOver, 0U);
}

constexpr const char* kPlyTriangle =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header";

TEST(PlyMesh, SaysWhatIsLeftBehindItsRows) {
  const std::string text = std::string("ply\nformat ascii 1.0\n") + kPlyTriangle + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(parse(readPlySoup, text + " \n\n").bytesLeftOver, 0U);
  EXPECT_EQ(parse(readPlySoup, text + "3 1 2 0\n").bytesLeftOver, 8U);
}

TEST(PlyMesh, KnowsAnotherLineEndBehindABinaryHeader) {
  std::string body;
  const std::array<float, 9> points{2, 3, 5, 7, 11, 13, 17, 19, 23};
  body.append(reinterpret_cast<const char*>(points.data()), sizeof(points));
  const std::array<std::int32_t, 3> corners{0, 1, 2};
  body += '\x03';
  body.append(reinterpret_cast<const char*>(corners.data()), sizeof(corners));
  for (const char* end : {"\n", "\r\n"}) {
    const PolygonSoup soup =
        parse(readPlySoup, std::string("ply\nformat binary_little_endian 1.0\n") + kPlyTriangle + end + body);
    EXPECT_EQ(soup.points[2], Vec3(17, 19, 23));
    EXPECT_EQ(soup.bytesLeftOver, 0U);
  }
}

// The area of a polygon's triangles, all of which turn as it does.
double areaOf(const std::vector<Vec3>& points) {
  std::vector<std::uint32_t> polygon(points.size());
  std::iota(polygon.begin(), polygon.end(), 0U);
  std::vector<Triangle> triangles;
  triangulatePolygon(points, polygon, triangles);
  EXPECT_EQ(triangles.size(), points.size() - 2);
  double area = 0.0;
  for (const Triangle& t : triangles)
    area += 0.5 * std::abs((points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).z());
  return area;
}

TEST(TriangulatePolygon, CutsCombsAndStarsOfAnyNumberOfCorners) {
  for (const int teeth : {3, 40, 1500}) {
    std::vector<Vec3> comb{{0, 0, 0}, {2.0 * teeth, 0, 0}};
    for (int i = teeth; i-- > 0;) {
      comb.emplace_back(2.0 * i + 2.0, 5, 0);
      comb.emplace_back(2.0 * i + 1.0, 5, 0);
      comb.emplace_back(2.0 * i + 1.0, 1, 0);
      comb.emplace_back(2.0 * i, 1, 0);
    }
    EXPECT_NEAR(areaOf(comb), 2.0 * teeth + 4.0 * teeth, 1e-9 * teeth);
    std::vector<Vec3> star;
    for (int i = 0; i < 2 * teeth; ++i) {
      const double angle = kPi * i / teeth;
      const double radius = i % 2 == 0 ? 2.0 : 1.0;
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    EXPECT_NEAR(areaOf(star), teeth * 2.0 * std::sin(kPi / teeth), 1e-9 * teeth);
  }
}

TEST(StlReader, RefusesTextThatEndsEarly) {
  const std::string solid = "solid a\n" + kFacet;
  expectRefused(readStlSoup, solid, {"endsolid", "truncated"});
  expectRefused(readStlSoup, solid.substr(0, solid.size() - 10), {"the file ends", "endfacet"});
  expectRefused(readStlSoup, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
                {"line 5", "the file ends", "endloop"});
}

TEST(StlReader, MarksCoordinatesThatAreNoNumbers) {
  std::string text = "solid a\n" + kFacet + "endsolid\n";
  text.replace(text.find("vertex 1 0 0"), 12, "vertex 1 zero 0");
  EXPECT_TRUE(std::isnan(parse(readStlSoup, text).points[1].y()));
}

TEST(OffReader, ReadsPrefixesCommentsColoursAndCountsOnTheKeywordsLine) {
  const std::string rows = "0 0 0 # here\n\n1 0 0 255 0 0\n# between\n0 1 0\n3 0 1 2 0.5 0.5 0.5\n";
  for (const std::string start : {"OFF\n3 1 0\n", "COFF 3 1 3\n", "OFF3 1\n", "\n  STCNOFF # x\n# y\n3 1 0\n"}) {
    const PolygonSoup soup = parse(readOffSoup, start + rows);
    EXPECT_EQ(soup.points.size(), 3U) << start;
    EXPECT_EQ(soup.corners, (std::vector<std::uint32_t>{0, 1, 2})) << start;
  }
}

TEST(OffReader, RefusesWrongKeywordsCountsAndMissingRows) {
  expectRefused(readOffSoup, "OOF\n3 1 0\n", {"line 1", "'OOF'", "OFF"});
  expectRefused(readOffSoup, "OFF BINARY\n", {"binary OFF"});
  expectRefused(readOffSoup, "OFF\n3 x 0\n", {"line 2", "'x'", "faces"});
  expectRefused(readOffSoup, "OFF\n353535235358 6 0\n0 0 0\n", {"353535235358", "bytes can hold"});
  expectRefused(readOffSoup, "OFF\n1 99999999 0\n0 0 0\n", {"99999999"});
  expectRefused(readOffSoup, "OFF\n2 1 0\n0 0 0\n1 0\n3 0 1 1\n", {"line 4", "vertex 1 of 2", "2 coordinates"});
  expectRefused(readOffSoup, "OFF\n1 2 0\n0 0 0\n3 0 0 0\n", {"face 1 of 2", "missing"});
  expectRefused(readOffSoup, "OFF\n1 1 0\n0 0 0\n3 0 0\n", {"line 4", "2 corners", "expected 3"});
}

TEST(OffReader, MarksCornersThatDoNotExist) {
  const PolygonSoup soup = parse(readOffSoup, "OFF\n1 1 0\n0 0 0\n3 0 7 -1\n");
  EXPECT_EQ(soup.corners, (std::vector<std::uint32_t>{0, kNoIndex, kNoIndex}));
}

TEST(ObjReader, ReadsEveryFormOfCornerAndRelativeIndices) {
  const std::string points = "v 0 0 0 1\nv +1 0 0\nv 0 1. 0\n";
  for (const char* face : {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f -3 -2 -1",
                           "f 1// 2// 3// # x", "f 1 2 \\\n 3"}) {
    const PolygonSoup soup = parse(readObjSoup, points + "vt 0 0\nvn 0 0 1\ng f 1 2\n" + face);
    EXPECT_EQ(soup.corners, (std::vector<std::uint32_t>{0, 1, 2})) << face;
    EXPECT_EQ(soup.points[2], Vec3(0, 1, 0));
  }
}

TEST(ObjReader, ReadsFacesBeforeTheirVertices) {
  EXPECT_EQ(parse(readObjSoup, "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").corners, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(ObjReader, ReadsTextInUtf16) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const bool big : {true, false}) {
    std::string wide = big ? "\xfe\xff" : "\xff\xfe";
    for (const char c : text) wide += big ? std::string{'\0', c} : std::string{c, '\0'};
    EXPECT_EQ(parse(readObjSoup, wide).corners, (std::vector<std::uint32_t>{0, 1, 2}));
  }
}

TEST(ObjReader, MarksFacesWithReferencesToNothing) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  auto isMarked = [&](const std::string& rest) {
    const PolygonSoup soup = parse(readObjSoup, points + rest);
    return std::any_of(soup.corners.begin(), soup.corners.end(),
                       [&](std::uint32_t c) { return c >= soup.points.size(); });
  };
  EXPECT_TRUE(isMarked("f 1 2 9\n"));
  EXPECT_TRUE(isMarked("f 1 2 -4\n"));
  EXPECT_TRUE(isMarked("vn 0 0 1\nf 1//2 2//2 3//2\n"));
  EXPECT_TRUE(isMarked("vt 0 0\nf 1/-2 2/1 3/1\n"));
  EXPECT_FALSE(isMarked("f 1/5/6 2/5/6 3/5/6\n")) << "left out altogether, which is common";
}

TEST(ObjReader, RefusesFacesThatAreNone) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expectRefused(readObjSoup, points + "f 0 1 2\n", {"line 4", "'0'"});
  expectRefused(readObjSoup, points + "f 1 2 x\n", {"line 4", "'x'"});
  expectRefused(readObjSoup, points + "f 1/1 2/1 3\n", {"line 4", "'3'", "same for all"});
  expectRefused(readObjSoup, points + "f 1 2\n", {"line 4", "2 corners"});
  expectRefused(readObjSoup, points + "f\n", {"line 4", "0 corners"});
  expectRefused(readObjSoup, "v 1 2\n", {"line 1", "2 coordinates"});
  expectRefused(readObjSoup, std::string("v 0 0 0\n\0", 9), {"byte 8", "text of an OBJ"});
}

TEST(PlySoup, KeepsPolygonsAndMarksIndicesOutOfRange) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 2\nproperty list uchar int vertex_index\nproperty uchar red\nend_header\n";
  const PolygonSoup soup = parse(readPlySoup, header + "0 0 0\n1 0 0\n0 1 0\n4 0 1 2 1 255\n3 0 -1 3 0\n");
  EXPECT_EQ(soup.corners, (std::vector<std::uint32_t>{0, 1, 2, 1, 0, kNoIndex, kNoIndex}));
  EXPECT_EQ(soup.ends, (std::vector<std::size_t>{4, 7}));
}

TEST(PlySoup, CutsTriangleStrips) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
  const PolygonSoup soup = parse(readPlySoup, header + "9 0 1 2 3 -1 4 3 2 9\n");
  EXPECT_EQ(soup.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 4, 3, 2, 2, 3, kNoIndex}));
  EXPECT_EQ(soup.ends.size(), 4U);
}

TEST(PlySoup, RefusesFilesWithoutCoordinatesOrWithoutCorners) {
  expectRefused(readPlySoup,
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
                {"x, y and z"});
  expectRefused(readPlySoup,
                "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1 2\n",
                {"'vertex'"});
  expectRefused(readPlySoup,
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                "element face 1\nproperty int view\nend_header\n0 0 0\n1\n",
                {"'face'", "vertex_indices"});
}

}  // namespace
}  // namespace vantage
