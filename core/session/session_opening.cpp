#include "session/session_opening.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/errors.h"
#include "session/earlier_damages.h"
#include "session/session_check.h"
#include "session/session_migration.h"
#include "session/session_rescue.h"
#include "session/session_schema.h"
#include "session/session_store.h"
#include "session/stored_history.h"

namespace vantage {
namespace {

// The settings of a file by which a copy of its damages is known, so that it is not copied again every time.
constexpr const char* kCopy = "damaged_copy";
constexpr const char* kDamages = "damages";

std::size_t damagesOf(SessionStore& store) {
  const std::vector<Loss> losses = checkRows(store);
  return static_cast<std::size_t>(std::count_if(losses.begin(), losses.end(), isDamage));
}

// Whether the whole database can be read. Where only the last steps of very many are, what is read is looked at while
// it is.
bool isSound(Database& database, int version) {
  try {
    if (version > 1 && firstStepRead(database)) return true;
  } catch (const IoError&) {
    return false;
  }
  return database.sound();
}

// Version 1 had no steps.
void mustHaveFewSteps(Database& database, int version) {
  if (version > 1 && firstStepRead(database))
    throw InvalidInput(database.path() + ": is a session of an earlier version with more than " +
                       std::to_string(kMostSteps) + " steps, which none has; it stays as it is");
}

// A sound database as this version sees it, and how much of it is not as it was written.
struct Look {
  SessionStore store;
  std::vector<Loss> untrue;  ///< steps that are not as an earlier version wrote them
  std::size_t damages;
};

Look lookAt(Database database) {
  std::vector<Loss> untrue;
  if (const int version = checkSessionTables(database); version != kSessionSchema) {
    mustHaveFewSteps(database, version);
    untrue = earlierDamages(database, version);
    database = database.copyInMemory();
    migrateSession(database);
  }
  Look look{SessionStore(std::move(database)), std::move(untrue), 0};
  look.damages = look.untrue.size() + damagesOf(look.store);
  return look;
}

// Whether the file that is said to be a copy is one: beside the session, a session itself, and as damaged. Whatever
// path the session names, no other folder is looked into.
bool copiedBefore(SessionStore& store, const std::string& path, std::size_t damages) {
  namespace fs = std::filesystem;
  const fs::path name = fs::path(store.meta(kCopy)).filename();
  if (name.empty() || store.meta(kDamages) != std::to_string(damages)) return false;
  const fs::path copy = fs::absolute(path).parent_path() / name;
  std::error_code error;
  if (!fs::is_regular_file(copy, error) || fs::equivalent(copy, path, error)) return false;
  try {
    return lookAt(Database(copy.string(), Database::Mode::Read)).damages >= damages;
  } catch (const Error&) {
    return false;
  }
}

// What a session needs before it is written to.
struct Preparation {
  std::string copy;          ///< of a damaged session, made beside it; empty when it is sound
  std::vector<Loss> untrue;  ///< steps that are not as an earlier version wrote them
};

// Looks at a session before anything is written to it. One that is damaged is copied beside itself first.
Preparation prepareForWriting(const std::string& path, std::vector<Loss>& losses) {
  Preparation preparation;
  bool sound = true;
  {
    Database database(path, Database::Mode::Read);
    sound = isSound(database, checkSessionTables(database));
    if (sound) {
      Look look = lookAt(std::move(database));
      preparation.untrue = look.untrue;
      losses = look.untrue;
      if (look.damages == 0 || copiedBefore(look.store, path, look.damages)) return {};
    }
  }
  preparation.copy = copyBeside(path);
  losses.push_back({LossKind::Copied, {}, preparation.copy, {}});
  if (sound) return preparation;
  const std::vector<Loss> lost = rescueInPlace(path);
  losses.insert(losses.end(), lost.begin(), lost.end());
  return preparation;
}

// What the file itself does not tell any more.
void remember(SessionStore& store, const Preparation& preparation) {
  const std::size_t damages = damagesOf(store);
  Database::Transaction transaction(store.database());
  store.setMeta(kCopy, preparation.copy);
  store.setMeta(kDamages, std::to_string(damages));
  store.setUntrue(preparation.untrue);
  transaction.commit();
}

}  // namespace

Database openSessionForReading(const std::string& path, std::vector<Loss>& losses) {
  Database database(path, Database::Mode::Read);
  const int version = checkSessionTables(database);
  if (!isSound(database, version)) {
    Database copy = Database::inMemory(path);
    losses = rescueRows(database, copy);
    if (version != kSessionSchema) migrateSession(copy);
    return copy;
  }
  if (version == kSessionSchema) return database;
  mustHaveFewSteps(database, version);
  losses = earlierDamages(database, version);
  Database copy = database.copyInMemory();
  migrateSession(copy);
  return copy;
}

Database openSessionForWriting(const std::string& path, std::vector<Loss>& losses) {
  const Preparation preparation = prepareForWriting(path, losses);
  Database database(path, Database::Mode::Write);
  if (checkSessionTables(database) != kSessionSchema) migrateSession(database);
  if (preparation.copy.empty()) return database;
  SessionStore store(std::move(database));
  remember(store, preparation);
  return store.takeDatabase();
}

}  // namespace vantage
