#include <cstring>
#include <limits>

#include "core/io/expect_error.h"
#include "geometry/mesh.h"
#include "io/file_info.h"
#include "io/grid_file.h"
#include "io/lzf.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

GridFile read(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  return readGridFile(folder.write(name, bytes));
}

void refuse(const std::string& name, const std::string& bytes, const std::vector<std::string>& parts) {
  expectError<InvalidInput>([&] { static_cast<void>(read(name, bytes)); }, parts);
}

template <typename T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string pcdHeader(const std::string& data, const std::string& viewpoint = "0 0 0 1 0 0 0") {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y rgb z\nSIZE 4 4 4 8\nTYPE F F U F\n"
         "COUNT 1 1 2 1\nWIDTH 3\nHEIGHT 2\nVIEWPOINT " +
         viewpoint + "\nPOINTS 6\nDATA " + data + "\n";
}

// Point i is (i, 10 i, 0.5 i) but for the second, which is none.
float valueOf(std::size_t i, float factor) {
  return i == 1 ? std::numeric_limits<float>::quiet_NaN() : factor * static_cast<float>(i);
}

void expectPoints(const GridFile& file) {
  const SampleGrid& grid = file.samples;
  ASSERT_EQ(grid.rows, 2);
  ASSERT_EQ(grid.columns, 3);
  ASSERT_EQ(grid.points.size(), 5U);
  for (std::size_t i = 0; i < 6; ++i) {
    ASSERT_EQ(grid.cell[i] == kNoIndex, i == 1);
    if (i != 1) {
      EXPECT_EQ(grid.points[grid.cell[i]], Vec3(1, 10, 0.5) * static_cast<double>(i));
    }
  }
}

std::string asciiPcd() {
  std::string text = pcdHeader("ascii");
  for (int i = 0; i < 6; ++i)
    text += i == 1 ? std::string("nan nan 1 2 nan\n")
                   : std::to_string(i) + " " + std::to_string(10 * i) + " 1 2 " + std::to_string(0.5 * i) + "\n";
  return text;
}

std::string binaryPcd() {
  std::string bytes = pcdHeader("binary");
  for (std::size_t i = 0; i < 6; ++i) {
    put(bytes, valueOf(i, 1.0F));
    put(bytes, valueOf(i, 10.0F));
    put<std::uint64_t>(bytes, 7);
    put(bytes, static_cast<double>(valueOf(i, 0.5F)));
  }
  return bytes;
}

// Fields one after the other, packed as runs of at most 32 literal bytes.
std::string compressedPcd() {
  std::string plain;
  for (std::size_t i = 0; i < 6; ++i) put(plain, valueOf(i, 1.0F));
  for (std::size_t i = 0; i < 6; ++i) put(plain, valueOf(i, 10.0F));
  for (std::size_t i = 0; i < 6; ++i) put<std::uint64_t>(plain, 7);
  for (std::size_t i = 0; i < 6; ++i) put(plain, static_cast<double>(valueOf(i, 0.5F)));
  std::string packed;
  for (std::size_t at = 0; at < plain.size(); at += 32) {
    const std::string run = plain.substr(at, 32);
    packed += static_cast<char>(run.size() - 1);
    packed += run;
  }
  std::string bytes = pcdHeader("binary_compressed");
  put(bytes, static_cast<std::uint32_t>(packed.size()));
  put(bytes, static_cast<std::uint32_t>(plain.size()));
  return bytes + packed;
}

TEST(PcdReader, ReadsOrganisedFilesOfAllThreeKinds) {
  expectPoints(read("a.pcd", asciiPcd()));
  expectPoints(read("a.pcd", binaryPcd()));
  expectPoints(read("a.pcd", compressedPcd()));
  EXPECT_TRUE(read("a.pcd", asciiPcd()).inMetres);
  EXPECT_FALSE(read("a.pcd", asciiPcd()).T_world_scanner);
}

TEST(PcdReader, TakesTheViewpointForTheScanner) {
  std::string text = asciiPcd();
  text.replace(text.find("VIEWPOINT 0 0 0 1 0 0 0"), 23, "VIEWPOINT 1 2 3 0 1 0 0");
  const auto pose = read("a.pcd", text).T_world_scanner;
  ASSERT_TRUE(pose);
  EXPECT_TRUE((*pose * Vec3(1, 1, 1)).isApprox(Vec3(2, 1, 2)));
}

TEST(PcdReader, RefusesWhatIsNoGridByName) {
  std::string text = asciiPcd();
  text.replace(text.find("WIDTH 3"), 7, "WIDTH 6").replace(text.find("HEIGHT 2"), 8, "HEIGHT 1");
  refuse("a.pcd", text, {"a.pcd", "PCD", "without rows and columns"});
}

TEST(PcdReader, RefusesDamageInOneSentence) {
  const auto changed = [](std::string text, const std::string& what, const std::string& to) {
    return text.replace(text.find(what), what.size(), to);
  };
  refuse("a.pcd", changed(asciiPcd(), "DATA ascii\n", ""), {"no line DATA"});
  refuse("a.pcd", changed(asciiPcd(), "DATA ascii", "DATA zip"), {"'zip'"});
  refuse("a.pcd", changed(asciiPcd(), "POINTS 6", "POINTS 7"), {"POINTS is 7"});
  refuse("a.pcd", changed(asciiPcd(), "WIDTH 3", "WIDTH 9999999999"), {"'9999999999'"});
  refuse("a.pcd", changed(asciiPcd(), "FIELDS x y rgb z", "FIELDS x y rgb w"), {"no field 'z'"});
  refuse("a.pcd", changed(asciiPcd(), "TYPE F F", "TYPE F I"), {"'y'"});
  refuse("a.pcd", changed(asciiPcd(), "VIEWPOINT 0 0 0 1", "VIEWPOINT 0 0 0 9"), {"quaternion"});
  refuse("a.pcd", changed(asciiPcd(), "20", "2x0"), {"line 14", "'2x0'"});
  refuse("a.pcd", asciiPcd().substr(0, asciiPcd().size() - 20), {"ends within point 5"});
  refuse("a.pcd", binaryPcd().substr(0, binaryPcd().size() - 1), {"truncated"});
  refuse("a.pcd", compressedPcd().substr(0, compressedPcd().size() - 1), {"packed"});
  std::string broken = compressedPcd();
  broken[broken.find("binary_compressed\n") + 18 + 8] = '\x1f';
  broken[broken.find("binary_compressed\n") + 18 + 8 + 33] = '\xff';
  refuse("a.pcd", broken, {"damaged"});
}

TEST(Lzf, CopiesWhatWasWrittenBefore) {
  // "abc", then 7 bytes from 3 back.
  const std::string packed{'\x02', 'a', 'b', 'c', '\xa0', '\x02'};
  EXPECT_EQ(unpackLzf(packed, 10, "it"), "abcabcabca");
  expectError<InvalidInput>([&] { static_cast<void>(unpackLzf(packed, 9, "it")); }, {"it is damaged"});
  expectError<InvalidInput>([&] { static_cast<void>(unpackLzf(packed, 1U << 30U, "it")); }, {"it is damaged"});
}

std::string ptx(const std::string& sizes, const std::string& matrix, const std::string& points) {
  return sizes + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + matrix + points;
}
constexpr const char* kMatrix = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n600000.5 800000 400 1\n";
constexpr const char* kPoints = "1 1 1 0.5\n1 1 2 0.5\n2 1 1 0.5 9 9 9\n0 0 0 0.5\n3 1 1\n3 1 2\n";

TEST(PtxReader, ReadsColumnsAndThePlaceOfTheScanner) {
  const GridFile file = read("a.ptx", ptx("3\n2\n", kMatrix, kPoints));
  EXPECT_EQ(file.samples.rows, 2);
  EXPECT_EQ(file.samples.columns, 3);
  EXPECT_EQ(file.samples.points.size(), 5U);
  EXPECT_EQ(file.samples.points[file.samples.cell[0]], Vec3(1, 1, 1));
  EXPECT_EQ(file.samples.points[file.samples.cell[3]], Vec3(1, 1, 2));
  EXPECT_EQ(file.samples.points[file.samples.cell[1]], Vec3(2, 1, 1));
  EXPECT_EQ(file.samples.cell[4], kNoIndex);
  ASSERT_TRUE(file.T_world_scanner);
  EXPECT_TRUE((*file.T_world_scanner * Vec3(1, 0, 0)).isApprox(Vec3(600000.5, 800001, 400)));
}

TEST(PtxReader, RefusesWhatItCannotPlace) {
  refuse("a.ptx", ptx("3\n2\n", "0 1 0 0\n1 0 0 0\n0 0 1 0\n0 0 0 1\n", kPoints), {"left-handed"});
  refuse("a.ptx", ptx("3\n2\n", "0 2 0 0\n1 0 0 0\n0 0 1 0\n0 0 0 1\n", kPoints), {"no rotation"});
  refuse("a.ptx", ptx("3\n2\n", kMatrix, std::string(kPoints) + "2\n2\n0 0 0\n"), {"one scan in a file"});
  refuse("a.ptx", ptx("3\n2\n", kMatrix, "1 1 1\n"), {"the file ends"});
  refuse("a.ptx", ptx("999999\n999999\n", kMatrix, kPoints), {"too short"});
}

TEST(GridFile, RefusesOtherKindsByName) {
  refuse("a.xyz", "0 0 1\n0 1 1\n", {"a.xyz", "XYZ", "rows and columns"});
  refuse("a.pts", "2\n0 0 1\n0 1 1\n", {"XYZ"});
  refuse("a.csv", "0,0,1\n0,1,1\n", {"XYZ"});
  refuse("a.las", "LASF....", {"LAS"});
  refuse("a.stl", "solid a\nendsolid a\n", {"mesh", "range file"});
  refuse("a.conf", "bmesh a 0 0 0 0 0 0 1\n", {"no samples"});
}

TEST(GridFile, NamesAByteOrderMarkBeforeAPlyHeader) {
  const std::string text =
      "\xef\xbb\xbfply\nformat ascii 1.0\nobj_info num_cols 2\nobj_info num_rows 2\nelement vertex 4\nproperty float "
      "x\nproperty float y\nproperty float z\nend_header\n0 0 1\n1 0 1\n0 1 1\nnan nan nan\n";
  refuse("a.ply", text, {"a.ply", "byte order mark"});
  EXPECT_EQ(read("a.ply", text.substr(3)).samples.points.size(), 3U);
}

TEST(DescribeFile, TellsOrganisedPointsFromOthers) {
  const TemporaryFolder folder;
  const FileInfo pcd = describeFile(folder.write("a.pcd", asciiPcd()));
  EXPECT_EQ(pcd.content, FileContent::RangeImage);
  EXPECT_EQ(toText(pcd.at("rows")), "2");
  EXPECT_EQ(toText(pcd.at("samples")), "5");
}

}  // namespace
}  // namespace vantage
