#pragma once

#include <cstddef>

#include "base/progress.h"

namespace vantage {

/// Asks of a long loop whether to go on, once in so many rounds.
class Pace {
 public:
  /// @param fraction that is reported meanwhile, of the progress
  explicit Pace(const Progress& progress, double fraction = 0.0) : progress_(progress), fraction_(fraction) {}

  /// To be called once in every round. @throws Cancelled
  void step() {
    if (++count_ % kRounds == 0) progress_.checkpoint(fraction_);
  }

 private:
  static constexpr std::size_t kRounds = 65'536;

  Progress progress_;
  double fraction_;
  std::size_t count_ = 0;
};

}  // namespace vantage
