#include "base/atomic_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/errors.h"
#include "core/io/expect_error.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::filesBelow;
using testing::TemporaryFolder;

std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const TemporaryFolder folder;
  AtomicFile file(folder.file("a"));
  file.write("hello ");
  std::memcpy(file.grow(5), "world", 5);
  EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
  file.commit();
  EXPECT_EQ(contentOf(folder.file("a")), "hello world");
  EXPECT_EQ(filesBelow(folder.file(".")).size(), 1U);
}

TEST(AtomicFile, KeepsWhatWasThereWhenItIsNotCommitted) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a", "before");
  { AtomicFile(path).write(std::string(1 << 20, 'x')); }
  EXPECT_EQ(contentOf(path), "before");
  EXPECT_EQ(filesBelow(folder.file(".")).size(), 1U);
}

TEST(AtomicFile, ALinkStaysAndWhatItNamesIsWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a", "before");
  const std::string link = folder.file("link");
  std::filesystem::create_symlink(path, link);
  AtomicFile file(link);
  file.write("after");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(contentOf(path), "after");
}

TEST(AtomicFile, ReplacesWhatWasThere) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a", "before");
  AtomicFile file(path);
  const std::string large(3 << 20, 'y');
  file.write(large);
  file.commit();
  EXPECT_EQ(contentOf(path), large);
}

TEST(AtomicFile, AsANewFileTakesNobodysPlace) {
  const TemporaryFolder folder;
  const auto put = [&](const char* text) {
    AtomicFile file(folder.file("a"));
    file.write(text);
    return file.commitNew();
  };
  EXPECT_TRUE(put("first"));
  EXPECT_FALSE(put("second"));
  EXPECT_EQ(contentOf(folder.file("a")), "first");
  EXPECT_EQ(filesBelow(folder.file(".")).size(), 1U);
}

TEST(AtomicFile, SaysWhyItCannotWrite) {
  const TemporaryFolder folder;
  expectError<IoError>([&] { AtomicFile(folder.file("missing/a")); }, {"missing/a", "cannot be opened for writing"});
  expectError<IoError>([&] { AtomicFile(folder.file(".")); }, {"is a folder"});
  expectError<IoError>(
      [] {
        AtomicFile full("/dev/full");
        full.write("x");
        full.commit();
      },
      {"/dev/full", "No space left"});
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")) << "a device was replaced by a file";
}

}  // namespace
}  // namespace vantage
