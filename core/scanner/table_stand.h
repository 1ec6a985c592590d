#pragma once

namespace vantage {

/// Where a table was left, in terms of its scanner: how far that stands round the axis, counter-clockwise from above.
struct TableStand {
  int position = 0;      ///< of the workspace
  double counted = 0.0;  ///< beyond that position, as the table says [rad]
  double farther = 0.0;  ///< beyond what the table says, as its scans have shown [rad]

  bool operator==(const TableStand&) const = default;
};

}  // namespace vantage
