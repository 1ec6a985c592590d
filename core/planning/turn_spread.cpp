#include "planning/turn_spread.h"

#include <algorithm>
#include <cmath>

#include "scanner/table_turn.h"

namespace vantage {
namespace {

constexpr double kReach = radians(3.0);
constexpr double kLikely = 2.0;           // [sigmas]
constexpr double kSame = radians(0.001);  // tilts that differ by less are one

}  // namespace

bool isGuess(const Mechanics& mechanics) {
  return mechanics.angleSigma > kReach;
}

TurnSpread::TurnSpread(const Workspace& workspace, const Mechanics& mechanics) {
  if (!isGuess(mechanics)) return;
  widest_ = kLikely * mechanics.angleSigma;
  for (int i = 0; i < static_cast<int>(workspace.size()); ++i) {
    const TableTurn turn = turnBetween(workspace, 0, i);
    angles_.push_back(turn.angle);
    tilts_.push_back(turn.tilt);
  }
}

double TurnSpread::turnFrom(int from, int to) const {
  return std::remainder(angles_[static_cast<std::size_t>(to)] - angles_[static_cast<std::size_t>(from)],
                        2.0 * radians(180.0));
}

std::vector<int> TurnSpread::around(int position) const {
  if (!isWide()) return {position};
  std::vector<int> positions;
  const double tilt = tilts_[static_cast<std::size_t>(position)];
  for (int i = 0; i < static_cast<int>(angles_.size()); ++i) {
    const bool level = std::abs(tilts_[static_cast<std::size_t>(i)] - tilt) < kSame;
    if (level && std::abs(turnFrom(position, i)) <= widest_) positions.push_back(i);
  }
  return positions;
}

std::vector<int> TurnSpread::extremes(int position) const {
  const std::vector<int> all = around(position);
  const auto [least, most] = std::minmax_element(
      all.begin(), all.end(), [&](int a, int b) { return turnFrom(position, a) < turnFrom(position, b); });
  std::vector<int> positions{position};
  for (const int end : {*least, *most})
    if (end != position) positions.push_back(end);
  return positions;
}

std::vector<double> TurnSpread::least(std::vector<double> values) const {
  if (!isWide()) return values;
  std::vector<double> leasts;
  leasts.reserve(values.size());
  for (int i = 0; i < static_cast<int>(values.size()); ++i) {
    double least = values[static_cast<std::size_t>(i)];
    for (const int other : around(i)) least = std::min(least, values[static_cast<std::size_t>(other)]);
    leasts.push_back(least);
  }
  return leasts;
}

}  // namespace vantage
