#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "io/file_bytes.h"
#include "io/ply_header.h"

namespace vantage {

/// Names a property of an element that is to be read.
struct PlySelection {
  std::string_view element;
  std::string_view property;
};

/// All values of one property. A scalar has one value per row; row i of a list has the values from start[i] up to
/// start[i + 1].
struct PlyColumn {
  std::vector<double> values;
  std::vector<std::size_t> start;  ///< rows + 1 entries for a list, none for a scalar
};

/// The selected columns of a PLY file.
class PlyDocument {
 public:
  /// Per element and property; nothing where a column was not selected.
  using Columns = std::vector<std::vector<std::optional<PlyColumn>>>;

  PlyDocument(PlyHeader header, Columns columns, std::size_t bytesLeftOver);

  [[nodiscard]] const PlyHeader& header() const { return header_; }
  /// Of the file, behind the rows that its header tells; blanks at the end of text aside.
  [[nodiscard]] std::size_t bytesLeftOver() const { return bytesLeftOver_; }
  /// The column, or nothing when the file has no such property or it was not selected.
  [[nodiscard]] const PlyColumn* find(std::string_view element, std::string_view property) const;

 private:
  PlyHeader header_;
  Columns columns_;
  std::size_t bytesLeftOver_;
};

/// Reads ascii, little and big endian files. Everything is checked against the size of the file before memory is asked
/// for.
/// @throws InvalidInput naming file, place and expectation for a broken header, a value that is no number or out of its
///         type's range, a negative list length, or rows that end early.
/// @throws Cancelled
[[nodiscard]] PlyDocument readPlyDocument(const FileBytes& file, std::span<const PlySelection> wanted,
                                          const Progress& progress = {});

}  // namespace vantage
