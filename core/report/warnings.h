#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "base/phrase.h"

namespace vantage {

/// What is not well about an acquisition although it was carried out.
enum class WarningCode : std::uint8_t {
  ScanRejected,     ///< the scan did not find its place and is not in the model
  ScanDoubtful,     ///< it is in the model, but something speaks against its pose
  ScanWaiting,      ///< it is not known how the object stood for it
  NothingCovered,   ///< the model has no surface
  LittleCovered,    ///< positions would still show more than a small share of the model [share]
  EndedEarly,       ///< the acquisition ended for another reason than that nothing more is to be seen
  TableTurnsBack,   ///< the scan fits where the table would have turned the other way
  StandNotAligned,  ///< the stand is not part of the object
  StandDoubtful,    ///< it is only since the operator uses it although something speaks against it
};
inline constexpr WarningCode kLastWarningCode = WarningCode::StandDoubtful;
/// "scan_rejected", "scan_doubtful", ...
[[nodiscard]] std::string_view name(WarningCode code);

struct Warning {
  WarningCode code = WarningCode::NothingCovered;
  std::optional<std::int64_t> scan;        ///< its number, for warnings of scans
  std::optional<Finding> finding;          ///< what its verdict rests on
  std::optional<double> value;             ///< what the code says; how far a scan turned by hand may be off [mm]
  std::optional<Termination> termination;  ///< of an acquisition that ended early
  std::optional<int> stand = {};           ///< for warnings of stands
  std::shared_ptr<const StandAlignment> alignment = nullptr;  ///< of that stand, where one was tried
};

/// Whether it speaks against the result. A scan of a body of revolution, say, that surface and mechanics hold together
/// is as good as it can be: that is said, and no more. Where a person turned the table, mechanics hold nothing.
[[nodiscard]] bool isSerious(const Warning& warning);

/// What is not well about the scans from the index on, and about the whole.
[[nodiscard]] std::vector<Warning> warningsOf(const AcquisitionState& state, std::size_t firstScan = 0);

/// "scan 3 was rejected: only 12 % of the expected overlap fits".
[[nodiscard]] Phrase phraseOf(const Warning& warning);

}  // namespace vantage
