#include "acquisition/next_scan.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/random.h"
#include "planning/choice.h"

namespace vantage {
namespace {

constexpr std::ptrdiff_t kMostFailures = 4;
// A position is tried after a failed one only when it overlaps by so much more.
constexpr double kMoreOverlap = 1.5;
constexpr std::uint64_t kStrategyStream = 0x73747261ULL << 24;

// A seeded order of all positions that begins with `first`.
std::vector<int> randomOrder(std::size_t count, int first, std::uint64_t seed) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  Random random(seed, kStrategyStream);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  std::iter_swap(order.begin(), std::find(order.begin(), order.end(), first));
  return order;
}

NextScan fromPlan(const Plan& plan, const AcquisitionState& state) {
  if (plan.outcome == PlanOutcome::Finished) return {-1, {}, Termination::Finished};
  if (plan.outcome == PlanOutcome::NoOverlap) return {-1, {}, Termination::NoOverlap};
  if (static_cast<int>(state.views.size()) >= state.settings.maxViews) return {-1, {}, Termination::MaxViews};
  return {plan.position, plan.scores[static_cast<std::size_t>(plan.position)], Termination::Running};
}

NextScan fromBaseline(const AcquisitionState& state) {
  const AcquisitionSettings& settings = state.settings;
  const std::size_t positions = state.profile->workspace.size();
  const auto taken = state.views.size() + state.rejected.size();
  const auto limit = static_cast<std::size_t>(settings.maxViews);
  if (settings.strategy.kind == Strategy::Kind::Uniform) {
    const auto count = static_cast<std::size_t>(settings.strategy.uniformViews);
    if (taken >= std::min(count, positions)) return {-1, {}, Termination::Finished};
    if (taken >= limit) return {-1, {}, Termination::MaxViews};
    const std::size_t offset = taken * positions / count;
    return {static_cast<int>((static_cast<std::size_t>(settings.firstView) + offset) % positions), {}, {}};
  }
  if (taken >= std::min(limit, positions)) return {-1, {}, Termination::MaxViews};
  return {randomOrder(positions, settings.firstView, settings.seed)[taken], {}, {}};
}

// Scans from positions that failed since the last one that found its place.
std::ptrdiff_t failuresInARow(const AcquisitionState& state) {
  std::int64_t last = -1;
  for (const ViewRecord& record : state.records) last = std::max(last, record.scan);
  return std::count_if(state.rejected.begin(), state.rejected.end(),
                       [&](const RejectedScan& r) { return r.scan > last && r.image->position >= 0; });
}

// The best position by the last plan that has clearly more overlap. A baseline goes on as it would have.
NextScan afterFailure(const AcquisitionState& state, std::ptrdiff_t failures) {
  if (failures >= kMostFailures || state.views.empty()) return {-1, {}, Termination::RegistrationFailed};
  const auto plan = currentPlan(state);
  if (!plan) return fromBaseline(state);
  const auto failed = static_cast<std::size_t>(state.rejected.back().image->position);
  const double enough = kMoreOverlap * plan->scores[failed].overlapArea;
  const PositionScore* best = nullptr;
  for (const PositionScore& score : plan->scores) {
    const bool allowed = score.constraint == Constraint::Outscored && score.overlapArea > enough;
    if (allowed && (best == nullptr || promise(score) > promise(*best))) best = &score;
  }
  if (best == nullptr) return {-1, {}, Termination::RegistrationFailed};
  return {best->position, *best, Termination::Running};
}

}  // namespace

NextScan nextScan(const AcquisitionState& state) {
  const auto plan = currentPlan(state);
  if (state.chosenPosition >= 0) {
    NextScan chosen{state.chosenPosition, {}, Termination::Running};
    if (plan) chosen.predicted = plan->scores[static_cast<std::size_t>(state.chosenPosition)];
    return chosen;
  }
  if (state.views.empty() && state.rejected.empty()) return {state.settings.firstView, {}, Termination::Running};
  if (const std::ptrdiff_t failures = failuresInARow(state); failures > 0) return afterFailure(state, failures);
  if (plan) return fromPlan(*plan, state);
  if (state.settings.strategy.kind == Strategy::Kind::PositionalSpace) return {};
  return fromBaseline(state);
}

}  // namespace vantage
