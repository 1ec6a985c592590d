#include "session/session_rescue.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "earlier_versions.h"
#include "session/session_schema.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::bytesOf;

// A session of which nothing but one page of its largest table is damaged.
std::string withDamagedModel(const testing::TemporaryFolder& folder) {
  constexpr std::size_t kPage = 1024;
  const std::string path = folder.write("bad.vantage", bytesOf(testing::earlierSession("schema_2_ended")));
  std::int64_t page = 0;
  {
    Database database(path, Database::Mode::Read);
    Statement row = database.prepare("SELECT rootpage FROM sqlite_master WHERE name = 'model'");
    EXPECT_TRUE(row.step());
    page = row.integer(0);
  }
  std::string bytes = bytesOf(path);
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>((page - 1) * kPage), kPage, '\x2a');
  return folder.write("bad.vantage", bytes);
}

std::int64_t countIn(Database& database, const std::string& table) {
  Statement row = database.prepare("SELECT count(*) FROM " + table);
  return row.step() ? row.integer(0) : -1;
}

TEST(SessionRescue, SavesEveryTableButTheDamagedOneAndNamesIt) {
  const testing::TemporaryFolder folder;
  Database damaged(withDamagedModel(folder), Database::Mode::Read);
  Database copy = Database::inMemory("copy");
  EXPECT_EQ(rescueRows(damaged, copy), (std::vector<Loss>{{LossKind::TableDamaged, 0, "model", {}}}));
  EXPECT_EQ(checkSessionTables(copy), 2);
  Database whole(testing::earlierSession("schema_2_ended"), Database::Mode::Read);
  for (const std::string& table : sessionTables(2)) {
    if (table == "model") continue;
    EXPECT_EQ(countIn(copy, table), countIn(whole, table)) << table;
  }
  EXPECT_EQ(countIn(copy, "model"), 0);
}

TEST(SessionRescue, PutsWhatIsReadableInItsPlace) {
  const testing::TemporaryFolder folder;
  const std::string path = withDamagedModel(folder);
  const std::string before = bytesOf(path);
  EXPECT_EQ(copyBeside(path), path + ".damaged-1");
  EXPECT_EQ(copyBeside(path), path + ".damaged-2");
  EXPECT_EQ(freeName(path, ".damaged"), path + ".damaged-3");
  EXPECT_EQ(rescueInPlace(path).size(), 1U);
  EXPECT_EQ(bytesOf(path + ".damaged-1"), before);
  Database database(path, Database::Mode::Read);
  EXPECT_TRUE(database.sound());
  EXPECT_FALSE(std::filesystem::exists(path + ".rescued-1"));
}

}  // namespace
}  // namespace vantage
