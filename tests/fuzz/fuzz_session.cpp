#include <zstd.h>

#include <algorithm>
#include <array>

#include "acquisition/acquisition.h"
#include "base/errors.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/scratch_file.h"
#include "session/database.h"
#include "session/session.h"
#include "session/session_schema.h"
#include "support/meshes.h"
#include "support/simulation.h"

// An input begins with what to do: 0: the rest is a session file as it stands. Else a good session is changed in one
// cell before it is read: table, row and column in three bytes, then the value, as text, as bytes (2) or as bytes that
// are compressed first (3), which is where the readers of large columns begin.

namespace vantage::testing {
namespace {

constexpr std::array<const char*, 8> kTables{"scan", "step", "view", "record", "plan", "model", "object", "rays"};

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

void changeCell(const std::string& path, std::string_view input) {
  Database database(path, Database::Mode::Write);
  database.run("PRAGMA synchronous=OFF");
  const std::string table = kTables[static_cast<unsigned char>(input[1]) % kTables.size()];
  const auto row = std::int64_t{static_cast<unsigned char>(input[2])};
  Statement columns = database.prepare("SELECT * FROM " + table + " LIMIT 0");
  const int column = 1 + static_cast<unsigned char>(input[3]) % std::max(1, columns.columns() - 1);
  Statement name = database.prepare("SELECT name FROM pragma_table_info(?) WHERE cid = ?");
  name.bind(1, std::string_view(table)).bind(2, std::int64_t{column});
  if (!name.step()) return;
  Statement update =
      database.prepare("UPDATE " + table + " SET " + name.text(0) + " = ? WHERE rowid = (SELECT rowid FROM " + table +
                       " LIMIT 1 OFFSET ? % (SELECT max(1, count(*)) FROM " + table + "))");
  const std::string_view value = input.substr(4);
  if (input[0] == 1) update.bind(1, value);
  if (input[0] == 2) update.bind(1, std::as_bytes(std::span(value)));
  if (input[0] >= 3) update.bind(1, std::span<const std::byte>(compressed(value)));
  update.bind(2, row).run();
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
  static_cast<void>(session.object());
}

}  // namespace

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds{std::string(1, '\0') + base()};
  const std::string json =
      R"({"scan": 0, "position": 3, "seed": 1, "object": "", "termination": "finished", "scans": [1]})";
  for (char table = 0; table < static_cast<char>(kTables.size()); ++table)
    for (char column = 0; column < 5; ++column)
      for (char mode = 1; mode < 4; ++mode) seeds.push_back(std::string{mode, table, 1, column} + json);
  return seeds;
}

}  // namespace vantage::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vantage::testing;
  static const ScratchFile file(".vantage");
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  if (input.empty() || input[0] > 3 || input[0] < 0) return 0;
  try {
    if (input[0] == 0) {
      file.write(input.substr(1));
    } else {
      if (input.size() < 4) return 0;
      file.write(base());
      changeCell(file.path(), input);
    }
    readAll(file.path());
  } catch (const vantage::Error&) {
    return 0;
  }
  return 0;
}
