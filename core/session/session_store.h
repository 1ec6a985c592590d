#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integration/model.h"
#include "planning/plan.h"
#include "session/database.h"
#include "session/stored_history.h"

namespace vantage {

/// A plan as it lies in the file: see planText and planBlob.
struct PackedPlan {
  std::string summary;
  std::vector<std::byte> data;
};

/// The profile of a session of any version; nothing when there is none.
[[nodiscard]] std::optional<ProfileSource> profileSourceIn(Database& database);

/// The rows of a session file as values (see session_schema.h). Keeps nothing in memory. Readers take nothing on trust:
/// @throws InvalidInput naming the part that is damaged, IoError when the database fails.
class SessionStore {
 public:
  explicit SessionStore(Database database) : database_(std::move(database)) {}

  [[nodiscard]] Database& database() { return database_; }
  /// The store is not to be used any more.
  [[nodiscard]] Database takeDatabase() { return std::move(database_); }
  [[nodiscard]] const std::string& path() const { return database_.path(); }

  [[nodiscard]] std::string meta(const std::string& key);
  void setMeta(const std::string& key, const std::string& value);

  [[nodiscard]] std::optional<ProfileSource> profileSource();
  void setProfileSource(const ProfileSource& source);
  /// How many of the files that belong to the profile are not there.
  [[nodiscard]] std::int64_t lostFiles();

  /// The object of the simulated scanner: its content, when it was not too large to be kept, and its contentHash.
  struct StoredObject {
    std::optional<Mesh> mesh;
    std::string hash;
  };
  [[nodiscard]] std::optional<StoredObject> object();
  void setObject(const Mesh& mesh);

  [[nodiscard]] StoredHistory history();

  /// Steps that were not as an earlier version had written them when they were brought up to date.
  [[nodiscard]] std::vector<Loss> untrue();
  void setUntrue(const std::vector<Loss>& steps);

  /// The rows of a table that are not as they were written; of a file with very many steps the last kMostSteps are
  /// looked at.
  [[nodiscard]] std::vector<Loss> changedRows(const std::string& table);

  /// One more than the highest number of a scan.
  [[nodiscard]] std::int64_t scanCount();
  [[nodiscard]] std::vector<std::int64_t> scanNumbers();
  [[nodiscard]] bool scanUsed(std::int64_t number);
  /// Where the last scan was taken; nothing without scans.
  [[nodiscard]] std::optional<Station> lastStation();
  /// The number of a scan's ray grid; 0 for the profile's.
  [[nodiscard]] std::int64_t raysOf(std::int64_t scan);
  /// A scan of so many rays; its ray grid stays unset.
  [[nodiscard]] RangeImage scan(std::int64_t number, std::size_t rays);
  [[nodiscard]] RayGrid rays(std::int64_t id);
  /// @param rays 0 for the profile's. @return the number
  std::int64_t addScan(const RangeImage& image, std::int64_t rays);
  std::int64_t addRays(const RayGrid& rays);

  /// Null when it is not there, which is no damage: it can be made again.
  [[nodiscard]] std::shared_ptr<const Model> model(std::int64_t step);
  [[nodiscard]] std::shared_ptr<const Plan> plan(std::int64_t step);

  /// A step with what is new in it except its model, and the cursor on it.
  void addStep(const HistoryEntry& entry, std::int64_t parent, const std::optional<PackedPlan>& newPlan);
  void moveCursor(std::int64_t step, const std::string& what);
  [[nodiscard]] std::int64_t nextStep();
  /// The model that a step led to, as modelBlob packs it.
  void addModel(std::int64_t step, const std::vector<std::byte>& blob);

 private:
  [[nodiscard]] std::int64_t nextId(const std::string& table);
  void addViews(const HistoryEntry& entry);
  void addEvent(const std::string& what, std::int64_t step);
  void thinModels(std::int64_t newest);

  Database database_;
};

}  // namespace vantage
