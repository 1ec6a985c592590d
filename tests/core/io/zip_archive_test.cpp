#include "io/zip_archive.h"

#include "core/io/expect_error.h"
#include "core/io/zip_writer.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;
using testing::zipOf;

constexpr std::uintmax_t kLimit = 1U << 20;

TEST(ZipArchive, UnpacksItsMembers) {
  const TemporaryFolder folder;
  const std::string text(100000, 'x');
  const FileBytes file(folder.write("a.zip", zipOf({{"one.txt", "hello"}, {"dir/Two.TXT", text}})));
  const ZipArchive archive(file, kLimit);
  ASSERT_EQ(archive.members().size(), 2U);
  EXPECT_EQ(archive.unpack(archive.members()[0]), "hello");
  EXPECT_EQ(archive.unpack(*archive.find("/DIR/two.txt")), text);
  EXPECT_EQ(archive.find("three"), nullptr);
}

TEST(ZipArchive, RefusesWhatUnpacksToTooMuch) {
  const TemporaryFolder folder;
  const FileBytes honest(
      folder.write("a.zip", zipOf({{"a", std::string(700000, 'x')}, {"b", std::string(700000, 'x')}})));
  expectError<InvalidInput>([&] { ZipArchive(honest, kLimit); }, {"a.zip", "unpacks to 1400000", "at most 1048576"});
  // A member that says it is small, and is not.
  const FileBytes liar(folder.write("b.zip", zipOf({{"a", std::string(700000, 'x')}}, 100)));
  const ZipArchive archive(liar, kLimit);
  expectError<InvalidInput>([&] { static_cast<void>(archive.unpack(archive.members()[0])); },
                            {"b.zip", "'a'", "100 bytes"});
}

TEST(ZipArchive, RefusesDamage) {
  const TemporaryFolder folder;
  const std::string good = zipOf({{"name", "some text that is long enough to be packed, text, text, text"}});
  auto refuse = [&](const std::string& bytes, const std::vector<std::string>& parts) {
    const FileBytes file(folder.write("a.zip", bytes));
    expectError<InvalidInput>(
        [&] {
          const ZipArchive archive(file, kLimit);
          for (const ZipMember& member : archive.members()) static_cast<void>(archive.unpack(member));
        },
        parts);
  };
  refuse(good.substr(0, good.size() - 30), {"a.zip", "directory is missing"});
  std::string bytes = good;
  bytes[good.rfind("PK\x01\x02") + 1] = 'X';
  refuse(bytes, {"directory cannot be read"});
  bytes = good;
  bytes[good.rfind("PK\x01\x02") + 8] = 1;
  refuse(bytes, {"'name'", "encrypted"});
  bytes = good;
  bytes[good.rfind("PK\x01\x02") + 10] = 12;
  refuse(bytes, {"method 12"});
  bytes = good;
  bytes[good.rfind("PK\x01\x02") + 16] ^= 1;
  refuse(bytes, {"checksum"});
  bytes = good;
  bytes[40] ^= 0x55;
  refuse(bytes, {"'name'"});
}

}  // namespace
}  // namespace vantage
