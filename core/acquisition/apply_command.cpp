#include "acquisition/apply_command.h"

#include <utility>

#include "acquisition/import_scans.h"
#include "acquisition/next_scan.h"
#include "acquisition/steps.h"
#include "base/errors.h"

namespace vantage {
namespace {

void checkPosition(const AcquisitionState& state, int position) {
  if (!state.profile)
    throw InvalidInput("position " + std::to_string(position) +
                       ": the session has no scanner profile, so no positions");
  const auto positions = static_cast<int>(state.profile->workspace.size());
  if (position < 0 || position >= positions)
    throw InvalidInput("position " + std::to_string(position) + " does not exist, the workspace has positions 0 to " +
                       std::to_string(positions - 1));
}

// Carries out one kind of command each.
class Carrier {
 public:
  Carrier(const AcquisitionState& state, const CommandInput& input, const Progress& progress)
      : state_(state), input_(input), progress_(progress) {}

  AcquisitionState operator()(const ChangeSettings& command) const {
    AcquisitionState next = state_;
    if (state_.profile) checkPosition(state_, command.settings.firstView);
    next.settings = command.settings;
    return replanned(std::move(next));
  }

  AcquisitionState operator()(const AddScan& command) const {
    PhaseTimer timer;
    const Progress watched = timer.watch(progress_);
    const auto image = input_.scan(command.scan);
    checkPosition(state_, image->position);
    AcquisitionState next =
        addScan(state_, {command.scan, image}, command.predicted, stepOptionsFor(state_), watched.part(0.0, 0.5));
    next.chosenPosition = -1;
    const bool added = next.views.size() > state_.views.size();
    if (added && input_.images != nullptr) next = planned(std::move(next), *input_.images, watched.part(0.5, 1.0));
    if (added) next.records.back().seconds = timer.finish();
    next.termination = nextScan(next).termination;
    return next;
  }

  AcquisitionState operator()(const ImportScans& command) const {
    if (!state_.views.empty() || !state_.rejected.empty())
      throw InvalidInput("recorded scans can only be imported into an empty session");
    std::vector<NumberedScan> scans;
    for (const std::int64_t scan : command.scans) scans.push_back({scan, input_.scan(scan)});
    AcquisitionState next = importScans(scans, importOptionsFor(state_), progress_).state;
    next.profile = state_.profile;
    next.settings = state_.settings;
    return next;
  }

  AcquisitionState operator()(const ChoosePosition& command) const {
    if (command.position >= 0) checkPosition(state_, command.position);
    AcquisitionState next = state_;
    next.chosenPosition = command.position < 0 ? -1 : command.position;
    return next;
  }

  AcquisitionState operator()(const LeaveOutView& command) const {
    return replanned(leaveOutView(state_, command.scan, stepOptionsFor(state_), progress_.part(0.0, 0.5)));
  }

  AcquisitionState operator()(const TakeBackView& command) const {
    return replanned(takeBackView(state_, command.scan, stepOptionsFor(state_), progress_.part(0.0, 0.5)));
  }

  AcquisitionState operator()(const Finish& command) const {
    AcquisitionState next = state_;
    next.termination = command.termination;
    return next;
  }

  AcquisitionState operator()(const TakeOver& /*command*/) const {
    throw InvalidInput("views that were taken over from an earlier version cannot be replayed");
  }

 private:
  // The last view's plan spoke of another model or other settings.
  [[nodiscard]] AcquisitionState replanned(AcquisitionState next) const {
    if (next.views.empty()) return next;
    next.records.back().plan = nullptr;
    if (input_.images != nullptr) next = planned(std::move(next), *input_.images, progress_.part(0.5, 1.0));
    if (next.profile) next.termination = nextScan(next).termination;
    return next;
  }

  const AcquisitionState& state_;
  const CommandInput& input_;
  const Progress& progress_;
};

}  // namespace

AcquisitionState applyCommand(const AcquisitionState& state, const Command& command, const CommandInput& input,
                              const Progress& progress) {
  return std::visit(Carrier(state, input, progress), command);
}

AcquisitionState planned(AcquisitionState state, const ScannerImages& images, const Progress& progress) {
  const bool needed = state.settings.strategy.kind == Strategy::Kind::PositionalSpace;
  if (!needed || state.views.empty() || currentPlan(state)) return state;
  state.records.back().plan = std::make_shared<const Plan>(planAfter(state, images, stepOptionsFor(state), progress));
  return state;
}

}  // namespace vantage
