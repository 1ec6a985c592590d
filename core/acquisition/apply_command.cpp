#include "acquisition/apply_command.h"

#include <utility>

#include "acquisition/import_scans.h"
#include "acquisition/may_do.h"
#include "acquisition/next_scan.h"
#include "acquisition/refusal_error.h"
#include "acquisition/steps.h"
#include "base/errors.h"

namespace vantage {
namespace {

// Carries out one kind of command each.
class Carrier {
 public:
  Carrier(const AcquisitionState& state, const CommandInput& input, const Progress& progress)
      : state_(state), input_(input), progress_(progress) {}

  AcquisitionState operator()(const ChangeSettings& command) const {
    AcquisitionState next = state_;
    next.settings = command.settings;
    return replanned(std::move(next));
  }

  AcquisitionState operator()(const AddScan& command) const {
    PhaseTimer timer;
    const Progress watched = timer.watch(progress_);
    const auto image = input_.scan(command.scan);
    checkPosition(*image);
    AcquisitionState next =
        addScan(state_, {command.scan, image}, command.predicted, stepOptionsFor(state_), watched.part(0.0, 0.5));
    next.chosenPosition.reset();
    next.termination = Termination::Running;
    if (next.scans.back().status != ScanStatus::In) return judged(std::move(next));
    next = planned(std::move(next), watched.part(0.5, 1.0));
    ScanRecord& record = next.scans.back().record;
    record.planAfter = next.plan;
    record.seconds = timer.finish();
    record.seconds.insert(input_.before.begin(), input_.before.end());
    return judged(std::move(next));
  }

  AcquisitionState operator()(const ImportScans& command) const {
    std::vector<NumberedScan> scans;
    for (const std::int64_t scan : command.scans) scans.push_back({scan, input_.scan(scan)});
    return importScans(state_, scans, importOptionsFor(state_), progress_);
  }

  AcquisitionState operator()(const ChoosePosition& command) const {
    AcquisitionState next = state_;
    next.chosenPosition = command.position;
    if (command.position) next.termination = Termination::Running;
    return judged(std::move(next));
  }

  AcquisitionState operator()(const LeaveOutView& command) const {
    return replanned(withStatus(state_, command.scan, ScanStatus::LeftOut, stepOptionsFor(state_), firstHalf()));
  }

  AcquisitionState operator()(const TakeBackView& command) const {
    return replanned(withStatus(state_, command.scan, ScanStatus::In, stepOptionsFor(state_), firstHalf()));
  }

  AcquisitionState operator()(const Finish& command) const {
    AcquisitionState next = state_;
    next.termination = command.termination;
    return next;
  }

  AcquisitionState operator()(const TakeOver& /*command*/) const { return state_; }

  AcquisitionState operator()(const TurnObject& command) const {
    AcquisitionState next = state_;
    next.stands.push_back({command.T_object_table});
    next.chosenPosition.reset();
    next.termination = Termination::Running;
    return replanned(std::move(next));
  }

  AcquisitionState operator()(const PlaceStand& command) const {
    return replanned(placeStand(state_, command.stand, command.T_object_table, stepOptionsFor(state_), firstHalf()));
  }

  AcquisitionState operator()(const ChangeMode& command) const {
    AcquisitionState next = state_;
    next.mode = command.mode;
    return next;
  }

 private:
  [[nodiscard]] Progress firstHalf() const { return progress_.part(0.0, 0.5); }

  void checkPosition(const RangeImage& image) const {
    const std::optional<int> position = image.station.position;
    const auto positions = static_cast<int>(state_.profile->workspace.size());
    if (!position || *position < 0 || *position >= positions)
      throw InvalidInput((position ? "position " + std::to_string(*position) + " of the scan does not exist"
                                   : std::string("the scan is of no position")) +
                         ", the workspace has positions 0 to " + std::to_string(positions - 1));
  }

  // With a plan for the stand of now, when the strategy needs one.
  [[nodiscard]] AcquisitionState planned(AcquisitionState next, const Progress& progress) const {
    next.plan = nullptr;
    const bool needed = next.settings.strategy.kind == Strategy::Kind::PositionalSpace;
    const bool possible = input_.images != nullptr && next.profile && next.model && next.stands.back().T_object_table;
    if (needed && possible)
      next.plan = std::make_shared<const Plan>(planAfter(next, *input_.images, stepOptionsFor(next), progress));
    return next;
  }

  // Whether something comes next. Recorded scans without a scanner end as they were brought to an end.
  [[nodiscard]] static AcquisitionState judged(AcquisitionState next) {
    if (next.profile) next.termination = terminationOf(nextScan(next));
    return next;
  }

  // The plan spoke of another model, other settings or another stand.
  [[nodiscard]] AcquisitionState replanned(AcquisitionState next) const {
    return judged(planned(std::move(next), progress_.part(0.5, 1.0)));
  }

  const AcquisitionState& state_;
  const CommandInput& input_;
  const Progress& progress_;
};

}  // namespace

AcquisitionState applyCommand(const AcquisitionState& state, const Command& command, const CommandInput& input,
                              const Progress& progress) {
  if (const auto refusal = mayDo(state, command)) throwRefusal(*refusal);
  return std::visit(Carrier(state, input, progress), command);
}

}  // namespace vantage
