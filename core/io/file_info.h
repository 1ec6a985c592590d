#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/progress.h"

namespace vantage {

/// What a file turned out to be.
enum class FileContent { Mesh, Model, Points, RangeImage, ScanPoses, Profile, Session };

/// "mesh", "model", "points", "range_image", "scan_poses", "profile", "session"
[[nodiscard]] std::string nameOf(FileContent content);

using FactValue = std::variant<std::int64_t, double, std::string, std::vector<double>>;

/// A file in key/value form, in the order in which it should be shown. Keys are snake_case and end in the unit, if any.
struct FileInfo {
  FileContent content = FileContent::Mesh;
  std::vector<std::pair<std::string, FactValue>> facts;

  /// @throws InvalidInput when there is no such fact.
  [[nodiscard]] const FactValue& at(const std::string& key) const;
};

/// A fact as text: numbers with six significant digits, vectors separated by " x ".
[[nodiscard]] std::string toText(const FactValue& value);

/// Reads a file, whatever it is of the kinds above, as far as it takes to describe and check it. A session is only
/// recognised by its first bytes.
/// @throws IoError, InvalidInput in one sentence with file, place and expectation for anything else
/// @throws Cancelled
[[nodiscard]] FileInfo describeFile(const std::string& path, const Progress& progress = {});

}  // namespace vantage
