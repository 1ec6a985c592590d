#include "acquisition/acquisition.h"

#include <algorithm>
#include <utility>

#include "acquisition/refusal_error.h"
#include "acquisition/table_place.h"
#include "acquisition/views_to_come.h"

namespace vantage {
namespace {

void allow(const std::optional<Refusal>& refusal) {
  if (refusal) throwRefusal(*refusal);
}

// The part of a run that one more step takes.
Progress stepProgress(const AcquisitionState& state, const Progress& progress) {
  const auto come = viewsToCome(state);
  const auto taken = static_cast<double>(countScans(state, ScanStatus::In));
  const double views = come ? taken + come->views : static_cast<double>(std::max(1, state.settings.maxViews));
  const double done = std::min(taken, views - 1.0);
  return progress.part(done / views, (done + 1.0) / views);
}

}  // namespace

Acquisition::Acquisition(Journal& journal, AcquisitionTools tools, StepObserver observer)
    : journal_(journal), tools_(std::move(tools)), observer_(std::move(observer)) {}

std::optional<Refusal> Acquisition::mayScan() const {
  if (auto refusal = vantage::mayScan(*state())) return refusal;
  if (!tools_.rig) return Refusal{RefusalReason::NothingToScanWith, {}};
  return {};
}

std::optional<Refusal> Acquisition::mayUndo() const {
  if (journal_.history().canUndo()) return {};
  return Refusal{RefusalReason::NothingToUndo, {}};
}

std::optional<Refusal> Acquisition::mayRedo() const {
  if (journal_.history().canRedo()) return {};
  return Refusal{RefusalReason::NothingToRedo, {}};
}

void Acquisition::carryOut(const Command& command, const CommandInput& input, const Progress& progress) {
  record(command, applyCommand(*state(), command, input, progress));
}

void Acquisition::record(const Command& command, AcquisitionState after) {
  const std::shared_ptr<const AcquisitionState> before = state();
  journal_.record(command, std::move(after));
  if (observer_) observer_(command, *before, *state());
}

CommandInput Acquisition::input() const {
  return {[this](std::int64_t number) { return journal_.scan(number); }, tools_.images.get(), {}, tools_.aligner.get()};
}

bool Acquisition::carryOutIf(const Command& command, const std::function<bool(const AcquisitionState& after)>& keep,
                             const Progress& progress) {
  AcquisitionState after = applyCommand(*state(), command, input(), progress);
  if (!keep(after)) return false;
  record(command, std::move(after));
  return true;
}

void Acquisition::carryOut(const Command& command, const Progress& progress) {
  carryOut(command, input(), progress);
}

void Acquisition::undo() {
  allow(mayUndo());
  journal_.undo();
}

void Acquisition::redo() {
  allow(mayRedo());
  journal_.redo();
}

void Acquisition::addScan(RangeImage image, const Progress& progress) {
  const std::shared_ptr<const AcquisitionState> now = state();
  image.station.stand = now->stand();
  const NumberedScan scan = journal_.keepScan(std::move(image));
  AddScan command{scan.number, {}};
  const std::optional<int> position = scan.image->station.position;
  if (now->plan && position) command.predicted = now->plan->scores[static_cast<std::size_t>(*position)];
  carryOut(command, progress);
}

void Acquisition::importScans(std::vector<RangeImage> images, const Progress& progress,
                              std::vector<ScanReading> readings) {
  ImportScans command{{}, std::move(readings)};
  for (RangeImage& image : images) command.scans.push_back(journal_.keepScan(std::move(image)).number);
  carryOut(command, progress);
}

// A scan that an interrupted run left is handed out first, if it was taken from the place asked for.
NumberedScan Acquisition::takeScan(int position, const Progress& progress) {
  const Station station{state()->stand(), position};
  const auto unused = journal_.unusedScan();
  if (unused && unused->image->station == station) return *unused;
  RangeImage image = scanFrom(*tools_.rig, position, progress);
  image.station.stand = station.stand;
  return journal_.keepScan(std::move(image));
}

// The plan belongs to the state: where it is missing, the settings that ask for one are given once more.
void Acquisition::planFirst(const Progress& progress) {
  carryOut(ChangeSettings{state()->settings}, progress);
  if (std::holds_alternative<PlanFirst>(next())) allow(Refusal{RefusalReason::NothingToScanWith, {}});
}

void Acquisition::scanNext(const Progress& progress) {
  allow(mayScan());
  if (std::holds_alternative<PlanFirst>(next())) {
    planFirst(progress.part(0.0, 0.1));
    allow(mayScan());
  }
  const NextScan following = next();
  const auto& from = std::get<ScanFrom>(following);
  PhaseTimer timer;
  const NumberedScan scan = takeScan(from.position, timer.watch(progress).part(0.1, 0.2, name(Phase::Scan)));
  const CommandInput input{[&](std::int64_t /*number*/) { return scan.image; }, tools_.images.get(), timer.finish(),
                           tools_.aligner.get()};
  carryOut(AddScan{scan.number, from.predicted}, input, progress.part(0.2, 1.0));
  // The next position is gone to from where the table really stands.
  if (const auto slip = slipOfLastScan(*state())) tools_.rig->positioner->standsFarther(*slip);
}

Termination Acquisition::runUntilTheEnd(const Progress& progress, const std::function<bool()>& pause) {
  while (state()->termination == Termination::Running) {
    const NextScan following = next();
    if (std::holds_alternative<PlanFirst>(following)) {
      planFirst(stepProgress(*state(), progress));
    } else if (const auto* ended = std::get_if<Ended>(&following)) {
      carryOut(Finish{ended->termination}, progress);
    } else {
      scanNext(stepProgress(*state(), progress));
      if (pause && pause()) break;
    }
  }
  return state()->termination;
}

}  // namespace vantage
