#include "acquisition/step_options.h"

namespace vantage {
namespace {

constexpr double kRecordedBreakdownAngle = radians(75.0);
constexpr double kRecordedAngleSlack = radians(5.0);

StepOptions withBreakdownAngle(const AcquisitionSettings& settings, double breakdownAngle) {
  StepOptions options{{},
                      {{{}, breakdownAngle, 0.0}, settings.cut},
                      settings.thinning,
                      settings.triangulation,
                      settings.registration,
                      settings.refinement,
                      settings.zipper,
                      settings.consensus,
                      settings.planner};
  options.triangulation.breakdownAngle = breakdownAngle;
  options.zipper.breakdownAngle = breakdownAngle;
  options.zipper.mend = false;
  options.planner.voidSpace.breakdownAngle = breakdownAngle;
  return options;
}

}  // namespace

StepOptions stepOptionsFor(const ScannerProfile& profile, const AcquisitionSettings& settings) {
  StepOptions options = withBreakdownAngle(settings, profile.breakdownAngle);
  options.mechanics = profile.mechanics;
  options.cut.scene = cutSceneOf(profile);
  return options;
}

StepOptions stepOptionsFor(const AcquisitionState& state) {
  StepOptions options = state.profile ? stepOptionsFor(*state.profile, state.settings)
                                      : withBreakdownAngle(state.settings, kRecordedBreakdownAngle);
  if (!state.profile && !options.triangulation.angleSlack) options.triangulation.angleSlack = kRecordedAngleSlack;
  options.zipper.mend = state.settings.zipper.mend && state.termination == Termination::Imported;
  return options;
}

ImportOptions importOptionsFor(const AcquisitionState& state) {
  StepOptions step = stepOptionsFor(state);
  // All scans are there.
  step.zipper.mend = state.settings.zipper.mend;
  return {step.cut,
          step.thinning,
          step.triangulation,
          {step.registration, step.refinement, state.settings.alignment},
          step.zipper,
          step.consensus,
          step.planner.voidSpace};
}

}  // namespace vantage
