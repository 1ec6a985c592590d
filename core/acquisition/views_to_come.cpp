#include "acquisition/views_to_come.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "acquisition/next_scan.h"
#include "planning/choice.h"

namespace vantage {
namespace {

// By what share promises fall: of fewer than that an estimate is never rid of, of more a single poor view would be the
// last one.
constexpr double kFastest = 0.3;
constexpr double kSlowest = 0.85;
constexpr std::size_t kTimed = 5;  // the last views, whose durations count

double secondsOf(const KeptScan& scan) {
  double sum = 0.0;
  for (const auto& [phase, seconds] : scan.record.seconds) sum += seconds;
  return sum;
}

// The one in the middle: a view that took long for once counts no more than another.
double usualSeconds(std::vector<double> seconds) {
  if (seconds.size() > kTimed) seconds.erase(seconds.begin(), seconds.end() - kTimed);
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

}  // namespace

std::optional<ViewsToCome> viewsToCome(const AcquisitionState& state) {
  const std::optional<int> next = nextPosition(state);
  if (!next || !state.plan || *next >= static_cast<int>(state.plan->scores.size())) return std::nullopt;
  std::vector<double> promises;
  std::vector<double> seconds;
  for (const KeptScan* scan : scansOf(state, ScanStatus::In)) {
    if (scan->station().stand != state.stand()) continue;
    seconds.push_back(secondsOf(*scan));
    if (scan->record.predicted) promises.push_back(promise(*scan->record.predicted));
  }
  if (static_cast<int>(seconds.size()) < kViewsForAnEstimate || promises.empty()) return std::nullopt;
  const double now = promise(state.plan->scores[static_cast<std::size_t>(*next)]);
  const double least = std::max(state.plan->terminationThreshold, 1e-6);
  const double fall = promises.front() > 0.0 && now > 0.0
                          ? std::pow(now / promises.front(), 1.0 / static_cast<double>(promises.size()))
                          : kFastest;
  const double further = now > least ? std::log(least / now) / std::log(std::clamp(fall, kFastest, kSlowest)) : 0.0;
  const int most = std::max(1, state.settings.maxViews - static_cast<int>(seconds.size()));
  ViewsToCome come;
  come.views = std::clamp(1 + static_cast<int>(std::floor(further)), 1, most);
  come.seconds = come.views * usualSeconds(seconds);
  return come;
}

}  // namespace vantage
