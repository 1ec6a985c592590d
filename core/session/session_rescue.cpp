#include "session/session_rescue.h"

#include <filesystem>

#include "base/errors.h"
#include "session/session_schema.h"

namespace vantage {
namespace {

// Copies a table from one end until a page cannot be read. @return whether it came to the other end
bool copyFrom(Database& damaged, Database& copy, const std::string& table, const char* order) {
  try {
    Statement rows = damaged.prepare("SELECT * FROM " + table + " ORDER BY " + keyOf(table) + " " + order);
    std::string places = "?";
    for (int i = 1; i < rows.columns(); ++i) places += ", ?";
    while (rows.step()) copy.prepare("INSERT OR IGNORE INTO " + table + " VALUES(" + places + ")").bindRow(rows).run();
    return true;
  } catch (const IoError&) {
    return false;
  }
}

void copyFile(const std::string& from, const std::string& to) {
  std::error_code error;
  std::filesystem::copy_file(from, to, error);
  if (error)
    throw IoError(to, "the damaged session cannot be copied here, so it is not opened for writing: " + error.message());
}

}  // namespace

std::vector<Loss> rescueRows(Database& damaged, Database& copy) {
  std::vector<Loss> losses;
  Database::Transaction transaction(copy);
  const int version = checkSessionTables(damaged);
  createSessionTables(copy, version);
  for (const std::string& table : sessionTables(version)) {
    if (copyFrom(damaged, copy, table, "ASC")) continue;
    static_cast<void>(copyFrom(damaged, copy, table, "DESC"));
    Statement count = copy.prepare("SELECT count(*) FROM " + table);
    count.step();
    losses.push_back({LossKind::TableDamaged, count.integer(0), table, {}});
  }
  transaction.commit();
  return losses;
}

std::string freeName(const std::string& path, const std::string& ending) {
  int number = 1;
  while (std::filesystem::exists(path + ending + "-" + std::to_string(number))) ++number;
  return path + ending + "-" + std::to_string(number);
}

std::string copyBeside(const std::string& session) {
  std::string copy = freeName(session, ".damaged");
  copyFile(session, copy);
  if (std::filesystem::exists(session + "-wal")) copyFile(session + "-wal", copy + "-wal");
  return copy;
}

std::vector<Loss> rescueInPlace(const std::string& session) {
  const std::string rescued = freeName(session, ".rescued");
  std::vector<Loss> losses;
  {
    Database damaged(session, Database::Mode::Read);
    Database copy(rescued, Database::Mode::Create);
    losses = rescueRows(damaged, copy);
  }
  std::error_code error;
  for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(session + suffix, error);
  std::filesystem::rename(rescued, session, error);
  if (error) throw IoError(session, "cannot be replaced by what could be read of it: " + error.message());
  return losses;
}

}  // namespace vantage
