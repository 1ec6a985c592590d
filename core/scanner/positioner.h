#pragma once

#include <optional>

#include "scanner/device.h"
#include "scanner/profile.h"
#include "scanner/station.h"

namespace vantage {

/// Where a positioner came to stand.
struct ReachedPose {
  int position = 0;                         ///< of the workspace
  Pose T_table_scanner = Pose::Identity();  ///< as far as anybody knows
  PoseSource knownBy = PoseSource::Unknown;
  std::optional<Mechanics> uncertainty;  ///< of one move; nothing where only the scanner's profile says something
};

/// What brings the scanner to a position of its workspace, by moving the table or itself: a turntable, a person.
class Positioner : public Device {
 public:
  /// Moves, and returns when it stands there.
  /// @throws DeviceError for a position that the workspace does not have, and for whatever kept it from getting there,
  /// with what the operator can do about it; Cancelled: where() says what is then known.
  [[nodiscard]] virtual ReachedPose moveTo(int position, const Progress& progress) = 0;

  /// Where it stands; nothing when that is not known, for instance before the first move. Answers at once.
  [[nodiscard]] virtual std::optional<ReachedPose> where() const = 0;
};

/// The pose of a position as the workspace has it, for a positioner that knows no better.
/// @throws DeviceError when the workspace has no such position; it begins with the identity of the device.
[[nodiscard]] const Pose& workspacePose(const Positioner& positioner, const Workspace& workspace, int position);

}  // namespace vantage
