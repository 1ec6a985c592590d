#pragma once

#include <optional>
#include <string>

#include "acquisition/acquisition_state.h"
#include "acquisition/database.h"
#include "base/progress.h"

namespace vantage {

/// What a session holds.
struct Session {
  AcquisitionState state;  ///< records hold position and counts only
  AcquisitionSettings settings;
};

/// A session on disk: an SQLite database with every scan as it came and what was made of it.
///
///   meta(key, value)                         version of the schema, settings, why it ended
///   file(name, content)                      the profile as it was read, and the files it names; none for recorded
///   scans rays(id, rows, columns, receivers, data) ranging rays of recorded scans scan(id, position, rays, nominal,
///   range) range images in the order they came; range is zstd over 32-bit floats view(id, scan, pose, samples,
///   triangles) the scans that were integrated, where they were found model(id, data)                          the
///   model that they led to, zstd
class SessionFile {
 public:
  /// Makes a new, empty session; one of that name is replaced.
  /// @param profile of the scanner; none for recorded scans.
  [[nodiscard]] static SessionFile create(const std::string& path, const std::optional<ProfileSource>& profile,
                                          const AcquisitionSettings& settings);

  /// @throws IoError when it is missing or no database, InvalidInput when it is not a session of ours.
  [[nodiscard]] static SessionFile open(const std::string& path);

  /// Writes what is new in the state, all or nothing.
  void save(const AcquisitionState& state);

  /// Reads it all. @throws IoError, InvalidInput naming the part that is damaged; Cancelled
  [[nodiscard]] Session load(const Progress& progress);

 private:
  explicit SessionFile(Database database) : database_(std::move(database)) {}

  void saveScans(const AcquisitionState& state);
  void saveViews(const AcquisitionState& state);
  [[nodiscard]] std::int64_t saveRays(const RayGrid& rays);
  [[nodiscard]] std::optional<ProfileSource> loadProfileSource();
  [[nodiscard]] AcquisitionSettings loadSettings();

  Database database_;
  std::vector<std::shared_ptr<const RangeImage>> savedScans_;
  std::shared_ptr<const RayGrid> profileRays_;
};

}  // namespace vantage
