#pragma once

#include <chrono>
#include <optional>

#include "scanner/device.h"
#include "scanner/station.h"

namespace vantage {

/// What a turntable says of its angle.
struct TableAngle {
  double degrees = 0.0;                      ///< as the table counts, not reduced to one turn
  PoseSource knownBy = PoseSource::Unknown;  ///< Reported where the device tells it, Commanded where it cannot
  /// When it was last seen to turn on its way there; nothing where nobody can see that.
  std::optional<std::chrono::system_clock::time_point> turnedUntil = {};
};

/// A table that turns to an angle of its own count. Which way and how far it really turns is for its calibration to say
/// (see TurntablePositioner).
class Turntable : public Device {
 public:
  /// Hears before every turn which position of the workspace it is for. Most tables need not know; what runs a program
  /// may.
  virtual void headFor(int /*position*/) {}

  /// Turns, and returns when it is at rest there.
  /// @throws DeviceError for whatever kept it from getting there, with what the operator can do about it; Cancelled:
  /// the table was told to stop, and angle() says what is then known
  [[nodiscard]] virtual TableAngle turnTo(double degrees, const Progress& progress) = 0;

  /// Turns by so many degrees, also when it is not known where it stands: to bring it to a mark.
  /// @return where it then stands; nothing when that is still not known. @throws as turnTo
  [[nodiscard]] virtual std::optional<TableAngle> jog(double degrees, const Progress& progress);

  /// Asks it where it stands and how it is: what has become of it since it was last spoken to is known afterwards.
  /// Tables that cannot be asked stay as they are known. @throws DeviceError, Cancelled
  virtual void ask(const Progress& /*progress*/) {}

  /// Where it stands; nothing when that is not known: before the first move of some tables, after a reset. At once.
  [[nodiscard]] virtual std::optional<TableAngle> angle() const = 0;

  /// Makes where it stands, or its index, its zero. @throws DeviceError also when the table has nothing of the kind
  virtual void home(const Progress& progress) = 0;
};

}  // namespace vantage
