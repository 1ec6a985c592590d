#include "composites/even_rotations.h"

#include <cmath>

namespace vantage {
namespace {

// phi^2 = 2, and psi^4 = psi + 4: the spirals' two irrational steps.
constexpr double kPhi = std::numbers::sqrt2;
constexpr double kPsi = 1.533751168755204288118041;

}  // namespace

std::vector<Eigen::Quaterniond> evenRotations(std::size_t count) {
  std::vector<Eigen::Quaterniond> rotations;
  rotations.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) + 0.5;
    const double share = s / static_cast<double>(count);
    const double inner = std::sqrt(share);
    const double outer = std::sqrt(1.0 - share);
    const double alpha = 2.0 * kPi * std::fmod(s / kPhi, 1.0);
    const double beta = 2.0 * kPi * std::fmod(s / kPsi, 1.0);
    rotations.emplace_back(outer * std::cos(beta), inner * std::sin(alpha), inner * std::cos(alpha),
                           outer * std::sin(beta));
  }
  return rotations;
}

}  // namespace vantage
