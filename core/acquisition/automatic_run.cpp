#include "acquisition/automatic_run.h"

#include <algorithm>
#include <utility>

#include "acquisition/apply_command.h"
#include "acquisition/next_scan.h"
#include "base/errors.h"

namespace vantage {
namespace {

Progress stepProgress(const AcquisitionState& state, const Progress& progress) {
  const auto views = static_cast<double>(std::max(1, state.settings.maxViews));
  const auto done = std::min(static_cast<double>(state.views.size()), views - 1.0);
  return progress.part(done / views, (done + 1.0) / views);
}

}  // namespace

ScanStep scanOnce(const AcquisitionState& state, const ScanSource& scans, const ScannerImages& images,
                  const Progress& progress) {
  const NextScan next = nextScan(state);
  if (next.termination != Termination::Running)
    throw InvalidInput("there is nothing left to scan: the acquisition has ended (" +
                       std::string(name(next.termination)) + ")");
  PhaseTimer timer;
  const NumberedScan scan = scans(next.position, timer.watch(progress).part(0.0, 0.1, name(Phase::Scan)));
  const PhaseTimes scanning = timer.finish();

  ScanStep step{AddScan{scan.number, next.predicted}, {}};
  const CommandInput input{[&](std::int64_t /*number*/) { return scan.image; }, &images};
  step.state = applyCommand(state, step.command, input, progress.part(0.1, 1.0));
  const bool added = step.state.views.size() > state.views.size();
  if (added) step.state.records.back().seconds.insert(scanning.begin(), scanning.end());
  return step;
}

AcquisitionState acquire(AcquisitionState state, const ScanSource& scans, const ScannerImages& images,
                         const StepObserver& observer, const Progress& progress) {
  if (state.termination != Termination::Running) return state;
  const Progress planning = stepProgress(state, progress);
  state = planned(std::move(state), images, planning);
  state.termination = nextScan(state).termination;
  while (state.termination == Termination::Running) {
    ScanStep step = scanOnce(state, scans, images, stepProgress(state, progress));
    state = std::move(step.state);
    if (observer) observer(step.command, state);
  }
  return state;
}

}  // namespace vantage
