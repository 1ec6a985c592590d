#include "calibration/calibration_scans.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kUsualTurn = 30.0;  // [deg]
constexpr double kMostTurn = 200.0;  // [deg] in all

void requireReady(const Device& device) {
  if (const auto reason = device.notReady()) throw DeviceError(device.identity() + ": " + *reason);
}

}  // namespace

std::vector<double> calibrationAngles(int scans) {
  if (scans < 3 || scans > 12)
    throw InvalidInput(std::to_string(scans) + " scans are no calibration, expected 3 to 12");
  const int turns = scans - 1;
  // Turns as 4 : 5 : 6 ...
  const double parts = turns * (4.0 + 0.5 * (turns - 1));
  const double whole = std::min(kUsualTurn * turns, kMostTurn);
  std::vector<double> angles{0.0};
  double passed = 0.0;
  for (int k = 0; k < turns; ++k) {
    passed += 4.0 + k;
    angles.push_back(std::round(whole * passed / parts));
  }
  return angles;
}

std::vector<CalibrationScan> takeCalibrationScans(RangeSensor& sensor, Turntable& table, std::span<const double> angles,
                                                  const Progress& progress, bool turnFirst) {
  requireReady(table);
  requireReady(sensor);
  const auto now = table.angle();
  const double begin = (now ? now->degrees : 0.0) + (turnFirst ? 360.0 : 0.0);
  std::vector<CalibrationScan> scans;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const auto part = [&](double from, double to) {
      const double count = static_cast<double>(angles.size());
      return progress.part((static_cast<double>(k) + from) / count, (static_cast<double>(k) + to) / count);
    };
    sensor.announceMove();
    const TableAngle reached = table.turnTo(begin + angles[k], part(0.0, 0.5));
    sensor.standAt({static_cast<int>(k), Pose::Identity(), reached.knownBy, {}, reached.turnedUntil});
    RangeImage image = sensor.capture(part(0.5, 1.0));
    validate(image);
    scans.push_back({std::make_shared<const RangeImage>(std::move(image)), reached.degrees});
  }
  return scans;
}

}  // namespace vantage
