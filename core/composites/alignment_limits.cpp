#include "composites/alignment_limits.h"

#include <algorithm>

namespace vantage {

double AlignmentLimits::voxel() const {
  return std::max(size / 64.0, 2.0 * scale.spacing);
}

double AlignmentLimits::margin() const {
  return size / 5.0;
}

double AlignmentLimits::coarseGate() const {
  return std::max(size / 8.0, 4.0 * voxel());
}

double AlignmentLimits::nearGate() const {
  return std::max(size / 20.0, 2.0 * voxel());
}

double AlignmentLimits::closeGate() const {
  return std::max(size / 53.0, 1.2 * voxel());
}

double AlignmentLimits::mediumGate() const {
  return std::max(size / 40.0, 1.6 * voxel());
}

double AlignmentLimits::sampleGate() const {
  return 0.75 * scale.spacing + 3.0 * scale.noise;
}

double AlignmentLimits::fineGate() const {
  return 0.5 * scale.spacing + 2.0 * scale.noise;
}

double AlignmentLimits::conflict() const {
  return scale.spacing + 3.0 * scale.noise;
}

double AlignmentLimits::reliefStep() const {
  return size / 32.0;
}

double AlignmentLimits::distinctShift() const {
  return std::max(size / 80.0, scale.spacing);
}

AlignmentLimits limitsOf(const RegistrationScale& a, const RegistrationScale& b) {
  AlignmentLimits limits;
  limits.scale = {std::max(a.spacing, b.spacing), std::max(a.noise, b.noise), std::max(a.extent, b.extent)};
  limits.size = limits.scale.extent;
  return limits;
}

}  // namespace vantage
