#include "base/random.h"

#include <cmath>
#include <numbers>

#include "base/content_hash.h"

namespace vantage {

Random::Random(std::uint64_t seed, std::uint64_t stream)
    : state_(mixedBits(seed + 0x9e3779b97f4a7c15ULL) ^
             mixedBits(stream * 0xd1342543de82ef95ULL + 0x2545f4914f6cdd1dULL)) {}

std::uint64_t Random::bits() {
  state_ += 0x9e3779b97f4a7c15ULL;
  return mixedBits(state_);
}

double Random::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

double Random::normal() {
  const double u = 1.0 - uniform();  // in (0, 1], so that the logarithm is finite
  const double v = uniform();
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

std::uint64_t Random::below(std::uint64_t count) {
  return static_cast<std::uint64_t>(uniform() * static_cast<double>(count));
}

}  // namespace vantage
