#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "base/errors.h"
#include "cli/command.h"
#include "scanner/hand_table.h"
#include "scanner/rig.h"
#include "scanner/table_stand.h"

namespace vantage {

/// The person cannot turn the table there: another position is to be scanned from.
class PositionSkipped : public DeviceError {
 public:
  using DeviceError::DeviceError;
};

/// The person wants to end here.
class EndedByPerson : public DeviceError {
 public:
  using DeviceError::DeviceError;
};

/// The person says that the table stood where a refused scan was found to fit.
class TakenAsFrom : public DeviceError {
 public:
  using DeviceError::DeviceError;
};

/// Who turns the table, asked on standard error and answering on standard input with a line: done (or nothing), skip or
/// stop; after a scan that was refused and fits another turn of the table, also take. With events standard output
/// carries one JSON object per line instead, for a program that turns it:
/// {"event": "turn", "position": 7, "table_deg": 28.0, "by_deg": -12.0}.
class PersonAtTable {
 public:
  /// @param stand where the table stands
  PersonAtTable(std::shared_ptr<const ScannerProfile> profile, const TableStand& stand, bool events,
                CommandContext& context);

  /// Asks to turn the table to a position, and waits for the answer. A position that was skipped is not asked for
  /// again.
  /// @throws PositionSkipped; TakenAsFrom after offerTurn; EndedByPerson, also when nobody answers any more; Cancelled
  void ask(int position, const Progress& progress);

  /// Until the next answer `take` may be said as well: the scan that was refused fits at that turn [deg].
  void offerTurn(std::int64_t scan, double tableDeg);
  /// The table stands there [deg], as a scan has shown.
  void standsAt(double tableDeg) { angle_ = radians(tableDeg); }

  /// Tells a program what goes on; nothing without events.
  void tell(const nlohmann::ordered_json& event);

  /// The rig whose scans are told.
  [[nodiscard]] Rig told(Rig rig);

 private:
  [[nodiscard]] std::string answer(const Progress& progress);

  std::shared_ptr<const ScannerProfile> profile_;
  bool events_;
  CommandContext& context_;
  double angle_;         // of the table, from the first position [rad]
  std::string offered_;  // what may be taken, for the person
  std::set<int> skipped_;
  std::string typed_;  // after the last whole line
};

}  // namespace vantage
