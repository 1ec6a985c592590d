#include "io/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "core/io/expect_error.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

constexpr const char* kMesh =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
constexpr const char* kRange =
    "ply\nformat ascii 1.0\nobj_info num_cols 1\nobj_info num_rows 1\nelement vertex 1\nproperty float x\n"
    "property float y\nproperty float z\nelement range_grid 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0\n";

TEST(OutputFile, GoesWhereNothingIs) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(checkOutput(folder.file("new.ply"), OutputKind::Mesh));
  EXPECT_NO_THROW(checkOutput(folder.write("empty.ply", ""), OutputKind::Mesh));
}

TEST(OutputFile, ReplacesOneOfItsKind) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(checkOutput(folder.write("m.ply", kMesh), OutputKind::Mesh));
  EXPECT_NO_THROW(checkOutput(folder.write("r.html", "<!DOCTYPE html>\n<html></html>"), OutputKind::Report));
  EXPECT_NO_THROW(checkOutput(folder.write("p.png", "\x89PNG\r\n"), OutputKind::Picture));
  EXPECT_NO_THROW(checkOutput(folder.write("o.json", "{ \"max_views\": 3 }"), OutputKind::Json));
}

TEST(OutputFile, LeavesWhatIsOfAnotherKind) {
  const TemporaryFolder folder;
  const std::string range = folder.write("scan.ply", kRange);
  expectError<InvalidInput>([&] { checkOutput(range, OutputKind::Mesh); }, {range, "no mesh", "not replaced"});
  const std::string cloud = folder.write("scan.ptx", "2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  expectError<InvalidInput>([&] { checkOutput(cloud, OutputKind::Mesh); }, {cloud, "no mesh"});
  expectError<InvalidInput>([&] { checkOutput(folder.write("letter.html", "Dear Sir"), OutputKind::Report); },
                            {"letter.html", "no HTML page"});
  expectError<InvalidInput>([&] { checkOutput(folder.write("photo.png", "\xff\xd8\xff"), OutputKind::Picture); },
                            {"photo.png", "no PNG picture"});
  const std::string session = folder.write("s.vantage", std::string("SQLite format 3\0", 16) + std::string(100, 'x'));
  for (const OutputKind kind : {OutputKind::Mesh, OutputKind::Report, OutputKind::Picture, OutputKind::Json})
    EXPECT_THROW(checkOutput(session, kind), InvalidInput);
}

TEST(OutputFile, LeavesInputsByWhateverName) {
  const TemporaryFolder folder;
  const std::string mesh = folder.write("m.ply", kMesh);
  const std::string link = folder.file("link.ply");
  std::filesystem::create_symlink(mesh, link);
  expectError<InvalidInput>(
      [&] {
        checkOutput(link, OutputKind::Mesh, std::vector{folder.file("gone"), mesh});
      },
      {link, "is read by this command"});
  EXPECT_NO_THROW(checkOutput(link, OutputKind::Mesh));
}

TEST(OutputFile, IsARegularFile) {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe.ply");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expectError<InvalidInput>([&] { checkOutput(pipe, OutputKind::Mesh); }, {pipe, "no regular file"});
  EXPECT_THROW(checkOutput("/dev/null", OutputKind::Report), InvalidInput);
  EXPECT_THROW(checkOutput(folder.file("."), OutputKind::Mesh), InvalidInput);
}

}  // namespace
}  // namespace vantage
