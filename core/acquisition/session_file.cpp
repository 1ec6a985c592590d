#include "acquisition/session_file.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "acquisition/session_blobs.h"
#include "base/errors.h"

namespace vantage {
namespace {

constexpr const char* kSchemaVersion = "1";

constexpr const char* kTables[] = {
    "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID",
    "CREATE TABLE file(name TEXT PRIMARY KEY, content TEXT NOT NULL) WITHOUT ROWID",
    "CREATE TABLE rays(id INTEGER PRIMARY KEY, rows INTEGER NOT NULL, columns INTEGER NOT NULL, receivers INTEGER NOT "
    "NULL, "
    "data BLOB NOT NULL)",
    "CREATE TABLE scan(id INTEGER PRIMARY KEY, position INTEGER NOT NULL, rays INTEGER REFERENCES rays(id), "
    "nominal BLOB NOT NULL, range BLOB NOT NULL)",
    "CREATE TABLE view(id INTEGER PRIMARY KEY, scan INTEGER NOT NULL REFERENCES scan(id), pose BLOB NOT NULL, "
    "samples INTEGER NOT NULL, triangles INTEGER NOT NULL)",
    "CREATE TABLE model(id INTEGER PRIMARY KEY CHECK (id = 1), data BLOB NOT NULL)"};

// The profile's own text is stored under this name, the files that it names under theirs.
constexpr const char* kProfileName = "profile.json";

void setMeta(Database& database, std::string_view key, std::string_view value) {
  database.prepare("INSERT OR REPLACE INTO meta VALUES(?, ?)").bind(1, key).bind(2, value).run();
}

std::map<std::string, std::string> allMeta(Database& database) {
  std::map<std::string, std::string> meta;
  Statement rows = database.prepare("SELECT key, value FROM meta");
  while (rows.step()) meta[rows.text(0)] = rows.text(1);
  return meta;
}

template <typename Number>
Number parsed(const std::map<std::string, std::string>& meta, const std::string& key, const std::string& path) {
  const auto it = meta.find(key);
  Number value{};
  if (it != meta.end()) {
    const auto [end, error] = std::from_chars(it->second.data(), it->second.data() + it->second.size(), value);
    if (error == std::errc() && end == it->second.data() + it->second.size()) return value;
  }
  throw InvalidInput(path + ": the setting " + key + " is missing or damaged");
}

std::string decimal(double value) {
  char text[40];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return {text, end};
}

}  // namespace

SessionFile SessionFile::create(const std::string& path, const std::optional<ProfileSource>& profile,
                                const AcquisitionSettings& settings) {
  SessionFile session(Database(path, Database::Mode::Create));
  Database& database = session.database_;
  Database::Transaction transaction(database);
  for (const char* table : kTables) database.run(table);
  setMeta(database, "schema", kSchemaVersion);
  setMeta(database, "object", settings.object);
  setMeta(database, "placement", settings.placement);
  setMeta(database, "seed", std::to_string(settings.seed));
  setMeta(database, "ideal", settings.ideal ? "1" : "0");
  setMeta(database, "first_view", std::to_string(settings.firstView));
  setMeta(database, "max_views", std::to_string(settings.maxViews));
  setMeta(database, "tolerance", decimal(settings.tolerance));
  setMeta(database, "strategy", name(settings.strategy));
  if (profile) {
    Statement insert = database.prepare("INSERT INTO file VALUES(?, ?)");
    insert.bind(1, std::string_view(kProfileName)).bind(2, profile->text).run();
    for (const auto& [fileName, content] : profile->attachments) insert.bind(1, fileName).bind(2, content).run();
    session.profileRays_ = parseProfile(*profile).rays;
  }
  transaction.commit();
  return session;
}

SessionFile SessionFile::open(const std::string& path) {
  SessionFile session(Database(path, Database::Mode::Open));
  Statement tables =
      session.database_.prepare("SELECT count(*) FROM sqlite_master WHERE name IN ('meta', 'scan', 'view', 'model')");
  tables.step();
  if (tables.integer(0) != 4)
    throw InvalidInput(path + ": is a database, but not a session, expected the tables meta, scan, view and model");
  const auto meta = allMeta(session.database_);
  const auto schema = meta.find("schema");
  if (schema == meta.end() || schema->second != kSchemaVersion)
    throw InvalidInput(path + ": has the session schema " + (schema == meta.end() ? "none" : schema->second) +
                       ", expected " + kSchemaVersion);
  return session;
}

std::int64_t SessionFile::saveRays(const RayGrid& rays) {
  const int receivers = static_cast<int>(rays.receivers(0).size());
  database_.prepare("INSERT INTO rays(rows, columns, receivers, data) VALUES(?, ?, ?, ?)")
      .bind(1, std::int64_t{rays.rows()})
      .bind(2, std::int64_t{rays.columns()})
      .bind(3, std::int64_t{receivers})
      .bind(4, std::span<const std::byte>(raysBlob(rays)))
      .run();
  Statement id = database_.prepare("SELECT last_insert_rowid()");
  id.step();
  return id.integer(0);
}

// Views and rejected scans that are not in the file yet, in the order in which they appear.
void SessionFile::saveScans(const AcquisitionState& state) {
  std::vector<std::shared_ptr<const RangeImage>> scans;
  for (const View& view : state.views) scans.push_back(view.image);
  for (const RejectedScan& scan : state.rejected) scans.push_back(scan.image);
  for (const auto& image : scans) {
    if (std::find(savedScans_.begin(), savedScans_.end(), image) != savedScans_.end()) continue;
    const bool ownRays = image->rays != profileRays_ && !(state.profile && image->rays == state.profile->rays);
    const std::int64_t rays = ownRays ? saveRays(*image->rays) : 0;
    Statement insert = database_.prepare("INSERT INTO scan VALUES(?, ?, nullif(?, 0), ?, ?)");
    insert.bind(1, static_cast<std::int64_t>(savedScans_.size()))
        .bind(2, std::int64_t{image->position})
        .bind(3, rays)
        .bind(4, std::span<const std::byte>(poseBlob(image->T_object_scanner)))
        .bind(5, std::span<const std::byte>(rangeBlob(image->range)))
        .run();
    savedScans_.push_back(image);
  }
}

void SessionFile::saveViews(const AcquisitionState& state) {
  database_.run("DELETE FROM view");
  Statement insert = database_.prepare("INSERT INTO view VALUES(?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < state.views.size(); ++i) {
    const auto scan = std::find(savedScans_.begin(), savedScans_.end(), state.views[i].image) - savedScans_.begin();
    insert.bind(1, static_cast<std::int64_t>(i))
        .bind(2, static_cast<std::int64_t>(scan))
        .bind(3, std::span<const std::byte>(poseBlob(state.views[i].T_object_scanner)))
        .bind(4, static_cast<std::int64_t>(state.views[i].image->sampleCount()))
        .bind(5, static_cast<std::int64_t>(state.views[i].mesh->mesh.triangles.size()))
        .run();
  }
}

void SessionFile::save(const AcquisitionState& state) {
  Database::Transaction transaction(database_);
  saveScans(state);
  saveViews(state);
  if (state.model)
    database_.prepare("INSERT OR REPLACE INTO model VALUES(1, ?)")
        .bind(1, std::span<const std::byte>(modelBlob(*state.model)))
        .run();
  setMeta(database_, "termination", name(state.termination));
  transaction.commit();
}

std::optional<ProfileSource> SessionFile::loadProfileSource() {
  ProfileSource source;
  source.path = database_.path() + ": " + kProfileName;
  Statement rows = database_.prepare("SELECT name, content FROM file");
  while (rows.step()) {
    if (rows.text(0) == kProfileName) {
      source.text = rows.text(1);
    } else {
      source.attachments[rows.text(0)] = rows.text(1);
    }
  }
  if (source.text.empty()) return std::nullopt;
  return source;
}

AcquisitionSettings SessionFile::loadSettings() {
  const auto meta = allMeta(database_);
  const std::string& path = database_.path();
  AcquisitionSettings settings;
  const auto text = [&](const char* key) { return meta.contains(key) ? meta.at(key) : std::string(); };
  settings.object = text("object");
  settings.placement = text("placement");
  settings.seed = parsed<std::uint64_t>(meta, "seed", path);
  settings.ideal = text("ideal") == "1";
  settings.firstView = parsed<int>(meta, "first_view", path);
  settings.maxViews = parsed<int>(meta, "max_views", path);
  settings.tolerance = parsed<double>(meta, "tolerance", path);
  settings.strategy = parseStrategy(text("strategy"));
  return settings;
}

Session SessionFile::load(const Progress& progress) {
  Session session;
  session.settings = loadSettings();
  if (const auto source = loadProfileSource()) {
    session.state.profile = std::make_shared<const ScannerProfile>(parseProfile(*source));
    profileRays_ = session.state.profile->rays;
  }
  std::map<std::int64_t, std::shared_ptr<const RayGrid>> grids;
  Statement rays = database_.prepare("SELECT id, rows, columns, receivers, data FROM rays");
  while (rays.step())
    grids[rays.integer(0)] = std::make_shared<const RayGrid>(
        raysFromBlob(static_cast<int>(rays.integer(1)), static_cast<int>(rays.integer(2)),
                     static_cast<int>(rays.integer(3)), rays.blob(4), database_.path() + ": rays " + rays.text(0)));

  savedScans_.clear();
  Statement scans = database_.prepare("SELECT id, position, ifnull(rays, 0), nominal, range FROM scan ORDER BY id");
  while (scans.step()) {
    progress.checkpoint(0.3);
    const std::string what = database_.path() + ": scan " + scans.text(0);
    auto image = std::make_shared<RangeImage>();
    image->rays = scans.integer(2) == 0 ? profileRays_ : grids[scans.integer(2)];
    image->position = static_cast<int>(scans.integer(1));
    image->T_object_scanner = poseFromBlob(scans.blob(3), what);
    image->range = rangeFromBlob(scans.blob(4), what);
    validate(*image);
    savedScans_.push_back(std::move(image));
  }

  TriangulationOptions triangulation;
  if (session.state.profile) triangulation.breakdownAngle = session.state.profile->breakdownAngle;
  Statement views = database_.prepare("SELECT id, scan, pose FROM view ORDER BY id");
  while (views.step()) {
    progress.checkpoint(0.6);
    const std::string what = database_.path() + ": view " + views.text(0);
    const std::int64_t scan = views.integer(1);
    if (scan < 0 || scan >= static_cast<std::int64_t>(savedScans_.size()))
      throw InvalidInput(what + " names scan " + views.text(1) + ", which does not exist");
    View view;
    view.image = savedScans_[static_cast<std::size_t>(scan)];
    view.mesh = std::make_shared<const ViewMesh>(triangulate(*view.image, triangulation));
    view.T_object_scanner = poseFromBlob(views.blob(2), what);
    ViewRecord record;
    record.position = view.image->position;
    record.samples = view.image->sampleCount();
    record.triangles = view.mesh->mesh.triangles.size();
    session.state.records.push_back(std::move(record));
    session.state.views.push_back(std::move(view));
  }
  Statement model = database_.prepare("SELECT data FROM model");
  if (model.step())
    session.state.model = std::make_shared<const Model>(modelFromBlob(model.blob(0), database_.path() + ": model"));
  progress.checkpoint(1.0);
  return session;
}

}  // namespace vantage
