#include "io/ply_document.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/io/expect_error.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

constexpr std::array<PlySelection, 3> kSome{{{"vertex", "x"}, {"vertex", "tag"}, {"face", "vertex_indices"}}};

PlyDocument read(const std::string& bytes) {
  const TemporaryFolder folder;
  return readPlyDocument(FileBytes(folder.write("a.ply", bytes)), kSome);
}

void expectRefused(const std::string& bytes, const std::vector<std::string>& parts) {
  expectError<InvalidInput>([&] { static_cast<void>(read(bytes)); }, parts);
}

template <typename T>
std::string bytesOf(std::initializer_list<T> values, bool swapped = false) {
  std::string bytes;
  for (const T value : values) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    if (swapped) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
  }
  return bytes;
}

const std::string kElements =
    "element vertex 2\nproperty float x\nproperty short tag\n"
    "element face 1\nproperty list uchar ushort vertex_indices\nend_header\n";

void expectContent(const PlyDocument& document) {
  EXPECT_EQ(document.find("vertex", "x")->values, (std::vector<double>{1.5, -2.0}));
  EXPECT_EQ(document.find("vertex", "tag")->values, (std::vector<double>{-3.0, 300.0}));
  EXPECT_EQ(document.find("face", "vertex_indices")->values, (std::vector<double>{0.0, 1.0, 40000.0}));
  EXPECT_EQ(document.find("face", "vertex_indices")->start, (std::vector<std::size_t>{0, 3}));
}

TEST(PlyDocument, ReadsTheSameValuesFromTextAndFromEitherByteOrder) {
  expectContent(read("ply\nformat ascii 1.0\n" + kElements + "1.5 -3\n-2 300\n3 0 1 40000\n"));
  for (const bool big : {false, true}) {
    const std::string body = bytesOf<float>({1.5F}, big) + bytesOf<std::int16_t>({-3}, big) +
                             bytesOf<float>({-2.0F}, big) + bytesOf<std::int16_t>({300}, big) +
                             bytesOf<std::uint8_t>({3}) + bytesOf<std::uint16_t>({0, 1, 40000}, big);
    expectContent(
        read(std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + kElements + body));
  }
}

TEST(PlyDocument, AcceptsLinesThatEndInAnyWayAndABodyThatBeginsWithALineEnd) {
  std::string crlf =
      "ply\nformat ascii 1.0\ncomment a\nobj_info num_cols 7\n" + kElements + "1.5 -3\n-2 300\n3 0 1 40000\n";
  for (std::size_t i = 0; (i = crlf.find('\n', i)) != std::string::npos; i += 2) crlf.replace(i, 1, "\r\n");
  expectContent(read(crlf));
  EXPECT_EQ(read(crlf).header().info("num_cols"), "7");
  ASSERT_EQ(read(crlf).header().comments.size(), 1U);
  EXPECT_EQ(read(crlf).header().comments.front(), "a");

  const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty int x\nend_header\n";
  EXPECT_EQ(read(header + bytesOf<std::int32_t>({0x0d0a})).find("vertex", "x")->values, (std::vector<double>{0x0d0a}));
}

TEST(PlyDocument, FindsOnlyWhatWasSelected) {
  const PlyDocument document =
      read("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n");
  EXPECT_NE(document.find("vertex", "x"), nullptr);
  EXPECT_EQ(document.find("vertex", "y"), nullptr);
  EXPECT_EQ(document.find("face", "vertex_indices"), nullptr);
}

TEST(PlyHeader, RefusesEveryBrokenHeaderByLine) {
  const std::string start = "ply\nformat ascii 1.0\n";
  const std::string vertex = start + "element vertex 1\nproperty float x\n";
  expectRefused("plx\n", {"line 1", "'plx'", "expected 'ply'"});
  expectRefused("ply\nelement vertex 0\nproperty float x\nend_header\n", {"no 'format'"});
  expectRefused("ply\nformat text 1.0\n", {"line 2", "'text'"});
  expectRefused("ply\nformat ascii 2.0\n", {"line 2", "'2.0'"});
  expectRefused(start + "format ascii 1.0\n", {"line 3", "twice"});
  expectRefused(start + "element vertex -1\n", {"line 3", "'-1'"});
  expectRefused(start + "element vertex 0x10\n", {"line 3", "'0x10'"});
  expectRefused(start + "element vertex\n", {"line 3", "COUNT"});
  expectRefused(start + "element vertex 1 2\n", {"line 3", "'2'"});
  expectRefused(start + "property float x\n", {"line 3", "before any element"});
  expectRefused(start + "bye\n", {"line 3", "'bye'"});
  expectRefused(start + "end_header\n", {"no 'element'"});
  expectRefused(vertex + "property float x\nend_header\n1 1\n", {"line 5", "'x'", "twice"});
  expectRefused(vertex + "element vertex 1\n", {"line 5", "'vertex'", "twice"});
  expectRefused(vertex + "property half y\n", {"line 5", "'half'"});
  expectRefused(vertex + "property list float int y\n", {"line 5", "floating point"});
  expectRefused(vertex + "property float\n", {"line 5", "no name"});
  expectRefused(vertex, {"does not end"});
}

TEST(PlyHeader, RefusesCountsThatTheFileCannotHold) {
  const std::string rows = "property float x\nend_header\n1\n";
  expectRefused("ply\nformat ascii 1.0\nelement vertex 4294967295\n" + rows, {"4294967295", "truncated"});
  expectRefused("ply\nformat ascii 1.0\nelement vertex 99999999999999\n" + rows, {"99999999999999"});
  expectRefused("ply\nformat binary_little_endian 1.0\nelement vertex 2\n" + rows,
                {"2 rows", "4 bytes a row", "only 2"});
  expectRefused("ply\nformat ascii 1.0\nelement vertex 5\nend_header\n", {"no properties"});
}

TEST(PlyHeader, RefusesAHeaderThatGoesOnForever) {
  expectRefused("ply\nformat ascii 1.0\ncomment " + std::string(2U << 20, 'x'), {"megabyte"});
}

TEST(PlyDocument, RefusesDamagedRowsByPlace) {
  const std::string ascii = "ply\nformat ascii 1.0\n" + kElements;
  expectRefused(ascii + "1.5 -3\nx 300\n3 0 1 2\n", {"a.ply", "line 10", "'x'", "'vertex'"});
  expectRefused(ascii + "1.5 -3\n2 70000\n3 0 1 2\n", {"line 10", "'70000'"});
  expectRefused(ascii + "1.5 -3\n2 3\n3 0 1\n", {"the file ends", "row 0", "'face'"});
  expectRefused(ascii + "1.5 -3\n2 3\n200 0 1\n", {"list of 200", "longer than the file"});
  const std::string list = "element face 1\nproperty list char int vertex_indices\nend_header\n";
  expectRefused("ply\nformat ascii 1.0\n" + list + "-1 0\n", {"negative length"});
  expectRefused("ply\nformat binary_little_endian 1.0\n" + list + "\x03" + bytesOf<std::int32_t>({1, 2}),
                {"byte", "ends within row 0", "'face'"});
  expectRefused(
      "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint int vertex_indices\nend_header\n" +
          bytesOf<std::uint32_t>({0xffffffffU, 1}),
      {"ends within row 0"});
}

TEST(PlyDocument, StopsWhenAsked) {
  const TemporaryFolder folder;
  const FileBytes file(folder.write("a.ply", "ply\nformat ascii 1.0\n" + kElements + "1.5 -3\n-2 300\n3 0 1 40000\n"));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(static_cast<void>(readPlyDocument(file, kSome, Progress({}, stop.get_token(), 1))), Cancelled);
}

}  // namespace
}  // namespace vantage
