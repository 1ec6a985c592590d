#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// The set-up of a session is changed. Also the first command of every session.
struct ChangeSettings {
  AcquisitionSettings settings;
};

/// A scan that came in is registered, integrated and planned from.
struct AddScan {
  std::int64_t scan = 0;                   ///< number of the scan in its session
  std::optional<PositionScore> predicted;  ///< what was promised of its position
};

/// Recorded scans are registered with each other and integrated, all at once.
struct ImportScans {
  std::vector<std::int64_t> scans;
};

/// The operator wants another position than the proposed one next; nothing goes back to the proposal.
struct ChoosePosition {
  std::optional<int> position;
};

/// A view stays out of the model until it is taken back.
struct LeaveOutView {
  std::int64_t scan = 0;
};
struct TakeBackView {
  std::int64_t scan = 0;
};

/// The acquisition is ended, or, with Running, opened again.
struct Finish {
  Termination termination = Termination::EndedByOperator;
};

/// The object was turned over: from now on scans are of a new stand.
struct TurnObject {
  std::optional<Pose> T_object_table;  ///< how it stands now; nothing while nobody knows
};

/// It became known how the object stands in a stand: scans of it that were waiting become views.
struct PlaceStand {
  int stand = 0;
  Pose T_object_table = Pose::Identity();
};

/// From now on the next step is taken by the program, or by a person.
struct ChangeMode {
  Mode mode = Mode::Automatic;
};

/// Views are taken over from a session file of an earlier version, which did not record how they came about.
struct TakeOver {};

/// Everything that an operator or an automatic run does to a session. Undo and redo move between the results.
using Command = std::variant<ChangeSettings, AddScan, ImportScans, ChoosePosition, LeaveOutView, TakeBackView, Finish,
                             TakeOver, TurnObject, PlaceStand, ChangeMode>;

/// "change_settings", "add_scan", ...: how the session file names a command's kind.
[[nodiscard]] std::string_view kindOf(const Command& command);

}  // namespace vantage
