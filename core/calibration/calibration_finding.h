#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scanner/table_calibration.h"

namespace vantage {

/// What was found when a table was calibrated.
enum class CalibrationReason : std::uint8_t {
  // With these it has failed.
  NothingTurns,           ///< fewer than three scans show enough that moves [samples of the scan that has fewest]
  TooSmallTurn,           ///< the table turned too little in all [deg]
  RotationNotObservable,  ///< what was scanned looks the same however it is turned [mm that the axis is unsure by]
  NoCommonAxis,           ///< no turn about one axis brings the scans, or that scan, together [misfit, 0..1]
  Slip,                   ///< the table stands elsewhere than it counts from this scan on [deg]
  // With these it is doubtful.
  Rival,          ///< another way of turning fits nearly as well [turned / counted]
  Unsure,         ///< the axis is unsure [mm]
  ResidualLarge,  ///< scans do not fit a pure turn as noise and spacing explain [multiples of that]
  PlaneLeans,     ///< the table top leans against the axis: it wobbles, or is no table top [deg]
  TableNotSeen,   ///< no scan shows the table top: its height is a guess [mm that it may be off by]
  // These an operator should know.
  TurnsOtherWay,  ///< the table counts upwards as it turns clockwise
  OtherRatio,     ///< a degree that it counts is not a degree that it turns [turned / counted]
};
inline constexpr CalibrationReason kLastCalibrationReason = CalibrationReason::OtherRatio;

/// "nothing_turns", "too_small_turn", ...
[[nodiscard]] std::string_view name(CalibrationReason reason);

struct CalibrationFinding {
  CalibrationReason reason = CalibrationReason::NothingTurns;
  std::optional<double> value;      ///< what was measured, in the unit of the reason
  std::optional<std::size_t> scan;  ///< that it is about

  friend bool operator==(const CalibrationFinding&, const CalibrationFinding&) = default;
};
/// What it means, and what to do about it, as one sentence.
[[nodiscard]] std::string describe(const CalibrationFinding& finding);
/// What a calibration with that finding is worth at most.
[[nodiscard]] CalibrationVerdict worthOf(const CalibrationFinding& finding);

}  // namespace vantage
