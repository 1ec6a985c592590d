#include "session/session_schema.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

struct Table {
  const char* name;
  const char* columns;
};

// Tables that versions share.
constexpr Table kMeta{"meta", "(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID"};
constexpr Table kFile{"file", "(name TEXT PRIMARY KEY, content TEXT NOT NULL) WITHOUT ROWID"};
constexpr Table kObject{"object", "(id INTEGER PRIMARY KEY, hash TEXT NOT NULL, mesh BLOB)"};
constexpr Table kRays{"rays",
                      "(id INTEGER PRIMARY KEY, rows INTEGER NOT NULL, columns INTEGER NOT NULL, receivers INTEGER NOT "
                      "NULL, data BLOB NOT NULL)"};
constexpr Table kView{"view",
                      "(id INTEGER PRIMARY KEY, step INTEGER NOT NULL REFERENCES step(id), place INTEGER NOT NULL, "
                      "scan INTEGER NOT NULL REFERENCES scan(id), status TEXT NOT NULL, pose BLOB NOT NULL, record "
                      "INTEGER NOT NULL, plan INTEGER NOT NULL)"};
constexpr Table kRecord{"record",
                        "(id INTEGER PRIMARY KEY, step INTEGER NOT NULL, scan INTEGER NOT NULL, data TEXT NOT NULL)"};
constexpr Table kPlan{"plan", "(step INTEGER PRIMARY KEY, summary TEXT NOT NULL, data BLOB NOT NULL)"};
constexpr Table kModel{"model", "(step INTEGER PRIMARY KEY, data BLOB NOT NULL)"};
constexpr Table kEvent{"event", "(id INTEGER PRIMARY KEY, what TEXT NOT NULL, step INTEGER NOT NULL)"};
// Of versions 1 and 2.
constexpr Table kScanOfPosition{"scan",
                                "(id INTEGER PRIMARY KEY, position INTEGER NOT NULL, rays INTEGER REFERENCES rays(id), "
                                "nominal BLOB NOT NULL, range BLOB NOT NULL)"};

constexpr Table kTables1[] = {
    kMeta,
    kFile,
    kRays,
    kScanOfPosition,
    {"view",
     "(id INTEGER PRIMARY KEY, scan INTEGER NOT NULL REFERENCES scan(id), pose BLOB NOT NULL, samples INTEGER NOT "
     "NULL, triangles INTEGER NOT NULL)"},
    {"model", "(id INTEGER PRIMARY KEY CHECK (id = 1), data BLOB NOT NULL)"}};

constexpr Table kTables2[] = {
    kMeta,
    kFile,
    kObject,
    kRays,
    kScanOfPosition,
    {"step",
     "(id INTEGER PRIMARY KEY, parent INTEGER NOT NULL, kind TEXT NOT NULL, command TEXT NOT NULL, settings TEXT NOT "
     "NULL, chosen INTEGER NOT NULL, termination TEXT NOT NULL, views INTEGER NOT NULL, model INTEGER NOT NULL, "
     "hash TEXT NOT NULL)"},
    kView,
    kRecord,
    kPlan,
    kModel,
    kEvent};

constexpr Table kStep{"step",
                      "(id INTEGER PRIMARY KEY, parent INTEGER NOT NULL, kind TEXT NOT NULL, command TEXT NOT NULL, "
                      "settings TEXT NOT NULL, mode TEXT NOT NULL, stands TEXT NOT NULL, chosen INTEGER, termination "
                      "TEXT NOT NULL, views INTEGER NOT NULL, model INTEGER NOT NULL, plan INTEGER NOT NULL, hash TEXT "
                      "NOT NULL)"};

// Of versions 3 and, with sums, 4.
constexpr Table kTables3[] = {
    kMeta,
    kFile,
    kObject,
    kRays,
    {"scan",
     "(id INTEGER PRIMARY KEY, stand INTEGER NOT NULL, position INTEGER, known_by TEXT NOT NULL, rays INTEGER "
     "REFERENCES rays(id), nominal BLOB NOT NULL, range BLOB NOT NULL)"},
    kStep,
    kView,
    kRecord,
    kPlan,
    kModel,
    kEvent};

constexpr Table kTables5[] = {
    kMeta,
    kFile,
    kObject,
    kRays,
    {"scan",
     "(id INTEGER PRIMARY KEY, stand INTEGER NOT NULL, position INTEGER, known_by TEXT NOT NULL, angle_sigma REAL, "
     "position_sigma REAL, taken_with TEXT NOT NULL, rays INTEGER REFERENCES rays(id), nominal BLOB NOT NULL, range "
     "BLOB NOT NULL, colours BLOB)"},
    kStep,
    kView,
    kRecord,
    kPlan,
    kModel,
    kEvent};

// From this version on every row has a sum.
constexpr int kSums = 4;
constexpr const char* kSum = ", sum INTEGER NOT NULL DEFAULT 0";

std::string statementFor(const Table& table, int version) {
  std::string columns = table.columns;
  if (version >= kSums) columns.insert(columns.rfind(')'), kSum);
  return std::string("CREATE TABLE ") + table.name + columns;
}

std::span<const Table> tablesOf(int version) {
  if (version == 1) return kTables1;
  if (version == 2) return kTables2;
  if (version < kSessionSchema) return kTables3;
  return kTables5;
}

const Table& tableOf(const std::string& name, int version) {
  const std::span<const Table> tables = tablesOf(version);
  const auto table = std::find_if(tables.begin(), tables.end(), [&](const Table& t) { return name == t.name; });
  if (table == tables.end()) throw InvalidInput("a session has no table " + name);
  return *table;
}

// The first word of everything between the outermost commas.
std::vector<std::string> columnsOf(const std::string& table, int version = kSessionSchema) {
  const std::string text = tableOf(table, version).columns;
  std::vector<std::string> columns(1);
  int depth = 0;
  bool inName = true;
  for (const char c : text.substr(1, text.rfind(')') - 1)) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 0) {
      columns.emplace_back();
      inName = true;
    } else if (inName && (c != ' ' || !columns.back().empty())) {
      inName = c != ' ';
      if (inName) columns.back() += c;
    }
  }
  return columns;
}

// row_sum('view', prefix + first column, ...)
std::string sumOf(const std::string& table, const std::vector<std::string>& values) {
  std::string sum = "row_sum('" + table + "'";
  for (const std::string& value : values) sum += ", " + value;
  return sum + ")";
}

// What a database is made of: type, name and statement of everything in it, in order.
using Schema = std::vector<std::array<std::string, 3>>;

Schema schemaOf(Database& database) {
  Schema schema;
  Statement rows =
      database.prepare("SELECT type, name, ifnull(sql, '') FROM sqlite_master WHERE type <> 'index' OR sql NOT NULL");
  while (rows.step()) schema.push_back({rows.text(0), rows.text(1), rows.text(2)});
  std::sort(schema.begin(), schema.end());
  return schema;
}

Schema schemaOf(int version) {
  Schema schema;
  for (const Table& table : tablesOf(version)) schema.push_back({"table", table.name, statementFor(table, version)});
  std::sort(schema.begin(), schema.end());
  return schema;
}

std::string versionIn(Database& database) {
  Statement row = database.prepare("SELECT value FROM meta WHERE key = 'schema'");
  return row.step() ? row.text(0) : std::string();
}

}  // namespace

std::vector<std::string> sessionTables(int version) {
  std::vector<std::string> names;
  for (const Table& table : tablesOf(version)) names.emplace_back(table.name);
  return names;
}

void createSessionTable(Database& database, int version, const std::string& name) {
  for (const Table& table : tablesOf(version))
    if (name == table.name) database.run(statementFor(table, version));
}

void createSessionTables(Database& database, int version) {
  for (const Table& table : tablesOf(version)) database.run(statementFor(table, version));
  database.run("INSERT INTO meta(key, value) VALUES('schema', '" + std::to_string(version) + "')");
  if (version >= kSums) addSums(database, "meta", version);
}

std::string insertInto(const std::string& table) {
  std::vector<std::string> places;
  for (std::size_t i = 1; i <= columnsOf(table).size(); ++i)
    places.push_back(std::string("?").append(std::to_string(i)));
  std::string statement = "INSERT INTO " + table + " VALUES(";
  for (const std::string& place : places) statement += place + ", ";
  return statement + sumOf(table, places) + ")";
}

std::string replaceIn(const std::string& table) {
  return insertInto(table).replace(0, std::string_view("INSERT").size(), "INSERT OR REPLACE");
}

std::string intact(const std::string& table, const std::string& alias, int version) {
  std::vector<std::string> columns = columnsOf(table, version);
  const std::string prefix = alias.empty() ? std::string() : alias + ".";
  for (std::string& column : columns) column.insert(0, prefix);
  return "(" + prefix + "sum = " + sumOf(table, columns) + ")";
}

void addSums(Database& database, const std::string& table, int version) {
  database.run("UPDATE " + table + " SET sum = " + sumOf(table, columnsOf(table, version)));
}

const char* keyOf(const std::string& table) {
  if (table == "meta") return "key";
  if (table == "file") return "name";
  return table == "plan" || table == "model" ? "step" : "id";
}

int checkSessionTables(Database& database) {
  const Schema schema = schemaOf(database);
  for (int version = kSessionSchema; version >= 1; --version)
    if (schema == schemaOf(version)) return version;
  const bool ours = std::any_of(schema.begin(), schema.end(), [](const auto& row) {
    return row[0] == "table" && row[1] == "meta" && row[2].starts_with("CREATE TABLE meta(key TEXT PRIMARY KEY, value");
  });
  const std::string version = ours ? versionIn(database) : std::string();
  if (!version.empty() && (version.size() > 1 || version < "1" || version > std::to_string(kSessionSchema)))
    throw InvalidInput(database.path() + ": has the session schema " + version + ", expected 1 to " +
                       std::to_string(kSessionSchema) + "; a newer version of the program may read it");
  throw InvalidInput(database.path() + ": is a database, but not a session: its tables are others");
}

}  // namespace vantage
