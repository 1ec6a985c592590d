#pragma once

#include <optional>
#include <string>

#include "devices/serial/table_profile.h"

namespace vantage {

/// One report of a table.
struct StatusReport {
  TableState state = TableState::Unknown;
  std::string word;                ///< the state as the firmware calls it
  std::optional<double> position;  ///< [units] in machine coordinates; nothing while the offset is not known
  std::optional<double> count;     ///< changes while the motor turns
};

/// Reads reports whose fields come in any order and not all of them every time.
class StatusReader {
 public:
  /// @param profile outlives the reader
  explicit StatusReader(const TableProfile& profile) : profile_(profile) {}

  /// Nothing when the message is no report, or a damaged one.
  /// @throws DeviceError when the table reports positions, but not of the axis of its profile
  [[nodiscard]] std::optional<StatusReport> read(const std::string& message);

  /// Whether the board reports lengths in inches.
  void setInches(bool inches) { inches_ = inches; }
  /// The offset of work coordinates is no longer known.
  void forget() { offset_.reset(); }

 private:
  [[nodiscard]] std::optional<double> field(const std::optional<MessagePattern>& pattern,
                                            const std::string& message) const;

  const TableProfile& profile_;
  bool inches_ = false;
  std::optional<double> offset_;  // as reported
};

}  // namespace vantage
