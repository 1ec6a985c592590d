#include "calibration/turn_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.h"

namespace vantage {
namespace {

// A wrong ratio is felt when it is off by so much between neighbouring scans.
constexpr double kCapture = radians(7.0);
constexpr double kMostStep = 1.18;
constexpr std::size_t kRoughPoints = 300;
constexpr std::size_t kFinePoints = 1500;
constexpr std::size_t kKept = 6;
constexpr double kSame = 0.08;
constexpr double kFineGates = 3.0;

// Scans by table angle.
std::vector<std::size_t> orderOf(std::span<const double> tableAngles) {
  std::vector<std::size_t> order(tableAngles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return tableAngles[a] < tableAngles[b]; });
  return order;
}

// Both ways between scans whose angles follow each other, and over one.
std::vector<ViewLink> neighbourLinks(std::span<const PreparedView> views, std::span<const double> tableAngles,
                                     std::size_t points) {
  const std::vector<std::size_t> order = orderOf(tableAngles);
  std::vector<ViewLink> links;
  auto add = [&](std::size_t from, std::size_t to) {
    ViewLink link;
    link.from = from;
    link.to = to;
    link.ids = thinned(allIndices(views[from].points.size()), points);
    link.positions.resize(link.ids.size());
    link.pairs.resize(link.ids.size());
    links.push_back(std::move(link));
  };
  for (std::size_t apart = 1; apart <= 2; ++apart) {
    for (std::size_t k = 0; k + apart < order.size(); ++k) {
      add(order[k], order[k + apart]);
      add(order[k + apart], order[k]);
    }
  }
  return links;
}

// The median turn between scans whose angles follow each other.
double usualTurn(std::span<const double> tableAngles) {
  std::vector<double> sorted(tableAngles.begin(), tableAngles.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> turns;
  for (std::size_t k = 1; k < sorted.size(); ++k) turns.push_back(radians(sorted[k] - sorted[k - 1]));
  std::sort(turns.begin(), turns.end());
  return std::max(turns[turns.size() / 2], radians(1.0));
}

std::vector<double> ratiosToTry(double usualTurn, const RatioRange& range) {
  std::vector<double> ratios;
  auto next = [&](double ratio) { return std::min(ratio * kMostStep, ratio + kCapture / usualTurn); };
  // From 1 in both directions, so that 1 itself is one of them.
  for (double ratio = 1.0; ratio <= range.most; ratio = next(ratio)) ratios.push_back(ratio);
  for (double ratio = 2.0 - next(1.0); ratio >= range.least;) {
    ratios.push_back(ratio);
    ratio -= std::min(ratio * (1.0 - 1.0 / kMostStep), kCapture / usualTurn);
  }
  const std::size_t count = ratios.size();
  for (std::size_t k = 0; k < count; ++k) ratios.push_back(-ratios[k]);
  return ratios;
}

ScrewMotion turning(std::span<const double> tableAngles, double turnsPerCount, const Vec3& point,
                    const Vec3& direction) {
  ScrewMotion motion{point, direction, {}};
  for (const double angle : tableAngles) motion.angles.push_back(turnsPerCount * radians(angle - tableAngles[0]));
  return motion;
}

// The ratio that half of all turning between scans whose angles follow each other is below.
double ratioOf(std::span<const double> tableAngles, const ScrewMotion& motion) {
  const std::vector<std::size_t> order = orderOf(tableAngles);
  std::vector<std::pair<double, double>> ratios;  // with the turn that each is of
  double whole = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const double turn = radians(tableAngles[order[k]] - tableAngles[order[k - 1]]);
    if (turn == 0.0) continue;
    ratios.emplace_back((motion.angles[order[k]] - motion.angles[order[k - 1]]) / turn, turn);
    whole += turn;
  }
  std::sort(ratios.begin(), ratios.end());
  double sum = 0.0;
  for (const auto& [ratio, turn] : ratios) {
    sum += turn;
    if (sum >= 0.5 * whole) return ratio;
  }
  return 0.0;
}

// The better of those that are alike.
void keepDistinct(std::vector<TurnCandidate>& candidates, std::size_t count) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.misfit < b.misfit; });
  std::vector<TurnCandidate> kept;
  for (TurnCandidate& candidate : candidates) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const TurnCandidate& other) {
      return std::abs(candidate.turnsPerCount - other.turnsPerCount) < kSame * std::abs(other.turnsPerCount);
    });
    if (!known && kept.size() < count) kept.push_back(std::move(candidate));
  }
  candidates = std::move(kept);
}

}  // namespace

std::vector<TurnCandidate> searchTurns(std::span<const PreparedView> views, std::span<const double> tableAngles,
                                       const Vec3& point, const Vec3& direction, const RegistrationScale& scale,
                                       const RatioRange& range, const Progress& progress) {
  const double fine = kFineGates * fineGate(scale);
  const double coarse = std::max(scale.extent / 12.0, 2.0 * fine);
  auto fitted = [&](const ScrewMotion& start, std::size_t points, const ScrewSchedule& schedule) {
    TurnCandidate candidate;
    candidate.fit = fitScrew(views, start, neighbourLinks(views, tableAngles, points), schedule, ScrewPrior(),
                             progress.withThreads(1).part(0.0, 0.0));
    ScrewMotion& motion = candidate.fit.motion;
    // The same turns about the opposite direction.
    if (motion.direction.dot(direction) < 0.0) {
      motion.direction = -motion.direction;
      for (double& angle : motion.angles) angle = -angle;
    }
    candidate.turnsPerCount = ratioOf(tableAngles, motion);
    return candidate;
  };

  const std::vector<double> ratios = ratiosToTry(usualTurn(tableAngles), range);
  std::vector<TurnCandidate> candidates(ratios.size());
  const ScrewSchedule rough{coarse, 0.5 * coarse, coarse, 12, 0.05};
  const Progress trying = progress.part(0.0, 0.6);
  parallelChunks(ratios.size(), 1, trying, [&](std::size_t k, std::size_t) {
    candidates[k] = fitted(turning(tableAngles, ratios[k], point, direction), kRoughPoints, rough);
    candidates[k].misfit = misfit(candidates[k].fit.links, 0.5 * coarse);
  });
  std::erase_if(candidates, [&](const TurnCandidate& c) { return std::abs(c.turnsPerCount) < 0.5 * range.least; });
  keepDistinct(candidates, kKept);

  const ScrewSchedule closer{0.7 * coarse, fine, coarse, 25, 0.01};
  const Progress improving = progress.part(0.6, 1.0);
  parallelChunks(candidates.size(), 1, improving, [&](std::size_t k, std::size_t) {
    candidates[k] = fitted(candidates[k].fit.motion, kFinePoints, closer);
    candidates[k].misfit = misfit(candidates[k].fit.links, fine);
  });
  std::erase_if(candidates, [&](const TurnCandidate& c) { return std::abs(c.turnsPerCount) < 0.5 * range.least; });
  keepDistinct(candidates, kKept);
  return candidates;
}

}  // namespace vantage
