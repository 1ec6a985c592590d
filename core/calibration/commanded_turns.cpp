#include "calibration/commanded_turns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/vectors.h"

namespace vantage {
namespace {

// What tables that are called good err by at every move.
constexpr double kTableSigma = radians(0.1);
constexpr double kLeastSlip = radians(1.5);
// A slip is more than a wrong ratio makes of a turn by this share of it.
constexpr double kSlipShare = 0.04;
constexpr double kSureOfOne = 3.0;

struct Turn {
  double counted;
  double found;
};

// That half of all turning is below.
double medianRatio(const std::vector<Turn>& turns) {
  std::vector<std::pair<double, double>> ratios;
  double whole = 0.0;
  for (const Turn& turn : turns) {
    if (turn.counted == 0.0) continue;
    ratios.emplace_back(turn.found / turn.counted, std::abs(turn.counted));
    whole += std::abs(turn.counted);
  }
  std::sort(ratios.begin(), ratios.end());
  double below = 0.0;
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    below += ratios[k].second;
    if (below > 0.5 * whole) return ratios[k].first;
    if (below == 0.5 * whole && k + 1 < ratios.size()) return 0.5 * (ratios[k].first + ratios[k + 1].first);
  }
  return 1.0;
}

// The slope of angles over counts when every stretch between slips has an offset of its own, and the sum of squared
// deviations of the counts from the means of their stretches.
std::pair<double, double> slopeOf(const std::vector<Turn>& stands, const std::vector<std::size_t>& stretch) {
  double product = 0.0;
  double squares = 0.0;
  for (std::size_t begin = 0; begin < stands.size();) {
    std::size_t end = begin;
    double counted = 0.0;
    double found = 0.0;
    for (; end < stands.size() && stretch[end] == stretch[begin]; ++end) {
      counted += stands[end].counted;
      found += stands[end].found;
    }
    counted /= static_cast<double>(end - begin);
    found /= static_cast<double>(end - begin);
    for (std::size_t k = begin; k < end; ++k) {
      product += (stands[k].counted - counted) * (stands[k].found - found);
      squares += (stands[k].counted - counted) * (stands[k].counted - counted);
    }
    begin = end;
  }
  return {product, squares};
}

}  // namespace

CommandedTurns explainTurns(std::span<const double> tableAngles, std::span<const double> angles) {
  std::vector<Turn> stands;
  std::vector<Turn> turns;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    stands.push_back({radians(tableAngles[k] - tableAngles[0]), angles[k] - angles[0]});
    if (k > 0) turns.push_back({stands[k].counted - stands[k - 1].counted, stands[k].found - stands[k - 1].found});
  }

  CommandedTurns result;
  const double usual = medianRatio(turns);
  std::vector<std::size_t> stretch(stands.size(), 0);
  for (std::size_t k = 1; k < stands.size(); ++k) {
    const double slip = turns[k - 1].found - usual * turns[k - 1].counted;
    const bool slipped = std::abs(slip) > std::max(kLeastSlip, kSlipShare * std::abs(turns[k - 1].found));
    stretch[k] = stretch[k - 1] + (slipped ? 1 : 0);
    if (!slipped) continue;
    if (!result.slippedBefore) result.slippedBefore = k;
    if (std::abs(slip) > std::abs(result.slip)) result.slip = slip;
  }
  const auto [product, squares] = slopeOf(stands, stretch);
  const double slope = squares > 0.0 ? product / squares : usual;

  std::vector<double> start(stretch.back() + 1, 0.0);
  std::vector<double> size(stretch.back() + 1, 0.0);
  for (std::size_t k = 0; k < stands.size(); ++k) {
    start[stretch[k]] += stands[k].found - slope * stands[k].counted;
    ++size[stretch[k]];
  }
  double scatter = 0.0;
  for (std::size_t k = 0; k < stands.size(); ++k) {
    const double left = stands[k].found - slope * stands[k].counted;
    result.off.push_back(left);
    scatter += std::pow(left - start[stretch[k]] / size[stretch[k]], 2);
  }
  const double free = static_cast<double>(stands.size()) - static_cast<double>(start.size()) - 1.0;
  result.spread = free > 0.0 ? std::sqrt(scatter / free) : 0.0;
  result.sense = slope < 0.0 ? -1 : 1;
  result.ratio = std::abs(slope);
  result.ratioSigma = squares > 0.0 ? std::max(result.spread, kTableSigma) / std::sqrt(squares) : 1.0;
  if (!result.slippedBefore && std::abs(result.ratio - 1.0) < kSureOfOne * result.ratioSigma) result.ratio = 1.0;
  return result;
}

}  // namespace vantage
