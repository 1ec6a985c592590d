#include "acquisition/automatic_run.h"

#include <algorithm>
#include <numeric>

#include "base/random.h"
#include "planning/choice.h"

namespace vantage {
namespace {

constexpr int kMostFailures = 4;
// A position is tried after a failed one only when it overlaps by so much more.
constexpr double kMoreOverlap = 1.5;
constexpr std::uint64_t kStrategyStream = 0x73747261ULL << 24;

// What to do after the last view.
struct Next {
  int position = -1;
  std::optional<PositionScore> predicted;
  Termination termination = Termination::Running;
};

// A seeded order of all positions that begins with `first`.
std::vector<int> randomOrder(std::size_t count, int first, std::uint64_t seed) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  Random random(seed, kStrategyStream);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  std::iter_swap(order.begin(), std::find(order.begin(), order.end(), first));
  return order;
}

class AutomaticRun {
 public:
  AutomaticRun(ScannerDevice& scanner, const ScannerImages& images, const AcquisitionSettings& settings,
               const StepObserver& observer, const ScannerProfile& profile)
      : scanner_(scanner),
        images_(images),
        settings_(settings),
        observer_(observer),
        options_(stepOptionsFor(profile, settings)) {}

  AcquisitionState run(AcquisitionState state, const Progress& progress) {
    Next next = begin(state);
    while (next.termination == Termination::Running) {
      const Progress step = stepProgress(state, progress);
      PhaseTimer timer;
      const Progress watched = timer.watch(step);
      RangeImage image = scanner_.scan(next.position, watched.part(0.0, 0.1, "scan"));
      const std::size_t views = state.views.size();
      AcquisitionState after = addScan(state, std::move(image), next.predicted, options_, watched.part(0.1, 0.5));
      const bool rejected = after.views.size() == views;
      failures_ = rejected ? failures_ + 1 : 0;
      next = rejected ? afterFailure(after, next.position) : choose(after, watched.part(0.5, 1.0));
      if (!rejected) after.records.back().seconds = timer.finish();
      after.termination = next.termination;
      state = std::move(after);
      if (observer_) observer_(state);
    }
    return state;
  }

 private:
  [[nodiscard]] Progress stepProgress(const AcquisitionState& state, const Progress& progress) const {
    const auto views = static_cast<double>(std::max(1, settings_.maxViews));
    const auto done = std::min(static_cast<double>(state.views.size()), views - 1.0);
    return progress.part(done / views, (done + 1.0) / views);
  }

  Next begin(const AcquisitionState& state) {
    if (state.views.empty()) return {settings_.firstView, std::nullopt, Termination::Running};
    if (state.records.back().plan) return fromPlan(*state.records.back().plan, state);
    return fromBaseline(state);
  }

  Next choose(AcquisitionState& state, const Progress& progress) {
    if (settings_.strategy.kind != Strategy::Kind::PositionalSpace) return fromBaseline(state);
    state.records.back().plan = std::make_shared<const Plan>(planAfter(state, images_, options_, progress));
    return fromPlan(*state.records.back().plan, state);
  }

  [[nodiscard]] Next fromPlan(const Plan& plan, const AcquisitionState& state) const {
    if (plan.outcome == PlanOutcome::Finished) return {-1, {}, Termination::Finished};
    if (plan.outcome == PlanOutcome::NoOverlap) return {-1, {}, Termination::NoOverlap};
    if (static_cast<int>(state.views.size()) >= settings_.maxViews) return {-1, {}, Termination::MaxViews};
    return {plan.position, plan.scores[static_cast<std::size_t>(plan.position)], Termination::Running};
  }

  // After a failure: the best position by the last plan that has clearly more overlap. A baseline goes on as it would
  // have.
  Next afterFailure(const AcquisitionState& state, int position) {
    if (failures_ >= kMostFailures || state.views.empty()) return {-1, {}, Termination::RegistrationFailed};
    if (!state.records.back().plan) return fromBaseline(state);
    const std::vector<PositionScore>& scores = state.records.back().plan->scores;
    const double enough = kMoreOverlap * scores[static_cast<std::size_t>(position)].overlapArea;
    const PositionScore* best = nullptr;
    for (const PositionScore& score : scores) {
      const bool allowed = score.constraint == Constraint::Outscored && score.overlapArea > enough;
      if (allowed && (best == nullptr || promise(score) > promise(*best))) best = &score;
    }
    if (best == nullptr) return {-1, {}, Termination::RegistrationFailed};
    return {best->position, *best, Termination::Running};
  }

  [[nodiscard]] Next fromBaseline(const AcquisitionState& state) const {
    const std::size_t positions = state.profile->workspace.size();
    const auto taken = state.views.size() + state.rejected.size();
    const auto limit = static_cast<std::size_t>(settings_.maxViews);
    if (settings_.strategy.kind == Strategy::Kind::Uniform) {
      const auto count = static_cast<std::size_t>(settings_.strategy.uniformViews);
      if (taken >= std::min(count, positions)) return {-1, {}, Termination::Finished};
      if (taken >= limit) return {-1, {}, Termination::MaxViews};
      return {static_cast<int>((static_cast<std::size_t>(settings_.firstView) + taken * positions / count) % positions),
              {},
              Termination::Running};
    }
    if (taken >= std::min(limit, positions)) return {-1, {}, Termination::MaxViews};
    return {randomOrder(positions, settings_.firstView, settings_.seed)[taken], {}, Termination::Running};
  }

  ScannerDevice& scanner_;
  const ScannerImages& images_;
  const AcquisitionSettings& settings_;
  const StepObserver& observer_;
  StepOptions options_;
  int failures_ = 0;
};

}  // namespace

AcquisitionState acquire(AcquisitionState state, ScannerDevice& scanner, const ScannerImages& images,
                         const AcquisitionSettings& settings, const StepObserver& observer, const Progress& progress) {
  const std::shared_ptr<const ScannerProfile> profile = state.profile;
  return AutomaticRun(scanner, images, settings, observer, *profile).run(std::move(state), progress);
}

}  // namespace vantage
