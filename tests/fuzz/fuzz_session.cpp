#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "acquisition/acquisition.h"
#include "base/errors.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/scratch_file.h"
#include "session/database.h"
#include "session/session.h"
#include "session/session_schema.h"
#include "support/meshes.h"
#include "support/simulation.h"

// An input begins with what to do: 0: the rest is a session file as it stands; 1: a good session is changed before it
// is read; 2: the same, and the sums of its rows are put right, so that readers get to see it. A change is a byte for
// its kind, three for table, row and column, one for the length of the value, and the value. Several may follow each
// other.

namespace vantage::testing {
namespace {

constexpr std::array<const char*, 11> kTables{"scan",   "step", "view", "record", "plan", "model",
                                              "object", "rays", "meta", "file",   "event"};
enum class Kind : unsigned char { Text, Bytes, Packed, Integer, Null, Delete, Copy, Schema };
constexpr int kKinds = 8;
// Whatever a schema may have that is no session's; %1 is the table.
constexpr std::array<const char*, 6> kSchemaChanges{
    "ALTER TABLE %1 ADD COLUMN more TEXT",
    "CREATE INDEX %1_index ON %1(rowid)",
    "CREATE TRIGGER %1_trigger AFTER INSERT ON %1 BEGIN DELETE FROM scan; END",
    "CREATE VIEW %1_view AS SELECT * FROM %1",
    "DROP TABLE %1",
    "ALTER TABLE %1 RENAME TO other"};

ProfileSource profileSource() {
  return {"fuzz.json",
          R"({ "name": "T", "scanner": { "type": "rotating_stripe", "position": [250, 0, 50], "stripe_height_mm": 100,
    "samples_per_stripe": 14, "stripes": 16, "sweep_deg": 40, "receivers": [[50, 0, 0]], "breakdown_angle_deg": 65,
    "range_mm": [100, 400] }, "workspace": { "type": "turntable", "steps": 8 }, "viewing_volume": { "radius_mm": 90,
    "height_mm": 120 }, "positional_space": { "surface": "cylinder", "rows": 4, "columns": 16 } })",
          {}};
}

// Two views of a ball.
std::string goodSession() {
  const ScratchFile file(".vantage");
  {
    const Mesh ball = makeSphere(35, 8, {0, 0, 50});
    AcquisitionSettings settings;
    settings.maxViews = 2;
    Session session = Session::create(file.path(), {profileSource(), settings, &ball});
    const Rig rig = simulation(ball, session.profile(), {1, true});
    const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*session.profile()));
    Acquisition(session, {rig, images}).runUntilTheEnd();
  }
  Database(file.path(), Database::Mode::Write).run("PRAGMA journal_mode=DELETE");
  return file.read();
}

const std::string& base() {
  static const std::string bytes = goodSession();
  return bytes;
}

std::vector<std::byte> compressed(std::string_view bytes) {
  std::vector<std::byte> packed(ZSTD_compressBound(bytes.size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
  return packed;
}

struct Change {
  Kind kind;
  std::string table;
  std::int64_t row;
  int column;
  std::string_view value;
};

// The next change, which is taken off the input; nothing at its end.
std::optional<Change> takeChange(std::string_view& input) {
  constexpr std::size_t kHead = 5;
  if (input.size() < kHead) return std::nullopt;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(input[i]); };
  Change change{static_cast<Kind>(byte(0) % kKinds), kTables[byte(1) % kTables.size()], byte(2), byte(3),
                input.substr(kHead, byte(4))};
  input.remove_prefix(kHead + change.value.size());
  return change;
}

std::string columnOf(Database& database, const Change& change) {
  Statement columns = database.prepare("SELECT count(*) FROM pragma_table_info(?)");
  columns.bind(1, std::string_view(change.table)).step();
  Statement name = database.prepare("SELECT name FROM pragma_table_info(?) WHERE cid = ?");
  name.bind(1, std::string_view(change.table)).bind(2, change.column % std::max<std::int64_t>(1, columns.integer(0)));
  return name.step() ? name.text(0) : std::string();
}

void setCell(Database& database, const Change& change, const std::string& where) {
  const std::string column = columnOf(database, change);
  if (column.empty()) return;
  Statement update = database.prepare("UPDATE OR IGNORE " + change.table + " SET " + column + " = ?" + where);
  std::int64_t number = 0;
  std::memcpy(&number, change.value.data(), std::min(change.value.size(), sizeof number));
  if (change.kind == Kind::Text) update.bind(1, change.value);
  if (change.kind == Kind::Bytes) update.bind(1, std::as_bytes(std::span(change.value)));
  if (change.kind == Kind::Packed) update.bind(1, std::span<const std::byte>(compressed(change.value)));
  if (change.kind == Kind::Integer) update.bind(1, number);
  if (change.kind == Kind::Null) update.bindOptional(1, std::nullopt);
  update.run();
}

void copyRow(Database& database, const Change& change, const std::string& where) {
  const std::string other = kTables[static_cast<std::size_t>(change.column) % kTables.size()];
  database.run("INSERT OR IGNORE INTO " + change.table + " SELECT * FROM " + other + where);
}

void change(Database& database, const Change& change) {
  const std::string key = keyOf(change.table);
  const std::string where = " WHERE " + key + " = (SELECT " + key + " FROM " + change.table + " LIMIT 1 OFFSET " +
                            std::to_string(change.row) + " % (SELECT max(1, count(*)) FROM " + change.table + "))";
  if (change.kind == Kind::Delete) {
    database.run("DELETE FROM " + change.table + where);
  } else if (change.kind == Kind::Copy) {
    copyRow(database, change, where);
  } else if (change.kind == Kind::Schema) {
    std::string statement = kSchemaChanges[static_cast<std::size_t>(change.column) % kSchemaChanges.size()];
    for (std::size_t at = 0; (at = statement.find("%1")) != std::string::npos;) statement.replace(at, 2, change.table);
    database.run(statement);
  } else {
    setCell(database, change, where);
  }
}

void changeAll(const std::string& path, std::string_view input, bool putRight) {
  Database database(path, Database::Mode::Write);
  database.run("PRAGMA journal_mode=MEMORY");
  database.run("PRAGMA synchronous=OFF");
  for (int i = 0; i < 4; ++i) {
    const auto next = takeChange(input);
    if (!next) break;
    try {
      change(database, *next);
      if (putRight) addSums(database, next->table);
    } catch (const IoError&) {
      // SQLite does not do all that is asked for.
    }
  }
}

// Everything that a window would show of it.
void readAll(const std::string& path) {
  const Session session = Session::open(path, SessionAccess::Read);
  for (std::size_t i = 0; i < session.history().size(); ++i) {
    static_cast<void>(session.state(i));
    static_cast<void>(session.model(i));
    static_cast<void>(session.plan(i));
    static_cast<void>(kindOf(session.history().entry(i).command));
  }
  session.check();
  static_cast<void>(session.object());
}

}  // namespace

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds{std::string(1, '\0') + base()};
  const std::string json =
      R"({"scan": 0, "position": 3, "seed": 1, "object": "", "termination": "finished", "scans": [1]})";
  for (char mode = 1; mode < 3; ++mode)
    for (char table = 0; table < static_cast<char>(kTables.size()); ++table)
      for (char kind = 0; kind < static_cast<char>(kKinds); ++kind)
        for (char column = 0; column < 6; ++column)
          seeds.push_back(std::string{mode, kind, table, 1, column, static_cast<char>(json.size())} + json);
  return seeds;
}

}  // namespace vantage::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vantage::testing;
  static const ScratchFile file(".vantage");
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  if (input.empty() || input[0] > 2 || input[0] < 0) return 0;
  try {
    file.write(input[0] == 0 ? input.substr(1) : std::string_view(base()));
    if (input[0] != 0) changeAll(file.path(), input.substr(1), input[0] == 2);
    readAll(file.path());
  } catch (const vantage::Error&) {
    return 0;
  }
  return 0;
}
