#include "scanner/rig.h"

#include "base/errors.h"

namespace vantage {
namespace {

void requireReady(const Device& device) {
  if (const auto reason = device.notReady()) throw DeviceError(device.identity() + ": " + *reason);
}

}  // namespace

Rig opened(Rig rig, const Progress& progress) {
  rig.positioner->open(progress.part(0.0, 0.5));
  rig.sensor->open(progress.part(0.5, 1.0));
  return rig;
}

RangeImage scanFrom(const Rig& rig, int position, const Progress& progress) {
  requireReady(*rig.positioner);
  requireReady(*rig.sensor);
  rig.sensor->announceMove();
  const ReachedPose reached = rig.positioner->moveTo(position, progress.part(0.0, 0.3));
  rig.sensor->standAt(reached);
  RangeImage image = rig.sensor->capture(progress.part(0.3, 1.0));
  image.T_table_scanner = reached.T_table_scanner;
  image.poseKnownBy = reached.knownBy;
  image.poseUncertainty = reached.uncertainty;
  image.takenWith = rig.sensor->identity() + "; " + rig.positioner->identity();
  image.station.position = reached.position;
  return image;
}

}  // namespace vantage
