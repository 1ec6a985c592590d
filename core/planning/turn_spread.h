#pragma once

#include <span>
#include <vector>

#include "scanner/mechanics.h"
#include "scanner/workspace.h"

namespace vantage {

/// Whether a move may end farther off than a registration finds its way from, as those of hands do.
[[nodiscard]] bool isGuess(const Mechanics& mechanics);

/// Where moves that are a guess may end: at any position up to two sigmas of the turn away, at the same tilt. Moves
/// that are none end at their position.
class TurnSpread {
 public:
  TurnSpread(const Workspace& workspace, const Mechanics& mechanics);

  /// Whether moves are a guess.
  [[nodiscard]] bool isWide() const { return widest_ > 0.0; }

  /// The positions where a move to one may end, itself among them.
  [[nodiscard]] std::vector<int> around(int position) const;

  /// The position itself and the outermost two of those around it.
  [[nodiscard]] std::vector<int> extremes(int position) const;

  /// Per position the least value that a move to it may end at.
  [[nodiscard]] std::vector<double> least(std::vector<double> values) const;

 private:
  [[nodiscard]] double turnFrom(int from, int to) const;

  double widest_ = 0.0;         // [rad]; 0: moves end at their position
  std::vector<double> angles_;  // of the table, per position [rad]; empty as long as they do
  std::vector<double> tilts_;
};

}  // namespace vantage
