#include "session/session_schema.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "base/errors.h"
#include "session/session_json.h"

namespace vantage {
namespace {

struct Table {
  const char* name;
  const char* columns;
};

constexpr Table kTables[] = {
    {"meta", "(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID"},
    {"file", "(name TEXT PRIMARY KEY, content TEXT NOT NULL) WITHOUT ROWID"},
    {"object", "(id INTEGER PRIMARY KEY, hash TEXT NOT NULL, mesh BLOB)"},
    {"rays",
     "(id INTEGER PRIMARY KEY, rows INTEGER NOT NULL, columns INTEGER NOT NULL, receivers INTEGER NOT NULL, "
     "data BLOB NOT NULL)"},
    {"scan",
     "(id INTEGER PRIMARY KEY, position INTEGER NOT NULL, rays INTEGER REFERENCES rays(id), nominal BLOB NOT NULL, "
     "range BLOB NOT NULL)"},
    {"step",
     "(id INTEGER PRIMARY KEY, parent INTEGER NOT NULL, kind TEXT NOT NULL, command TEXT NOT NULL, settings TEXT NOT "
     "NULL, chosen INTEGER NOT NULL, termination TEXT NOT NULL, views INTEGER NOT NULL, model INTEGER NOT NULL, "
     "hash TEXT NOT NULL)"},
    {"view",
     "(id INTEGER PRIMARY KEY, step INTEGER NOT NULL REFERENCES step(id), place INTEGER NOT NULL, scan INTEGER NOT "
     "NULL REFERENCES scan(id), status TEXT NOT NULL, pose BLOB NOT NULL, record INTEGER NOT NULL, plan INTEGER NOT "
     "NULL)"},
    {"record", "(id INTEGER PRIMARY KEY, step INTEGER NOT NULL, scan INTEGER NOT NULL, data TEXT NOT NULL)"},
    {"plan", "(step INTEGER PRIMARY KEY, summary TEXT NOT NULL, data BLOB NOT NULL)"},
    {"model", "(step INTEGER PRIMARY KEY, data BLOB NOT NULL)"},
    {"event", "(id INTEGER PRIMARY KEY, what TEXT NOT NULL, step INTEGER NOT NULL)"}};

constexpr Table kTables1[] = {
    {"meta", "(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID"},
    {"file", "(name TEXT PRIMARY KEY, content TEXT NOT NULL) WITHOUT ROWID"},
    {"rays",
     "(id INTEGER PRIMARY KEY, rows INTEGER NOT NULL, columns INTEGER NOT NULL, receivers INTEGER NOT NULL, "
     "data BLOB NOT NULL)"},
    {"scan",
     "(id INTEGER PRIMARY KEY, position INTEGER NOT NULL, rays INTEGER REFERENCES rays(id), nominal BLOB NOT NULL, "
     "range BLOB NOT NULL)"},
    {"view",
     "(id INTEGER PRIMARY KEY, scan INTEGER NOT NULL REFERENCES scan(id), pose BLOB NOT NULL, samples INTEGER NOT "
     "NULL, triangles INTEGER NOT NULL)"},
    {"model", "(id INTEGER PRIMARY KEY CHECK (id = 1), data BLOB NOT NULL)"}};

std::string statementFor(const Table& table) {
  return std::string("CREATE TABLE ") + table.name + table.columns;
}

// The statements that made everything in the database, by name.
std::map<std::string, std::string> schemaOf(Database& database) {
  std::map<std::string, std::string> schema;
  Statement rows =
      database.prepare("SELECT name, ifnull(sql, '') FROM sqlite_master WHERE type <> 'index' OR sql NOT NULL");
  while (rows.step()) schema[rows.text(0)] = rows.text(1);
  return schema;
}

template <std::size_t N>
std::map<std::string, std::string> schemaOf(const Table (&tables)[N]) {
  std::map<std::string, std::string> schema;
  for (const Table& table : tables) schema[table.name] = statementFor(table);
  return schema;
}

std::string metaOf(Database& database, const std::string& key) {
  Statement row = database.prepare("SELECT value FROM meta WHERE key = ?");
  row.bind(1, std::string_view(key));
  return row.step() ? row.text(0) : std::string();
}

std::int64_t numberOf(Database& database, const char* key, std::int64_t low) {
  const std::string text = metaOf(database, key);
  if (!text.empty() && text.size() < 18 &&
      std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
    return std::max<std::int64_t>(low, std::stoll(text));
  throw InvalidInput(database.path() + ": the setting " + key + " is missing or damaged");
}

// Version 1 kept the settings in meta.
std::string settings1(Database& database) {
  AcquisitionSettings settings;
  settings.object = metaOf(database, "object");
  settings.placement = parsePlacement(metaOf(database, "placement"));
  settings.seed = static_cast<std::uint64_t>(numberOf(database, "seed", 0));
  settings.ideal = metaOf(database, "ideal") == "1";
  settings.firstView = static_cast<int>(numberOf(database, "first_view", 0));
  settings.maxViews = static_cast<int>(std::min<std::int64_t>(numberOf(database, "max_views", 1), 1'000'000));
  Statement tolerance = database.prepare("SELECT CAST(value AS REAL) FROM meta WHERE key = 'tolerance'");
  if (tolerance.step()) settings.tolerance = tolerance.real(0);
  settings.strategy = parseStrategy(metaOf(database, "strategy"));
  return settingsText(settings);
}

void addStep(Database& database, std::int64_t id, const std::string& kind, const std::string& command,
             const std::string& settings) {
  database.prepare("INSERT INTO step VALUES(?, ?, ?, ?, ?, -1, 'running', 0, 0, '')")
      .bind(1, id)
      .bind(2, id - 1)
      .bind(3, std::string_view(kind))
      .bind(4, std::string_view(command))
      .bind(5, std::string_view(settings))
      .run();
  database.prepare("INSERT INTO event(what, step) VALUES(?, ?)").bind(1, std::string_view(kind)).bind(2, id).run();
}

// What version 1 knew of a scan.
void addRecord1(Database& database, std::int64_t scan, int position, std::int64_t samples, std::int64_t triangles,
                bool failed) {
  ViewRecord record;
  record.scan = scan;
  record.position = position;
  record.samples = static_cast<std::size_t>(std::max<std::int64_t>(0, samples));
  record.triangles = static_cast<std::size_t>(std::max<std::int64_t>(0, triangles));
  record.registration.verdict = failed ? Verdict::Failed : Verdict::Good;
  record.registration.finding.reason = VerdictReason::EarlierVersion;
  database.prepare("INSERT INTO record(step, scan, data) VALUES(2, ?, ?)")
      .bind(1, scan)
      .bind(2, std::string_view(recordText(record)))
      .run();
}

void takeOverViews(Database& database) {
  Statement rows = database.prepare(
      "SELECT s.id, s.position, ifnull(v.samples, 0), ifnull(v.triangles, 0), v.id IS NULL FROM scan s LEFT JOIN view1 "
      "v "
      "ON v.scan = s.id ORDER BY ifnull(v.id, s.id)");
  while (rows.step())
    addRecord1(database, rows.integer(0), static_cast<int>(rows.integer(1)), rows.integer(2), rows.integer(3),
               rows.integer(4) != 0);
  database.run(
      "INSERT INTO view(step, place, scan, status, pose, record, plan) SELECT 2, id, scan, 'in', pose, 2, 0 FROM view1 "
      "ORDER BY id");
  database.run(
      "INSERT INTO view(step, place, scan, status, pose, record, plan) SELECT 2, id, id, 'rejected', nominal, 2, 0 "
      "FROM "
      "scan WHERE id NOT IN (SELECT scan FROM view1) ORDER BY id");
  database.run("INSERT INTO model SELECT 2, data FROM model1");
  database.run(
      "UPDATE step SET views = (SELECT count(*) FROM view), model = (SELECT ifnull(max(step), 0) FROM model) WHERE id "
      "= "
      "2");
}

void migrateFrom1(Database& database) {
  const std::string settings = settings1(database);
  const std::string termination = metaOf(database, "termination");
  database.run("ALTER TABLE view RENAME TO view1");
  database.run("ALTER TABLE model RENAME TO model1");
  for (const Table& table : kTables) {
    const std::string name = table.name;
    if (name != "meta" && name != "file" && name != "rays" && name != "scan") database.run(statementFor(table));
  }
  addStep(database, 1, "change_settings", settings, settings);
  addStep(database, 2, "take_over", "{}", settings);
  takeOverViews(database);
  if (!termination.empty() && termination != "cancelled")
    database.prepare("UPDATE step SET termination = ? WHERE id = 2").bind(1, std::string_view(termination)).run();
  database.run("DROP TABLE view1");
  database.run("DROP TABLE model1");
  database.run("DELETE FROM meta");
  database.run("INSERT INTO meta VALUES('schema', '2'), ('cursor', '2'), ('tip', '2')");
}

}  // namespace

const std::vector<std::string>& sessionTables() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Table& table : kTables) list.emplace_back(table.name);
    return list;
  }();
  return names;
}

void createSessionTables(Database& database) {
  for (const Table& table : kTables) database.run(statementFor(table));
  database.run("INSERT INTO meta VALUES('schema', '" + std::to_string(kSessionSchema) + "')");
}

int checkSessionTables(Database& database) {
  const std::map<std::string, std::string> schema = schemaOf(database);
  if (schema == schemaOf(kTables)) return kSessionSchema;
  if (schema == schemaOf(kTables1)) return 1;
  const auto meta = schema.find("meta");
  const bool ours = meta != schema.end() && meta->second == statementFor(kTables[0]);
  const std::string version = ours ? metaOf(database, "schema") : std::string();
  if (!version.empty() && version != "1" && version != std::to_string(kSessionSchema))
    throw InvalidInput(database.path() + ": has the session schema " + version + ", expected 1 or " +
                       std::to_string(kSessionSchema) + "; a newer version of the program may read it");
  throw InvalidInput(database.path() + ": is a database, but not a session: its tables are others");
}

void migrateSession(Database& database) {
  Database::Transaction transaction(database);
  migrateFrom1(database);
  transaction.commit();
}

}  // namespace vantage
