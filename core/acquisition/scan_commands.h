#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "acquisition/refusal.h"

namespace vantage {

class CommandTools;

// What every command says of itself is told in acquisition/command.h.

/// A scan that came in is registered, integrated and planned from.
struct AddScan {
  static constexpr std::string_view kKind = "add_scan";
  std::int64_t scan = 0;                   ///< number of the scan in its session
  std::optional<PositionScore> predicted;  ///< what was promised of its position

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("scan", self.scan);
    field("predicted", self.predicted);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// Recorded scans are registered with each other and integrated, all at once.
struct ImportScans {
  static constexpr std::string_view kKind = "import_scans";
  std::vector<std::int64_t> scans;
  std::vector<ScanReading> readings = {};  ///< as what every scan was read; none where that is not known

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("scans", self.scans);
    field("readings", self.readings);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// A view stays out of the model until it is taken back.
struct LeaveOutView {
  static constexpr std::string_view kKind = "leave_out";
  std::int64_t scan = 0;

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("scan", self.scan);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

struct TakeBackView {
  static constexpr std::string_view kKind = "take_back";
  std::int64_t scan = 0;

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("scan", self.scan);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// A scan that was refused is taken as from another turn of the table, one that it was found to fit: whoever turned it
/// says that it stood there.
struct TakeAsFrom {
  static constexpr std::string_view kKind = "take_as_from";
  std::int64_t scan = 0;
  double tableDeg = 0.0;  ///< from the first position, counter-clockwise seen from above [deg]

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("scan", self.scan);
    field("table_deg", self.tableDeg);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  /// @throws InvalidInput also when it does not fit there any more: the model has changed
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// Views are taken over from a session file of an earlier version, which did not record how they came about.
struct TakeOver {
  static constexpr std::string_view kKind = "take_over";

  template <typename Self, typename Field>
  static void fields(Self& /*self*/, Field&& /*field*/) {}
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// Commands that bring scans in, leave them out and take them back.
using ScanCommand = std::variant<AddScan, ImportScans, LeaveOutView, TakeBackView, TakeAsFrom, TakeOver>;

}  // namespace vantage
