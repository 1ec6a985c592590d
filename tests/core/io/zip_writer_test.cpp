#include "io/zip_writer.h"

#include <gtest/gtest.h>

#include <string>

#include "io/file_bytes.h"
#include "io/zip_archive.h"
#include "support/test_data.h"

namespace vantage {
namespace {

TEST(ZipWriter, WhatIsPackedComesBack) {
  const testing::TemporaryFolder folder;
  std::string large;
  for (int i = 0; i < 100'000; ++i) large += std::to_string(i * 7919 % 10'007) + "\n";
  {
    AtomicFile file(folder.file("a.zip"));
    ZipWriter zip(file);
    PackedMember empty("empty");
    zip.add(std::move(empty));
    PackedMember text("folder/text");
    text.write("one ");
    text.write("two");
    zip.add(std::move(text));
    PackedMember pieces("large");
    for (std::size_t at = 0; at < large.size(); at += 1000) pieces.write(std::string_view(large).substr(at, 1000));
    zip.add(std::move(pieces));
    zip.finish();
    file.commit();
  }
  const FileBytes bytes(folder.file("a.zip"));
  EXPECT_TRUE(looksLikeZip(bytes.text()));
  const ZipArchive archive(bytes, 1U << 24);
  ASSERT_EQ(archive.members().size(), 3U);
  EXPECT_EQ(archive.unpack(*archive.find("empty")), "");
  EXPECT_EQ(archive.unpack(*archive.find("folder/text")), "one two");
  EXPECT_EQ(archive.unpack(*archive.find("large")), large);
  EXPECT_LT(bytes.size(), large.size() / 2);
}

}  // namespace
}  // namespace vantage
