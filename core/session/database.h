#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace vantage {

/// A prepared SQLite statement. Parameters count from 1, columns from 0.
class Statement {
 public:
  Statement(sqlite3* database, std::string path, const std::string& sql);

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, double value);
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, std::span<const std::byte> blob);
  /// NULL for nothing.
  Statement& bindOptional(int parameter, std::optional<std::int64_t> value);

  /// Binds all columns of another statement's row, whatever they are, to parameters 1, 2, ...
  Statement& bindRow(const Statement& row);

  /// Runs to the next row. @return false when there is none. @throws IoError
  bool step();
  /// Runs a statement that returns no rows, and makes it ready for another run.
  void run();

  [[nodiscard]] int columns() const;
  [[nodiscard]] std::int64_t integer(int column) const;
  /// Nothing for NULL.
  [[nodiscard]] std::optional<std::int64_t> optionalInteger(int column) const;
  [[nodiscard]] double real(int column) const;
  /// Nothing for NULL.
  [[nodiscard]] std::optional<double> optionalReal(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::vector<std::byte> blob(int column) const;

 private:
  void check(int code) const;

  sqlite3* database_;
  std::string path_;
  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
};

/// An SQLite database file (synchronous=FULL; WAL, once it is opened for writing). Statements may use row_sum(x, ...),
/// a 64-bit number for values and their types.
class Database {
 public:
  enum class Mode { Create, Write, Read };

  /// Create replaces a file of that name. Read changes nothing, works in folders that cannot be written to, and sees
  /// the file as it was when it was opened. @throws IoError
  Database(const std::string& path, Mode mode);

  /// An empty database in memory; messages name it by the path.
  [[nodiscard]] static Database inMemory(const std::string& path);

  /// A copy in memory, to be changed at will.
  [[nodiscard]] Database copyInMemory() const;

  /// Writes what this connection sees to a new file. @throws IoError, also when a file of that name exists
  void copyTo(const std::string& path) const;

  /// Whether every page is where it belongs.
  [[nodiscard]] bool sound();

  [[nodiscard]] Statement prepare(const std::string& sql);
  void run(const std::string& sql);

  /// Everything between begin and commit happens or does not happen. Without commit the destructor rolls back.
  class Transaction {
   public:
    explicit Transaction(Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void commit();

   private:
    Database& database_;
    bool open_ = true;
  };

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  Database(std::string path, sqlite3* handle);
  int openHandle(const std::string& name, int flags);
  void bePatient();
  void openForReading();
  void backUp(Database& copy) const;

  std::string path_;
  std::unique_ptr<std::int64_t> patience_;  ///< that is left for a statement; before the handle, which uses it up
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> handle_;
};

}  // namespace vantage
