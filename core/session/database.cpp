#include "session/database.h"

#include <sqlite3.h>

#include <cctype>
#include <cstring>
#include <filesystem>
#include <new>
#include <utility>

#include "base/content_hash.h"
#include "base/errors.h"

namespace vantage {
namespace {

// Most of a session are blobs of many pages: fewer and larger ones are written with fewer calls.
constexpr int kPageBytes = 16384;
// The log is moved into the file when it is this long, and at the end.
constexpr int kMaxLogPages = 4096;

// What a code of SQLite means to who works with a session.
std::string meaning(int code, const char* detail) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return "the disk is full; the session is as it was before, go on when there is room";
    case SQLITE_IOERR:
      return std::string("the session cannot be read or written (") + detail +
             "); it is as it was before, go on when that is mended";
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return std::string("the session or its folder cannot be written to (") + detail + ")";
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return std::string("is damaged, or no session (") + detail + ")";
    case SQLITE_INTERRUPT:
      return "is given up: it takes longer to read than any session that this program writes";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program is writing to the session";
    default:
      return std::string("session database: ") + detail;
  }
}

// A file name as SQLite takes it in a URI.
std::string fileUri(const std::string& path) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '/' || c == '.' || c == '-' || c == '_') {
      uri += c;
    } else {
      uri += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return uri;
}

bool hasLog(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path + "-wal", error);
  return !error && size > 0;
}

// SQLite's own instructions between two questions whether to go on: about a millisecond's.
constexpr int kInstructions = 100'000;
// How often a statement goes on: about a second, and more for a large file.
constexpr std::int64_t kPatience = 1000;
constexpr std::int64_t kBytesPerMore = 1000;

int useUp(void* patience) {
  return --*static_cast<std::int64_t*>(patience) < 0 ? 1 : 0;
}

// row_sum(x, ...): a number for values of SQL and their types.
void rowSum(sqlite3_context* context, int count, sqlite3_value** values) {
  ContentHash hash;
  for (int i = 0; i < count; ++i) {
    const int type = sqlite3_value_type(values[i]);
    hash.add(type);
    if (type == SQLITE_INTEGER) {
      hash.add(static_cast<std::int64_t>(sqlite3_value_int64(values[i])));
    } else if (type == SQLITE_FLOAT) {
      hash.add(sqlite3_value_double(values[i]));
    } else if (type != SQLITE_NULL) {
      const auto* bytes = static_cast<const std::byte*>(sqlite3_value_blob(values[i]));
      hash.add(std::span(bytes, static_cast<std::size_t>(sqlite3_value_bytes(values[i]))));
    }
  }
  std::int64_t sum = 0;
  const std::uint64_t value = hash.value();
  std::memcpy(&sum, &value, sizeof sum);
  sqlite3_result_int64(context, sum);
}

}  // namespace

Statement::Statement(sqlite3* database, std::string path, const std::string& sql)
    : database_(database), path_(std::move(path)), statement_(nullptr, &sqlite3_finalize) {
  sqlite3_stmt* statement = nullptr;
  check(sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr));
  statement_.reset(statement);
}

void Statement::check(int code) const {
  if (code == SQLITE_OK || code == SQLITE_ROW || code == SQLITE_DONE) return;
  if (code == SQLITE_NOMEM) throw std::bad_alloc();
  throw IoError(path_, meaning(code, sqlite3_errmsg(database_)));
}

Statement& Statement::bind(int parameter, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), parameter, value));
  return *this;
}

Statement& Statement::bindOptional(int parameter, std::optional<std::int64_t> value) {
  if (value) return bind(parameter, *value);
  check(sqlite3_bind_null(statement_.get(), parameter));
  return *this;
}

Statement& Statement::bind(int parameter, double value) {
  check(sqlite3_bind_double(statement_.get(), parameter, value));
  return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
  check(sqlite3_bind_text64(statement_.get(), parameter, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind(int parameter, std::span<const std::byte> blob) {
  check(sqlite3_bind_blob64(statement_.get(), parameter, blob.empty() ? "" : static_cast<const void*>(blob.data()),
                            blob.size(), SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bindRow(const Statement& row) {
  for (int i = 0; i < row.columns(); ++i)
    check(sqlite3_bind_value(statement_.get(), i + 1, sqlite3_column_value(row.statement_.get(), i)));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  check(code);
  return code == SQLITE_ROW;
}

void Statement::run() {
  try {
    while (step()) {
    }
  } catch (...) {
    sqlite3_reset(statement_.get());
    throw;
  }
  check(sqlite3_reset(statement_.get()));
}

int Statement::columns() const {
  return sqlite3_column_count(statement_.get());
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::optional<std::int64_t> Statement::optionalInteger(int column) const {
  if (sqlite3_column_type(statement_.get(), column) == SQLITE_NULL) return std::nullopt;
  return integer(column);
}

std::optional<double> Statement::optionalReal(int column) const {
  if (sqlite3_column_type(statement_.get(), column) == SQLITE_NULL) return std::nullopt;
  return real(column);
}

double Statement::real(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text == nullptr ? std::string()
                         : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

std::vector<std::byte> Statement::blob(int column) const {
  const void* data = sqlite3_column_blob(statement_.get(), column);
  std::vector<std::byte> bytes(static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
  if (!bytes.empty()) std::memcpy(bytes.data(), data, bytes.size());
  return bytes;
}

Database::Database(std::string path, sqlite3* handle)
    : path_(std::move(path)), patience_(std::make_unique<std::int64_t>(0)), handle_(handle, &sqlite3_close_v2) {}

Database::Database(const std::string& path, Mode mode) : Database(path, nullptr) {
  if (mode == Mode::Read) {
    openForReading();
    return;
  }
  if (mode == Mode::Create) {
    std::error_code ignored;
    for (const char* suffix : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(path + suffix, ignored);
  }
  const int code = openHandle(path, SQLITE_OPEN_READWRITE | (mode == Mode::Create ? SQLITE_OPEN_CREATE : 0));
  if (code != SQLITE_OK) throw IoError(path, meaning(code, sqlite3_errstr(code)));
  sqlite3_busy_timeout(handle_.get(), 2000);
  if (mode == Mode::Create) run("PRAGMA page_size=" + std::to_string(kPageBytes));
  // A new file is written once, without a log: half of one is worth nothing, and nobody knows it yet.
  run(mode == Mode::Create ? "PRAGMA journal_mode=MEMORY" : "PRAGMA journal_mode=WAL");
  run("PRAGMA synchronous=FULL");
  run("PRAGMA wal_autocheckpoint=" + std::to_string(kMaxLogPages));
}

int Database::openHandle(const std::string& name, int flags) {
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &handle, flags | SQLITE_OPEN_EXRESCODE, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) return code;
  // A file from elsewhere must not run what its schema says.
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_progress_handler(handle, kInstructions, &useUp, patience_.get());
  return sqlite3_create_function_v2(handle, "row_sum", -1, SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_DIRECTONLY,
                                    nullptr, &rowSum, nullptr, nullptr, nullptr);
}

// A reader of a write-ahead log needs to write beside it. Where it cannot, a file without a log is read as it stands,
// and one with a log is copied to where it can be.
void Database::openForReading() {
  if (!std::filesystem::exists(path_)) throw IoError(path_, "does not exist");
  int code = openHandle(path_, SQLITE_OPEN_READONLY);
  if (code == SQLITE_OK) sqlite3_busy_timeout(handle_.get(), 2000);
  if (code == SQLITE_OK)
    code = sqlite3_exec(handle_.get(), "BEGIN; SELECT 1 FROM sqlite_master", nullptr, nullptr, nullptr);
  const int kind = code & 0xff;
  if (code != SQLITE_OK && (kind == SQLITE_CANTOPEN || kind == SQLITE_READONLY)) {
    if (hasLog(path_))
      throw IoError(path_, "its last changes are in " + path_ +
                               "-wal, which can only be read in a folder that can be written to; copy both there");
    code = openHandle(fileUri(path_) + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  }
  if (code != SQLITE_OK) throw IoError(path_, meaning(code, sqlite3_errstr(code)));
}

void Database::backUp(Database& copy) const {
  sqlite3_backup* backup = sqlite3_backup_init(copy.handle_.get(), "main", handle_.get(), "main");
  if (backup == nullptr) throw IoError(path_, meaning(SQLITE_ERROR, sqlite3_errmsg(copy.handle_.get())));
  sqlite3_backup_step(backup, -1);
  const int done = sqlite3_backup_finish(backup);
  if (done != SQLITE_OK) throw IoError(copy.path_, meaning(done, sqlite3_errstr(done)));
}

Database Database::inMemory(const std::string& path) {
  Database database(path, nullptr);
  const int code = database.openHandle(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  if (code != SQLITE_OK) throw IoError(path, meaning(code, sqlite3_errstr(code)));
  return database;
}

Database Database::copyInMemory() const {
  Database copy = inMemory(path_);
  backUp(copy);
  return copy;
}

void Database::copyTo(const std::string& path) const {
  if (std::filesystem::exists(path)) throw IoError(path, "exists already");
  Database copy(path, nullptr);
  // Left to become what it is a copy of: pages of that size, and a log.
  const int code = copy.openHandle(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  if (code != SQLITE_OK) throw IoError(path, meaning(code, sqlite3_errstr(code)));
  backUp(copy);
}

bool Database::sound() {
  try {
    Statement check = prepare("PRAGMA quick_check(1)");
    return check.step() && check.text(0) == "ok";
  } catch (const IoError&) {
    return false;
  }
}

void Database::bePatient() {
  std::error_code error;
  const auto bytes = std::filesystem::file_size(path_, error);
  *patience_ = kPatience + (error ? 0 : static_cast<std::int64_t>(bytes) / kBytesPerMore);
}

Statement Database::prepare(const std::string& sql) {
  bePatient();
  return {handle_.get(), path_, sql};
}

void Database::run(const std::string& sql) {
  prepare(sql).run();
}

Database::Transaction::Transaction(Database& database) : database_(database) {
  database_.run("BEGIN IMMEDIATE");
}

Database::Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const IoError&) {
    // Closing the connection rolls back as well.
  }
}

void Database::Transaction::commit() {
  database_.run("COMMIT");
  open_ = false;
}

}  // namespace vantage
