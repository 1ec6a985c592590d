#include "scanner/turntable.h"

namespace vantage {

std::optional<TableAngle> Turntable::jog(double degrees, const Progress& progress) {
  const auto here = angle();
  return turnTo((here ? here->degrees : 0.0) + degrees, progress);
}

}  // namespace vantage
