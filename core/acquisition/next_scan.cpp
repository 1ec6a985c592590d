#include "acquisition/next_scan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "acquisition/hand_placing.h"
#include "acquisition/other_turn.h"
#include "acquisition/stand_composites.h"
#include "base/random.h"
#include "planning/choice.h"
#include "scanner/table_turn.h"

namespace vantage {
namespace {

constexpr std::size_t kMostFailures = 4;
constexpr double kSameTilt = radians(0.001);
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

int viewsInStand(const AcquisitionState& state) {
  return static_cast<int>(std::count_if(state.scans.begin(), state.scans.end(), [&](const KeptScan& scan) {
    return scan.status == ScanStatus::In && scan.station().stand == state.stand();
  }));
}

NextScan fromPlan(const Plan& plan, const AcquisitionState& state) {
  if (plan.outcome == PlanOutcome::Finished) return Ended{Termination::Finished};
  if (plan.outcome == PlanOutcome::NoOverlap) return Ended{Termination::NoOverlap};
  if (viewsInStand(state) >= state.settings.maxViews) return Ended{Termination::MaxViews};
  const int position = plan.position.value();
  return ScanFrom{position, plan.scores[static_cast<std::size_t>(position)]};
}

// How often the object was scanned in its stand of now. What a person was asked for between the positions of a
// baseline, where these overlap too little, is none of them.
std::size_t takenInStand(const AcquisitionState& state, const std::function<bool(int)>& isOfBaseline) {
  return static_cast<std::size_t>(std::count_if(state.scans.begin(), state.scans.end(), [&](const KeptScan& scan) {
    if (scan.status == ScanStatus::LeftOut || scan.station().stand != state.stand()) return false;
    return !turnedByGuess(*scan.view.image) || !scan.station().position || isOfBaseline(*scan.station().position);
  }));
}

// The k-th of so many positions that are spread evenly.
int spread(const AcquisitionSettings& settings, std::size_t positions, std::size_t k) {
  const std::size_t offset = k * positions / static_cast<std::size_t>(settings.strategy.uniformViews);
  return static_cast<int>((static_cast<std::size_t>(settings.firstView) + offset) % positions);
}

bool isSpread(const AcquisitionSettings& settings, std::size_t positions, int position) {
  if (settings.strategy.kind != Strategy::Kind::Uniform) return true;
  for (std::size_t k = 0; k < static_cast<std::size_t>(settings.strategy.uniformViews); ++k)
    if (spread(settings, positions, k) == position) return true;
  return false;
}

NextScan fromBaseline(const AcquisitionState& state) {
  const AcquisitionSettings& settings = state.settings;
  const std::size_t positions = state.profile->workspace.size();
  const std::size_t taken = takenInStand(state, [&](int position) { return isSpread(settings, positions, position); });
  const auto limit = static_cast<std::size_t>(settings.maxViews);
  if (settings.strategy.kind == Strategy::Kind::Uniform) {
    const auto count = static_cast<std::size_t>(settings.strategy.uniformViews);
    if (taken >= std::min(count, positions)) return Ended{Termination::Finished};
    if (taken >= limit) return Ended{Termination::MaxViews};
    return ScanFrom{spread(settings, positions, taken)};
  }
  if (taken >= std::min(limit, positions)) return Ended{Termination::MaxViews};
  return ScanFrom{randomOrder(positions, settings.firstView, settings.simulation.seed)[taken]};
}

// The scans of this stand that failed since the last one that found its place.
std::vector<const KeptScan*> failuresInARow(const AcquisitionState& state) {
  std::vector<const KeptScan*> failures;
  for (const KeptScan& scan : state.scans) {
    if (scan.station().stand != state.stand() || !scan.station().position) continue;
    if (scan.status == ScanStatus::In) failures.clear();
    if (scan.status == ScanStatus::Rejected) failures.push_back(&scan);
  }
  return failures;
}

// How far a position is turned from another one, at the same tilt; nothing at another.
std::optional<double> turned(const Workspace& workspace, int from, int to) {
  const TableTurn turn = turnBetween(workspace, from, to);
  return std::abs(turn.tilt) < kSameTilt ? std::optional(turn.angle) : std::nullopt;
}

// Where the table is to be turned half as far from the nearest view.
std::optional<int> halfWay(const AcquisitionState& state, const KeptScan& failed) {
  const Workspace& workspace = state.profile->workspace;
  const int to = *failed.station().position;
  std::optional<double> least;
  std::vector<int> taken;
  for (const KeptScan& scan : state.scans) {
    if (scan.station().stand != state.stand() || scan.status == ScanStatus::LeftOut) continue;
    const auto position = positionTaken(state, scan);
    if (!position) continue;
    taken.push_back(*position);
    const auto turn = scan.status == ScanStatus::In ? turned(workspace, to, *position) : std::nullopt;
    if (turn && (!least || std::abs(*turn) < std::abs(*least))) least = turn;
  }
  if (!least) return std::nullopt;
  std::optional<int> best;
  double off = 0.25 * std::abs(*least);
  for (int i = 0; i < static_cast<int>(workspace.size()); ++i) {
    const auto turn = turned(workspace, to, i);
    if (!turn || std::find(taken.begin(), taken.end(), i) != taken.end()) continue;
    const double miss = std::abs(*turn - 0.5 * *least);
    if (miss >= off) continue;
    best = i;
    off = miss;
  }
  return best;
}

// Whether a person was asked for the same position twice in a row, and failed.
bool failedAgain(const std::vector<const KeptScan*>& failures) {
  return failures.size() > 1 &&
         failures[failures.size() - 2]->station().position == failures.back()->station().position;
}

// Where a scan shows too little of what is known, half the turn is asked for, of a table only by a plan; of a person
// also where a second one failed, who else is asked to turn again.
std::optional<int> askedAgain(const AcquisitionState& state, const std::vector<const KeptScan*>& failures) {
  const KeptScan& failed = *failures.back();
  const bool tooFar = failed.record.registration.finding.reason == VerdictReason::FewPairs;
  if (!turnedByGuess(*failed.view.image)) return tooFar && state.plan ? halfWay(state, failed) : std::nullopt;
  if (const auto nearer = tooFar || failedAgain(failures) ? halfWay(state, failed) : std::nullopt) return nearer;
  return tooFar || !state.plan ? std::nullopt : failed.station().position;
}

// The best position by the last plan that has clearly more overlap; a person is asked again where none has. A baseline
// goes on as it would have, but for a person who turned too far.
NextScan afterFailures(const AcquisitionState& state, const std::vector<const KeptScan*>& failures) {
  if (failures.size() >= kMostFailures || !state.model) return Ended{Termination::RegistrationFailed};
  const auto again = askedAgain(state, failures);
  if (!state.plan) return again ? NextScan(ScanFrom{*again}) : fromBaseline(state);
  const auto failed = static_cast<std::size_t>(*failures.back()->station().position);
  const double enough = kMoreOverlap * state.plan->scores[failed].overlapArea;
  const PositionScore* best = nullptr;
  for (const PositionScore& score : state.plan->scores) {
    const bool allowed = score.constraint == Constraint::Outscored && score.overlapArea > enough;
    if (allowed && (best == nullptr || promise(score) > promise(*best))) best = &score;
  }
  if (best == nullptr && again) return ScanFrom{*again, state.plan->scores[static_cast<std::size_t>(*again)]};
  if (best == nullptr) return Ended{Termination::RegistrationFailed};
  return ScanFrom{best->position, *best};
}

bool scannedInStand(const AcquisitionState& state) {
  return std::any_of(state.scans.begin(), state.scans.end(), [&](const KeptScan& scan) {
    return scan.status != ScanStatus::LeftOut && scan.station().stand == state.stand();
  });
}

// Whether nothing is there to plan from: no other stand is known relative to the one of now.
bool isFirstOfComposite(const AcquisitionState& state) {
  return referenceOf(state.stands) == state.stand() || !isOfObject(state, state.stand());
}

}  // namespace

NextScan nextScan(const AcquisitionState& state) {
  if (!state.profile)
    return Ended{state.termination == Termination::Running ? Termination::Finished : state.termination};
  if (state.chosenPosition) {
    ScanFrom chosen{*state.chosenPosition};
    if (state.plan) chosen.predicted = state.plan->scores[static_cast<std::size_t>(*state.chosenPosition)];
    return chosen;
  }
  if (state.termination == Termination::EndedByOperator || state.termination == Termination::Imported)
    return Ended{state.termination};
  if (!scannedInStand(state) && isFirstOfComposite(state)) return ScanFrom{state.settings.firstView};
  if (const auto failures = failuresInARow(state); !failures.empty()) return afterFailures(state, failures);
  if (state.plan) return fromPlan(*state.plan, state);
  if (state.settings.strategy.kind == Strategy::Kind::PositionalSpace) return PlanFirst{};
  return fromBaseline(state);
}

std::optional<int> nextPosition(const AcquisitionState& state) {
  const NextScan next = nextScan(state);
  const auto* scan = std::get_if<ScanFrom>(&next);
  return scan != nullptr ? std::optional(scan->position) : std::nullopt;
}

Termination terminationOf(const NextScan& next) {
  const auto* ended = std::get_if<Ended>(&next);
  return ended != nullptr ? ended->termination : Termination::Running;
}

}  // namespace vantage
