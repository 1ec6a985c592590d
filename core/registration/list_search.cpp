#include "registration/list_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "registration/icp.h"
#include "registration/view_agreement.h"

namespace vantage {
namespace {

constexpr std::size_t kAsked = 300;
constexpr double kMostFactor = 2.5;
// Scans that follow each other turn by no more than this between two factors that are tried.
constexpr double kTurnStep = radians(4.0);
constexpr int kMostFactors = 300;
constexpr int kRefinements = 3;
// Factors nearer to 1 are no other factor, nearer to 0 put all scans on top of each other.
constexpr double kOtherFactor = 0.04;
constexpr double kNoTurn = 0.1;
// A better list agrees by so much more, and well.
constexpr double kBetterBy = 0.05;
constexpr double kLeastScore = 0.5;
// Share of the points that must be expected on another scan for two lists to compare.
constexpr double kLeastOverlap = 0.05;
constexpr std::size_t kMostLists = 4;
// What people get wrong most; beside them nearly round bodies find factors that mean nothing.
constexpr std::array<double, 3> kPlainFactors{0.5, 2.0, -1.0};

class Search {
 public:
  Search(std::span<const PreparedView> views, std::span<const Pose> given, const Progress& progress)
      : views_(views), given_(given), progress_(progress) {
    const RegistrationScale scale = scaleOf(views);
    const IcpOptions icp = resolved(IcpOptions(), scale);
    gates_ = {std::max(looseShift(scale), fineGate(scale)), *icp.hiddenDepth, icp.coarseAngle};
  }

  [[nodiscard]] std::vector<MendedList> run() const {
    std::vector<std::pair<double, MendedList>> found;
    for (MendedList& list : mendedLists(given_)) found.emplace_back(score(list.poses), std::move(list));
    if (const auto turns = turnsOf(given_)) {
      for (const double factor : kPlainFactors) found.push_back(turned(*turns, factor));
      found.push_back(bestTurns(*turns));
    }
    const double least = std::max(score(given_) + kBetterBy, kLeastScore);
    std::erase_if(found, [&](const auto& entry) { return entry.first < least; });
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<MendedList> lists;
    for (auto& entry : found)
      if (lists.size() < kMostLists) lists.push_back(std::move(entry.second));
    return lists;
  }

 private:
  // How well scans agree with the two that follow, 1 for entirely.
  [[nodiscard]] double score(std::span<const Pose> poses) const {
    const std::size_t n = views_.size();
    std::vector<Agreement> next(2 * n);
    parallelChunks(2 * n, 1, progress_, [&](std::size_t k, std::size_t) {
      const std::size_t i = k / 2;
      const std::size_t j = i + 1 + k % 2;
      if (j >= n) return;
      next[k] = agreementOf(views_[i], views_[j], poses[j].inverse() * poses[i], gates_, kAsked);
      next[k] += agreementOf(views_[j], views_[i], poses[i].inverse() * poses[j], gates_, kAsked);
    });
    Agreement all;
    for (const Agreement& agreement : next) all += agreement;
    if (all.expected() < kLeastOverlap * 4.0 * static_cast<double>(kAsked * n)) return 0.0;
    return (all.paired - all.through - 0.5 * all.empty) / all.expected();
  }

  [[nodiscard]] std::pair<double, MendedList> turned(const ListedTurns& turns, double factor) const {
    MendedList list = withTurns(given_, turns, factor);
    const bool another = std::abs(factor - 1.0) > kOtherFactor && std::abs(factor) > kNoTurn;
    const double value = another ? score(list.poses) : -1.0;
    return {value, std::move(list)};
  }

  [[nodiscard]] std::pair<double, MendedList> bestTurns(const ListedTurns& turns) const {
    double largest = 0.0;
    for (std::size_t i = 1; i < turns.angles.size(); ++i)
      largest = std::max(largest, std::abs(turns.angles[i] - turns.angles[i - 1]));
    double step = std::max(kTurnStep / std::max(largest, 1e-6), 2.0 * kMostFactor / kMostFactors);
    std::pair<double, MendedList> best{-1.0, {}};
    const auto consider = [&](double factor) {
      auto candidate = turned(turns, factor);
      if (candidate.first > best.first) best = std::move(candidate);
    };
    const auto steps = static_cast<int>(2.0 * kMostFactor / step);
    for (int k = 0; k <= steps; ++k) consider(-kMostFactor + k * step);
    for (int round = 0; round < kRefinements; ++round) {
      step /= 3.0;
      const double middle = best.second.finding.value;
      consider(middle - step);
      consider(middle + step);
    }
    return best;
  }

  std::span<const PreparedView> views_;
  std::span<const Pose> given_;
  const Progress& progress_;
  PairGates gates_;
};

}  // namespace

std::vector<MendedList> betterLists(std::span<const PreparedView> views, std::span<const Pose> given,
                                    const Progress& progress) {
  if (views.size() < 2) return {};
  return Search(views, given, progress).run();
}

}  // namespace vantage
