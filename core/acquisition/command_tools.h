#pragma once

#include <functional>
#include <memory>

#include "acquisition/acquisition_state.h"
#include "acquisition/phase_times.h"
#include "acquisition/stand_aligner.h"
#include "base/progress.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// What commands are carried out with.
struct CommandInput {
  /// Scans by their number. @throws InvalidInput for a number that no scan has.
  std::function<std::shared_ptr<const RangeImage>(std::int64_t)> scan;
  const ScannerImages* images = nullptr;  ///< of the state's profile; without them no plan is made
  PhaseTimes before = {};                 ///< what was spent on the command before it came here, for the record
  const StandAligner* aligner = nullptr;  ///< null: stands are aligned as always
};

/// The input with the ends that commands share: a plan for what became of the state, and whether something comes next.
class CommandTools {
 public:
  /// Both must outlive it.
  CommandTools(const CommandInput& input, const Progress& progress) : input_(input), progress_(progress) {}

  [[nodiscard]] const CommandInput& input() const { return input_; }
  [[nodiscard]] const Progress& progress() const { return progress_; }
  /// For what comes before the plan.
  [[nodiscard]] Progress firstHalf() const { return progress_.part(0.0, 0.5); }

  /// With a plan for the stand of now, when the strategy needs one and one can be made. @throws Cancelled
  [[nodiscard]] AcquisitionState planned(AcquisitionState next, const Progress& progress) const;
  /// Ended when nothing comes next. Recorded scans without a scanner end as they were brought to an end.
  [[nodiscard]] static AcquisitionState judged(AcquisitionState next);
  /// Planned and judged: the plan spoke of another model, other settings or another stand. @throws Cancelled
  [[nodiscard]] AcquisitionState replanned(AcquisitionState next) const;

 private:
  const CommandInput& input_;
  const Progress& progress_;
};

}  // namespace vantage
