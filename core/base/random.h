#pragma once

#include <cstdint>

namespace vantage {

/// A seeded stream of random numbers (splitmix64 over a keyed counter), the same bits on every platform. Two streams
/// with different keys are independent, so that work split over threads draws the same numbers: give every item a
/// stream of its own, keyed by its index.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

  /// Next 64 random bits.
  std::uint64_t bits();
  /// Uniform in [0, 1).
  double uniform();
  /// Standard normal (Box-Muller).
  double normal();
  /// Uniform in 0..count-1. @pre count is in 1..2^53
  std::uint64_t below(std::uint64_t count);

 private:
  std::uint64_t state_;
};

}  // namespace vantage
