#pragma once

#include <chrono>
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
  /// When it was last seen to move on its way there; nothing where nobody can see that.
  std::optional<std::chrono::system_clock::time_point> movedUntil = {};
};

/// What brings the scanner to a position of its workspace, by moving the table or itself: a turntable, a person.
class Positioner : public Device {
 public:
  /// Moves, and returns when it stands there.
  /// @throws DeviceError for a position that the workspace does not have, and for whatever kept it from getting there,
  /// with what the operator can do about it; Cancelled: where() says what is then known.
  [[nodiscard]] virtual ReachedPose moveTo(int position, const Progress& progress) = 0;

  /// Hears that it really stands by so much farther round the table's axis than it says [rad, counter-clockwise from
  /// above], as a scan has shown. From then on it goes to where it is asked to from there; the poses that it says stay
  /// those of its own count.
  virtual void standsFarther(double /*angle*/) {}

  /// Where it stands; nothing when that is not known, for instance before the first move. Answers at once.
  [[nodiscard]] virtual std::optional<ReachedPose> where() const = 0;
};

/// The pose of a position as the workspace has it, for a positioner that knows no better.
/// @throws DeviceError when the workspace has no such position; it begins with the identity of the device.
[[nodiscard]] const Pose& workspacePose(const Positioner& positioner, const Workspace& workspace, int position);

}  // namespace vantage
