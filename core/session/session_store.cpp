#include "session/session_store.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#include "base/errors.h"
#include "geometry/geometry_hash.h"
#include "session/command_json.h"
#include "session/loss_list.h"
#include "session/session_blobs.h"
#include "session/session_json.h"
#include "session/session_schema.h"

namespace vantage {
namespace {

// The profile's own text is stored under this name, the files that it names under theirs.
constexpr const char* kProfileName = "profile.json";
// How many files there are.
constexpr const char* kFiles = "files";
constexpr const char* kUntrue = "untrue";
// An object that is larger than this when packed is only known by its file and its hash.
constexpr std::size_t kMaxObjectBytes = 256U << 20;
constexpr std::int64_t kMostScans = 100'000;
// Models of old steps are thinned out beyond this: they can be made again.
constexpr std::int64_t kModelBytes = 512LL << 20;

std::int64_t numberIn(const std::string& text) {
  std::int64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

// Nothing that moves an object is off by more [rad, mm].
constexpr double kMostAngleSigma = radians(90.0);
constexpr double kMostPositionSigma = 1000.0;

// The columns `column` (of the angle [rad]) and `column` + 1 (of the place [mm]).
std::optional<Mechanics> uncertaintyOf(const Statement& row, int column, const std::string& what) {
  const auto angle = row.optionalReal(column);
  const auto place = row.optionalReal(column + 1);
  if (!angle || !place) return std::nullopt;
  const auto within = [](double sigma, double most) { return sigma >= 0.0 && sigma <= most; };
  if (!within(*angle, kMostAngleSigma) || !within(*place, kMostPositionSigma))
    throw InvalidInput(what + " is damaged: its place is said to be unsure by " + std::to_string(*angle) + " rad and " +
                       std::to_string(*place) + " mm, expected 0 to 1.57 rad and 0 to 1000 mm");
  return Mechanics{*angle, *place};
}

void mustBeIntact(const Statement& row, int column, const std::string& what) {
  if (row.integer(column) == 0) throw InvalidInput(what + " is damaged: it is not as it was written");
}

}  // namespace

std::string SessionStore::meta(const std::string& key) {
  Statement row = database_.prepare("SELECT value FROM meta WHERE key = ? AND " + intact("meta"));
  row.bind(1, std::string_view(key));
  return row.step() ? row.text(0) : std::string();
}

void SessionStore::setMeta(const std::string& key, const std::string& value) {
  database_.prepare(replaceIn("meta")).bind(1, std::string_view(key)).bind(2, std::string_view(value)).run();
}

std::optional<ProfileSource> profileSourceIn(Database& database) {
  ProfileSource source;
  source.path = database.path() + ": " + kProfileName;
  Statement rows = database.prepare("SELECT name, content FROM file");
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

std::optional<ProfileSource> SessionStore::profileSource() {
  return profileSourceIn(database_);
}

void SessionStore::setProfileSource(const ProfileSource& source) {
  setMeta(kFiles, std::to_string(1 + source.attachments.size()));
  Statement insert = database_.prepare(insertInto("file"));
  insert.bind(1, std::string_view(kProfileName)).bind(2, std::string_view(source.text)).run();
  for (const auto& [name, content] : source.attachments)
    insert.bind(1, std::string_view(name)).bind(2, std::string_view(content)).run();
}

std::vector<Loss> SessionStore::untrue() {
  std::vector<Loss> losses;
  std::istringstream numbers(meta(kUntrue));
  for (std::int64_t step = 0; numbers >> step;) losses.push_back({LossKind::StateUntrue, step, {}, {}});
  return losses;
}

void SessionStore::setUntrue(const std::vector<Loss>& steps) {
  std::string numbers;
  for (const Loss& loss : steps) numbers += std::to_string(loss.number.value_or(0)) + " ";
  if (!numbers.empty()) setMeta(kUntrue, numbers);
}

std::vector<Loss> SessionStore::changedRows(const std::string& table) {
  const std::string key = keyOf(table);
  const std::string from = firstStepRead(database_) ? "(SELECT * FROM " + table + " ORDER BY " + key + " DESC LIMIT " +
                                                          std::to_string(kMostSteps) + ")"
                                                    : table;
  LossList losses;
  Statement rows = database_.prepare("SELECT " + key + " FROM " + from + " WHERE NOT " + intact(table));
  while (rows.step())
    losses.add({LossKind::RowDamaged, rows.integer(0), table,
                path() + ": " + table + " " + rows.text(0) + " is damaged: it is not as it was written"});
  return losses.all();
}

std::int64_t SessionStore::lostFiles() {
  Statement files = database_.prepare("SELECT count(*) FROM file");
  files.step();
  return std::max<std::int64_t>(0, numberIn(meta(kFiles)) - files.integer(0));
}

std::optional<SessionStore::StoredObject> SessionStore::object() {
  Statement row = database_.prepare("SELECT hash, mesh, " + intact("object") + " FROM object WHERE id = 1");
  if (!row.step()) return std::nullopt;
  mustBeIntact(row, 2, path() + ": object");
  StoredObject object{std::nullopt, row.text(0)};
  if (const auto blob = row.blob(1); !blob.empty()) object.mesh = meshFromBlob(blob, path() + ": object");
  return object;
}

void SessionStore::setObject(const Mesh& mesh) {
  const std::vector<std::byte> blob = meshBlob(mesh);
  Statement insert = database_.prepare(replaceIn("object"));
  insert.bind(1, std::int64_t{1}).bind(2, std::string_view(hashText(contentHash(mesh))));
  if (blob.size() <= kMaxObjectBytes) insert.bind(3, std::span<const std::byte>(blob));
  insert.run();
}

StoredHistory SessionStore::history() {
  return readHistory(database_, numberIn(meta("tip")), numberIn(meta("cursor")));
}

std::int64_t SessionStore::scanCount() {
  Statement row = database_.prepare("SELECT ifnull(max(id), -1) FROM scan");
  row.step();
  const std::int64_t last = row.integer(0);
  if (last > kMostScans)
    throw InvalidInput(path() + ": scan " + std::to_string(last) + " is damaged: there are never more than " +
                       std::to_string(kMostScans));
  return last + 1;
}

std::vector<std::int64_t> SessionStore::scanNumbers() {
  std::vector<std::int64_t> numbers;
  Statement rows = database_.prepare("SELECT id FROM scan ORDER BY id");
  while (rows.step()) numbers.push_back(rows.integer(0));
  return numbers;
}

bool SessionStore::scanUsed(std::int64_t number) {
  Statement row = database_.prepare("SELECT 1 FROM view WHERE scan = ? LIMIT 1");
  return row.bind(1, number).step();
}

std::optional<Station> SessionStore::lastStation() {
  Statement row = database_.prepare("SELECT stand, position FROM scan ORDER BY id DESC LIMIT 1");
  if (!row.step()) return std::nullopt;
  return stationOf(row, 0);
}

std::int64_t SessionStore::raysOf(std::int64_t scan) {
  Statement row = database_.prepare("SELECT ifnull(rays, 0) FROM scan WHERE id = ?");
  if (!row.bind(1, scan).step()) throw InvalidInput(path() + ": scan " + std::to_string(scan) + " does not exist");
  return row.integer(0);
}

RangeImage SessionStore::scan(std::int64_t number, std::size_t rays) {
  const std::string what = path() + ": scan " + std::to_string(number);
  Statement row = database_.prepare(
      "SELECT stand, position, known_by, nominal, range, angle_sigma, position_sigma, taken_with, colours, " +
      intact("scan") + " FROM scan WHERE id = ?");
  if (!row.bind(1, number).step()) throw InvalidInput(what + " does not exist");
  mustBeIntact(row, 9, what);
  RangeImage image;
  image.station = stationOf(row, 0);
  image.poseKnownBy = poseSourceFromName(row.text(2), what);
  image.T_table_scanner = poseFromBlob(row.blob(3), what);
  image.range = rangeFromBlob(row.blob(4), rays, what);
  image.poseUncertainty = uncertaintyOf(row, 5, what);
  image.takenWith = row.text(7);
  if (const auto colours = row.blob(8); !colours.empty()) image.colours = coloursFromBlob(colours, rays, what);
  return image;
}

RayGrid SessionStore::rays(std::int64_t id) {
  const std::string what = path() + ": rays " + std::to_string(id);
  Statement row =
      database_.prepare("SELECT rows, columns, receivers, data, " + intact("rays") + " FROM rays WHERE id = ?");
  if (!row.bind(1, id).step()) throw InvalidInput(what + " do not exist");
  mustBeIntact(row, 4, what);
  constexpr std::int64_t kMost = 1'000'000;
  const auto size = [&](int column) {
    return static_cast<int>(std::clamp<std::int64_t>(row.integer(column), 0, kMost));
  };
  return raysFromBlob(size(0), size(1), size(2), row.blob(3), what);
}

std::int64_t SessionStore::nextId(const std::string& table) {
  Statement row = database_.prepare("SELECT ifnull(max(id), 0) + 1 FROM " + table);
  row.step();
  return row.integer(0);
}

std::int64_t SessionStore::addRays(const RayGrid& rays) {
  const std::int64_t id = nextId("rays");
  database_.prepare(insertInto("rays"))
      .bind(1, id)
      .bind(2, std::int64_t{rays.rows()})
      .bind(3, std::int64_t{rays.columns()})
      .bind(4, static_cast<std::int64_t>(rays.receivers(0).size()))
      .bind(5, std::span<const std::byte>(raysBlob(rays)))
      .run();
  return id;
}

std::int64_t SessionStore::addScan(const RangeImage& image, std::int64_t rays) {
  const std::int64_t number = scanCount();
  Statement insert = database_.prepare(insertInto("scan"));
  insert.bind(1, number)
      .bind(2, std::int64_t{image.station.stand})
      .bindOptional(3, image.station.position)
      .bind(4, name(image.poseKnownBy));
  if (image.poseUncertainty)
    insert.bind(5, image.poseUncertainty->angleSigma).bind(6, image.poseUncertainty->positionSigma);
  insert.bind(7, std::string_view(image.takenWith))
      .bindOptional(8, rays == 0 ? std::nullopt : std::optional(rays))
      .bind(9, std::span<const std::byte>(poseBlob(image.T_table_scanner)))
      .bind(10, std::span<const std::byte>(rangeBlob(image.range)));
  if (!image.colours.empty()) insert.bind(11, std::span<const std::byte>(coloursBlob(image.colours)));
  insert.run();
  return number;
}

std::shared_ptr<const Model> SessionStore::model(std::int64_t step) {
  const std::string what = path() + ": model " + std::to_string(step);
  Statement row = database_.prepare("SELECT data, " + intact("model") + " FROM model WHERE step = ?");
  if (!row.bind(1, step).step()) return nullptr;
  mustBeIntact(row, 1, what);
  return std::make_shared<const Model>(modelFromBlob(row.blob(0), what));
}

std::shared_ptr<const Plan> SessionStore::plan(std::int64_t step) {
  const std::string what = path() + ": plan " + std::to_string(step);
  Statement row = database_.prepare("SELECT summary, data, " + intact("plan") + " FROM plan WHERE step = ?");
  if (!row.bind(1, step).step()) return nullptr;
  mustBeIntact(row, 2, what);
  auto plan = std::make_shared<Plan>(planFromText(row.text(0), what));
  addFromPlanBlob(*plan, row.blob(1), what);
  return plan;
}

std::int64_t SessionStore::nextStep() {
  return nextId("step");
}

void SessionStore::addEvent(const std::string& what, std::int64_t step) {
  database_.prepare(insertInto("event")).bind(1, nextId("event")).bind(2, std::string_view(what)).bind(3, step).run();
}

void SessionStore::addViews(const HistoryEntry& entry) {
  Statement insert = database_.prepare(insertInto("view"));
  Statement record = database_.prepare(insertInto("record"));
  const std::int64_t firstView = nextId("view");
  std::int64_t nextRecord = nextId("record");
  const std::vector<OutlinedScan>& scans = entry.outline->scans;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const OutlinedScan& scan = scans[i];
    insert.bind(1, firstView + static_cast<std::int64_t>(i))
        .bind(2, entry.step)
        .bind(3, static_cast<std::int64_t>(i))
        .bind(4, scan.scan)
        .bind(5, name(scan.status))
        .bind(6, std::span<const std::byte>(poseBlob(scan.T_object_scanner)))
        .bind(7, scan.recordStep)
        .bind(8, scan.planStep)
        .run();
    if (scan.recordStep == entry.step)
      record.bind(1, nextRecord++)
          .bind(2, entry.step)
          .bind(3, scan.scan)
          .bind(4, std::string_view(recordText(scan)))
          .run();
  }
}

void SessionStore::addStep(const HistoryEntry& entry, std::int64_t parent, const std::optional<PackedPlan>& newPlan) {
  const StateOutline& outline = *entry.outline;
  database_.prepare(insertInto("step"))
      .bind(1, entry.step)
      .bind(2, parent)
      .bind(3, kindOf(entry.command))
      .bind(4, std::string_view(commandText(entry.command)))
      .bind(5, std::string_view(settingsText(outline.settings)))
      .bind(6, name(outline.mode))
      .bind(7, std::string_view(standsText(outline.stands, outline.aside)))
      .bindOptional(8, outline.chosenPosition)
      .bind(9, name(outline.termination))
      .bind(10, static_cast<std::int64_t>(outline.scans.size()))
      .bind(11, outline.modelStep)
      .bind(12, outline.planStep)
      .bind(13, std::string_view(entry.hash ? hashText(*entry.hash) : std::string()))
      .run();
  addViews(entry);
  if (newPlan)
    database_.prepare(replaceIn("plan"))
        .bind(1, entry.step)
        .bind(2, std::string_view(newPlan->summary))
        .bind(3, std::span<const std::byte>(newPlan->data))
        .run();
  setMeta("tip", std::to_string(entry.step));
  moveCursor(entry.step, std::string(kindOf(entry.command)));
}

void SessionStore::addModel(std::int64_t step, const std::vector<std::byte>& blob) {
  database_.prepare(replaceIn("model")).bind(1, step).bind(2, std::span<const std::byte>(blob)).run();
  thinModels(step);
}

void SessionStore::moveCursor(std::int64_t step, const std::string& what) {
  setMeta("cursor", std::to_string(step));
  addEvent(what, step);
}

// When models take too much room, every second of the old ones goes, then every second of those that are left.
void SessionStore::thinModels(std::int64_t newest) {
  for (std::int64_t stride = 2; stride < newest; stride *= 2) {
    Statement size = database_.prepare("SELECT ifnull(sum(length(data)), 0) FROM model");
    size.step();
    if (size.integer(0) <= kModelBytes) return;
    database_.prepare("DELETE FROM model WHERE step % ? <> 0 AND step < ?").bind(1, stride).bind(2, newest - 4).run();
  }
}

}  // namespace vantage
