#include "session/session.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include "acquisition/apply_command.h"
#include "base/errors.h"
#include "geometry/geometry_hash.h"
#include "io/placement.h"
#include "session/model_writer.h"
#include "session/session_blobs.h"
#include "session/session_check.h"
#include "session/session_json.h"
#include "session/session_lock.h"
#include "session/session_opening.h"
#include "session/session_rescue.h"
#include "session/session_schema.h"
#include "session/session_states.h"
#include "session/session_store.h"
#include "session/state_hash.h"

namespace vantage {
namespace {

// Which file a name stands for.
std::pair<std::uint64_t, std::uint64_t> fileBehind(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return {0, 0};
  return {static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino)};
}

// A transaction around one change of a session.
template <typename Change>
void transact(SessionStore& store, const Change& change) {
  Database::Transaction transaction(store.database());
  change();
  transaction.commit();
}

// The model that a step made; null when it made none.
std::shared_ptr<const Model> modelMadeIn(std::int64_t step, const StateOutline& outline,
                                         const AcquisitionState& state) {
  if (outline.modelStep == step) return state.model;
  for (std::size_t i = 0; i < outline.aside.size(); ++i)
    if (outline.aside[i].step == step) return state.aside[i].model;
  return nullptr;
}

}  // namespace

struct Session::Parts {
  Parts(const std::string& name, SessionAccess sessionAccess, std::optional<SessionLock> sessionLock, Database database)
      : path(name),
        access(sessionAccess),
        lock(std::move(sessionLock)),
        store(std::move(database)),
        states(store, losses),
        history([this](const HistoryEntry& entry) { return stateOf(entry); }),
        file(fileBehind(name)),
        models(store, mutex) {}

  [[nodiscard]] std::shared_ptr<const AcquisitionState> stateOf(const HistoryEntry& entry) {
    const std::lock_guard guard(mutex);
    return std::make_shared<const AcquisitionState>(states.state(history, entry));
  }

  // Without a profile the one in the file is read.
  void restore(std::shared_ptr<const ScannerProfile> profile = nullptr) {
    if (!profile) profile = SessionStates::parsed(store.profileSource());
    states.setProfile(std::move(profile));
    for (const char* table : {"meta", "file"})
      for (const Loss& loss : store.changedRows(table)) lose(loss);
    for (const Loss& loss : store.untrue()) lose(loss);
    StoredHistory stored = store.history();
    for (const Loss& loss : stored.losses) lose(loss);
    states.dropImpossible(stored);
    if (stored.entries.empty())
      throw InvalidInput(path + ": no step of the session is readable; its scans may still be in the table scan");
    history.restore(std::move(stored.entries), stored.cursor);
  }

  void lose(const Loss& loss) {
    if (std::find(losses.begin(), losses.end(), loss) == losses.end()) losses.push_back(loss);
  }

  void mustBeWritable() const {
    if (access == SessionAccess::Read) throw InvalidInput(path + ": is open for reading only");
  }

  // Who removes or replaces the file of an open session would lose everything from then on, without a word.
  void mustBeInPlace() {
    if (fileBehind(path) == file) return;
    if (refuge.empty()) {
      const std::string copy = freeName(path, ".rescued");
      store.database().copyTo(copy);
      refuge = copy;
    }
    throw IoError(path, "was removed or replaced while it was open; the whole session was written to " + refuge);
  }

  void add(const Command& command, AcquisitionState state) {
    auto shared = std::make_shared<const AcquisitionState>(std::move(state));
    auto hash = std::async(std::launch::async, [&shared] { return stateHash(*shared); });
    HistoryEntry entry{store.nextStep(), command, nullptr, {}};
    const bool first = history.size() == 0;
    const StateOutline none;
    const StateOutline& before = first ? none : *history.current().outline;
    entry.outline = std::make_shared<const StateOutline>(states.outline(*shared, before, entry.step));
    std::optional<PackedPlan> newPlan;
    if (entry.outline->planStep == entry.step) newPlan = PackedPlan{planText(*shared->plan), planBlob(*shared->plan)};
    entry.hash = hash.get();
    transact(store, [&] { store.addStep(entry, first ? 0 : history.current().step, newPlan); });
    states.remember(*entry.outline, *shared);
    const std::int64_t step = entry.step;
    std::shared_ptr<const Model> newModel = modelMadeIn(step, *entry.outline, *shared);
    history.add(std::move(entry), shared);
    if (newModel) models.write(step, std::move(newModel));
  }

  void move(void (History::*there)(), void (History::*back)(), const char* what) {
    const std::lock_guard guard(mutex);
    mustBeWritable();
    (history.*there)();
    try {
      transact(store, [&] { store.moveCursor(history.current().step, what); });
    } catch (...) {
      (history.*back)();
      throw;
    }
  }

  std::string path;
  SessionAccess access;
  std::optional<SessionLock> lock;
  std::vector<Loss> losses;
  SessionStore store;
  SessionStates states;
  History history;
  std::pair<std::uint64_t, std::uint64_t> file;
  std::string refuge;
  std::recursive_mutex mutex;
  ModelWriter models;  // last: it ends before the rest of the session does
};

Session::Session(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(Session&& other) noexcept = default;
Session::~Session() = default;

namespace {

// Writes a new session under another name.
void writeNew(const std::string& path, const SessionStart& start,
              const std::shared_ptr<const ScannerProfile>& profile) {
  Session::Parts parts(path, SessionAccess::Write, std::nullopt, Database(path, Database::Mode::Create));
  SessionStore& store = parts.store;
  transact(store, [&] {
    createSessionTables(store.database());
    if (start.profile) store.setProfileSource(*start.profile);
    if (start.object != nullptr) store.setObject(*start.object);
  });
  AcquisitionState empty;
  empty.profile = profile;
  const ChangeSettings command{start.settings};
  parts.add(command, applyCommand(empty, command, {}, {}));
}

}  // namespace

// A name beside the session that nothing has.
std::string unfinishedName(const std::string& path) {
  for (int i = 0;; ++i) {
    std::string name = path + "." + std::to_string(i) + ".new";
    if (!std::filesystem::exists(std::filesystem::symlink_status(name))) return name;
  }
}

void removeParts(const std::string& path) {
  std::error_code error;
  for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path + suffix, error);
}

// A second name for the file, which fails where the name is taken. Some file systems give a file one name only.
void putIntoPlace(const std::string& unfinished, const std::string& path) {
  std::error_code error;
  std::filesystem::create_hard_link(unfinished, path, error);
  if (error == std::errc::file_exists) throw IoError(path, "is there already and stays as it is: choose another name");
  if (!error) return static_cast<void>(std::filesystem::remove(unfinished, error));
  if (std::filesystem::exists(std::filesystem::symlink_status(path)))
    throw IoError(path, "is there already and stays as it is: choose another name");
  std::filesystem::rename(unfinished, path, error);
  if (error) throw IoError(path, "cannot be written: " + error.message());
}

// A session appears whole or not at all.
Session Session::create(const std::string& path, const SessionStart& start) {
  SessionLock lock(path);
  if (std::filesystem::exists(std::filesystem::symlink_status(path)))
    throw IoError(path, "is there already and stays as it is: choose another name");
  auto profile = start.scanner ? start.scanner : SessionStates::parsed(start.profile);
  const std::string unfinished = unfinishedName(path);
  try {
    writeNew(unfinished, start, profile);
    putIntoPlace(unfinished, path);
  } catch (...) {
    removeParts(unfinished);
    throw;
  }
  auto parts =
      std::make_unique<Parts>(path, SessionAccess::Write, std::move(lock), Database(path, Database::Mode::Write));
  parts->restore(std::move(profile));
  return Session(std::move(parts));
}

Session Session::open(const std::string& path, SessionAccess access, const Progress& progress) {
  if (!std::filesystem::is_regular_file(path)) throw IoError(path, "is no session: there is no such file");
  std::vector<Loss> losses;
  std::unique_ptr<Parts> parts;
  if (access == SessionAccess::Read) {
    parts = std::make_unique<Parts>(path, access, std::nullopt, openSessionForReading(path, losses));
  } else {
    SessionLock lock(path);
    Database database = openSessionForWriting(path, losses);
    parts = std::make_unique<Parts>(path, access, std::move(lock), std::move(database));
  }
  progress.checkpoint(0.5);
  parts->losses = std::move(losses);
  parts->restore();
  // What is to be gone on with is held against its hash at once.
  if (access == SessionAccess::Write) {
    parts->states.setProgress(progress.part(0.5, 1.0));
    static_cast<void>(parts->history.state(parts->history.cursor()));
    parts->states.setProgress({});
  }
  progress.checkpoint(1.0);
  return Session(std::move(parts));
}

const std::string& Session::path() const {
  return parts_->path;
}

std::vector<Loss> Session::losses() const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->losses;
}

void Session::check(const Progress& progress) const {
  const std::lock_guard guard(parts_->mutex);
  for (const Loss& loss : checkRows(parts_->store, progress.part(0.0, 0.5))) parts_->lose(loss);
  const std::size_t steps = parts_->history.size();
  std::shared_ptr<const AcquisitionState> before;  // what states share is read once
  for (std::size_t i = 0; i < steps; ++i) {
    progress.checkpoint(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(steps));
    before = parts_->history.state(i);
  }
}

const History& Session::history() const {
  return parts_->history;
}

std::shared_ptr<const AcquisitionState> Session::state() const {
  return state(parts_->history.cursor());
}

std::shared_ptr<const AcquisitionState> Session::state(std::size_t index) const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->history.state(index);
}

std::shared_ptr<const Model> Session::model(std::size_t index) const {
  const std::lock_guard guard(parts_->mutex);
  const HistoryEntry& entry = parts_->history.entry(index);
  if (entry.outline->modelStep == 0) return nullptr;
  const std::size_t views = countScans(*entry.outline, ScanStatus::In);
  if (auto model = parts_->states.model(entry.outline->modelStep, views)) return model;
  return parts_->history.state(index)->model;
}

std::shared_ptr<const Plan> Session::plan(std::size_t index) const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->states.plan(parts_->history.entry(index).outline->planStep);
}

std::int64_t Session::scanCount() const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->store.scanCount();
}

std::shared_ptr<const RangeImage> Session::scan(std::int64_t number) const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->states.scan(number);
}

std::shared_ptr<const ScannerProfile> Session::profile() const {
  return parts_->states.profile();
}

Mesh Session::object(const Progress& progress) const {
  std::unique_lock guard(parts_->mutex);
  auto stored = parts_->store.object();
  const AcquisitionSettings settings = parts_->history.current().outline->settings;
  guard.unlock();
  if (!stored) throw InvalidInput(path() + ": has no object that a simulated scanner could look at");
  if (stored->mesh) return std::move(*stored->mesh);
  if (!profile())
    throw InvalidInput(path() + ": its scanner profile is lost, without which its object cannot be placed");
  const std::string& file = settings.simulation.object;
  const PlacementOptions placement{settings.simulation.placement, settings.simulation.unit};
  Mesh object;
  try {
    object = loadPlacedMesh(file, placement, profile()->viewingVolume, progress).mesh;
  } catch (const InvalidInput&) {
    // The file is named by a session from anywhere: what is in it is nobody's business.
    throw InvalidInput(file + ": is not the mesh that " + path() + " was begun with, which needs it as it was");
  }
  if (hashText(contentHash(object)) != stored->hash)
    throw InvalidInput(file + ": has changed since " + path() + " was begun, which needs it as it was");
  return object;
}

NumberedScan Session::keepScan(RangeImage image) {
  validate(image);
  const std::lock_guard guard(parts_->mutex);
  parts_->mustBeWritable();
  const auto shared = std::make_shared<const RangeImage>(std::move(image));
  StoredScan scan;
  transact(parts_->store, [&] { scan = parts_->states.keep(*shared); });
  parts_->states.remember(scan, shared);
  parts_->mustBeInPlace();
  return {scan.number, shared};
}

std::optional<NumberedScan> Session::unusedScan() const {
  const std::lock_guard guard(parts_->mutex);
  const std::int64_t last = parts_->store.scanCount() - 1;
  if (last < 0 || parts_->store.scanUsed(last)) return std::nullopt;
  try {
    return NumberedScan{last, parts_->states.scan(last)};
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

std::optional<Station> Session::lastStation() const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->store.lastStation();
}

void Session::record(const Command& command, AcquisitionState state) {
  const std::lock_guard guard(parts_->mutex);
  parts_->mustBeWritable();
  parts_->add(command, std::move(state));
  parts_->mustBeInPlace();
}

void Session::undo() {
  parts_->move(&History::undo, &History::redo, "undo");
}

void Session::redo() {
  parts_->move(&History::redo, &History::undo, "redo");
}

std::string Session::note(const std::string& key) const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->store.meta("note:" + key);
}

void Session::setNote(const std::string& key, const std::string& text) {
  const std::lock_guard guard(parts_->mutex);
  parts_->mustBeWritable();
  transact(parts_->store, [&] { parts_->store.setMeta("note:" + key, text); });
}

void Session::settle() const {
  parts_->models.settle();
}

void Session::copyTo(const std::string& path) const {
  settle();
  const std::lock_guard guard(parts_->mutex);
  parts_->store.database().copyTo(path);
}

}  // namespace vantage
