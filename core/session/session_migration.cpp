#include "session/session_migration.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "session/command_json.h"
#include "session/earlier_endings.h"
#include "session/session_json.h"
#include "session/session_schema.h"
#include "session/stored_history.h"

namespace vantage {
namespace {

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
  AcquisitionSettings settings = settingsBefore();
  settings.simulation.object = metaOf(database, "object");
  settings.simulation.placement = parsePlacement(metaOf(database, "placement"));
  settings.simulation.seed = static_cast<std::uint64_t>(numberOf(database, "seed", 0));
  settings.simulation.ideal = metaOf(database, "ideal") == "1";
  settings.firstView = static_cast<int>(numberOf(database, "first_view", 0));
  settings.maxViews = static_cast<int>(std::min<std::int64_t>(numberOf(database, "max_views", 1), 1'000'000));
  Statement tolerance = database.prepare("SELECT CAST(value AS REAL) FROM meta WHERE key = 'tolerance'");
  if (tolerance.step()) settings.planner.tolerance = tolerance.real(0);
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
  ScanRecord record;
  record.samples = static_cast<std::size_t>(std::max<std::int64_t>(0, samples));
  record.triangles = static_cast<std::size_t>(std::max<std::int64_t>(0, triangles));
  record.registration.verdict = failed ? Verdict::Failed : Verdict::Good;
  record.registration.finding.reason = VerdictReason::EarlierVersion;
  OutlinedScan outlined;
  outlined.scan = scan;
  if (position >= 0) outlined.station.position = position;
  outlined.record = std::make_shared<const ScanRecord>(record);
  database.prepare("INSERT INTO record(step, scan, data) VALUES(2, ?, ?)")
      .bind(1, scan)
      .bind(2, std::string_view(recordText(outlined)))
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
  for (const std::string& name : sessionTables(2))
    if (name != "meta" && name != "file" && name != "rays" && name != "scan") createSessionTable(database, 2, name);
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

// Runs `change` for every row of a query with the columns id and text; a text that is damaged stays as it is.
template <typename Change>
void rewrite(Database& database, const std::string& table, const std::string& key, const std::string& column,
             const Change& change) {
  std::vector<std::pair<std::int64_t, std::string>> changed;
  Statement rows = database.prepare("SELECT " + key + ", " + column + " FROM " + table);
  while (rows.step()) {
    try {
      changed.emplace_back(rows.integer(0), change(rows.text(1)));
    } catch (const InvalidInput&) {
      // Readers will say so.
    }
  }
  Statement update = database.prepare("UPDATE " + table + " SET " + column + " = ? WHERE " + key + " = ?");
  for (const auto& [id, text] : changed) update.bind(1, std::string_view(text)).bind(2, id).run();
}

// Texts become what this version writes: all options are named, sentences are codes.
void rewriteTexts(Database& database) {
  rewrite(database, "step", "id", "settings",
          [](const std::string& text) { return settingsText(settingsFromText(text, "settings")); });
  Statement kinds = database.prepare("SELECT id, kind FROM step");
  std::map<std::int64_t, std::string> kindOfStep;
  while (kinds.step()) kindOfStep[kinds.integer(0)] = kinds.text(1);
  for (const auto& [step, kind] : kindOfStep) {
    Statement row = database.prepare("SELECT command FROM step WHERE id = ?");
    if (!row.bind(1, step).step()) continue;
    try {
      const std::string text = commandText(commandFromText(kind, row.text(0), "command"));
      database.prepare("UPDATE step SET command = ? WHERE id = ?").bind(1, std::string_view(text)).bind(2, step).run();
    } catch (const InvalidInput&) {
      // Readers will say so.
    }
  }
  rewrite(database, "plan", "step", "summary",
          [](const std::string& text) { return planText(planFromText(text, "plan")); });
}

void rewriteRecords(Database& database) {
  Statement rows = database.prepare(
      "SELECT r.id, r.data, r.scan, s.stand, s.position FROM record r LEFT JOIN scan s ON s.id = r.scan");
  Statement update = database.prepare("UPDATE record SET data = ? WHERE id = ?");
  std::vector<std::pair<std::int64_t, std::string>> changed;
  while (rows.step()) {
    try {
      OutlinedScan scan;
      scan.scan = rows.integer(2);
      scan.station = stationOf(rows, 3);
      scan.record = std::make_shared<const ScanRecord>(recordFromText(rows.text(1), "record"));
      changed.emplace_back(rows.integer(0), recordText(scan));
    } catch (const InvalidInput&) {
      // Readers will say so.
    }
  }
  for (const auto& [id, text] : changed) update.bind(1, std::string_view(text)).bind(2, id).run();
}

// The plan that holds was that of the last view, and a view had the plan that was made last after it; now it keeps the
// one that was made when it was added. Scans of all kinds become one list, in their order, which is that of the views
// in the model.
void takeOverTables2(Database& database) {
  database.run(
      "INSERT INTO scan SELECT id, 0, CASE WHEN position >= 0 THEN position END, CASE WHEN position >= 0 THEN "
      "'commanded' ELSE 'reported' END, rays, nominal, range FROM scan2");
  database
      .prepare(
          "INSERT INTO step SELECT id, parent, kind, command, settings, 'automatic', ?, CASE WHEN chosen >= 0 THEN "
          "chosen END, termination, views, model, ifnull(last.plan, 0), '' FROM step2 LEFT JOIN (SELECT step, plan, "
          "max(place) FROM view2 WHERE status = 'in' GROUP BY step) AS last ON last.step = step2.id")
      .bind(1, std::string_view(standsText({{Pose::Identity()}})))
      .run();
  database.run(
      "INSERT INTO view(step, place, scan, status, pose, record, plan) SELECT v.step, row_number() OVER (PARTITION BY "
      "v.step ORDER BY v.scan, v.id) - 1, v.scan, replace(v.status, ' ', '_'), v.pose, v.record, ifnull(first.plan, "
      "v.plan) FROM view2 v LEFT JOIN (SELECT step, scan, max(plan) AS plan FROM view2 WHERE step = record GROUP BY "
      "step, scan) AS first ON first.step = v.record AND first.scan = v.scan ORDER BY v.step, v.scan, v.id");
}

// Version 2 knew one stand and nobody but the program that takes the next step.
void migrateFrom2(Database& database) {
  // All are renamed before any is made anew: a table that refers to one that is renamed is changed with it.
  for (const char* name : {"view", "step", "scan"})
    database.run(std::string("ALTER TABLE ") + name + " RENAME TO " + name + "2");
  for (const char* name : {"scan", "step", "view"}) createSessionTable(database, 3, name);
  takeOverTables2(database);
  for (const char* name : {"view2", "step2", "scan2"}) database.run(std::string("DROP TABLE ") + name);
  rewriteTexts(database);
  rewriteRecords(database);
  renameEarlierEndings(database);
  database.run("UPDATE meta SET value = '3' WHERE key = 'schema'");
}

// Version 3 had no sums. The texts that make the tables become those of new ones.
void migrateFrom3(Database& database) {
  for (const std::string& table : sessionTables(4)) {
    database.run("ALTER TABLE " + table + " ADD COLUMN sum INTEGER NOT NULL DEFAULT 0");
    if (table != "meta") addSums(database, table, 4);
  }
  Statement files = database.prepare("SELECT count(*) FROM file");
  files.step();
  const std::int64_t count = files.integer(0);
  database.prepare("INSERT OR REPLACE INTO meta(key, value) VALUES('schema', '4'), ('files', ?)")
      .bind(1, std::string_view(std::to_string(count)))
      .run();
  addSums(database, "meta", 4);
}

// Version 4 knew no uncertainty of a pose, no devices and no colours. Rows that were not as they were written stay so.
void migrateFrom4(Database& database) {
  // Both are renamed before any is made anew, see migrateFrom2.
  for (const char* name : {"view", "scan"})
    database.run(std::string("ALTER TABLE ") + name + " RENAME TO " + name + "4");
  for (const char* name : {"scan", "view"}) createSessionTable(database, 5, name);
  database.run(
      "INSERT INTO scan SELECT id, stand, position, known_by, NULL, NULL, '', rays, nominal, range, NULL, 0 FROM "
      "scan4");
  addSums(database, "scan", 5);
  database.run(
      "UPDATE scan SET sum = ~sum WHERE id IN (SELECT id FROM scan4 WHERE sum <> row_sum('scan', id, stand, position, "
      "known_by, rays, nominal, range))");
  database.run("INSERT INTO view SELECT * FROM view4");
  for (const char* name : {"view4", "scan4"}) database.run(std::string("DROP TABLE ") + name);
  database.run("INSERT OR REPLACE INTO meta VALUES('schema', '5', row_sum('meta', 'schema', '5'))");
}

}  // namespace

void migrateSession(Database& database) {
  Database::Transaction transaction(database);
  int version = checkSessionTables(database);
  if (version == 1) {
    migrateFrom1(database);
    version = 2;
  }
  if (version == 2) {
    migrateFrom2(database);
    version = 3;
  }
  if (version == 3) {
    migrateFrom3(database);
    version = 4;
  }
  if (version == 4) migrateFrom4(database);
  transaction.commit();
}

}  // namespace vantage
