#include "acquisition/scan_placing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "acquisition/agreement_check.h"
#include "acquisition/erased_regions.h"
#include "acquisition/hand_placing.h"
#include "acquisition/other_turn.h"
#include "acquisition/prepared_scans.h"
#include "acquisition/stand_composites.h"
#include "acquisition/steps.h"
#include "registration/position_search.h"

namespace vantage {
namespace {

// After so many moves nothing is known of where the table is.
constexpr std::int64_t kMostMoves = 10'000;

RegistrationResult firstRegistration(const Pose& T_object_scanner) {
  RegistrationResult result;
  result.T_object_scanner = T_object_scanner;
  result.verdict = Verdict::Good;
  result.finding.reason = VerdictReason::FirstView;
  result.inlierShare = 1.0;
  return result;
}

// The last view of a stand that was taken where its image says.
const KeptScan* lastWhereSaid(const AcquisitionState& state, int stand) {
  const auto last = std::find_if(state.scans.rbegin(), state.scans.rend(), [&](const KeptScan& scan) {
    return scan.status == ScanStatus::In && scan.station().stand == stand && !takenElsewhere(scan);
  });
  return last == state.scans.rend() ? nullptr : &*last;
}

RegistrationResult registerWithModel(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options,
                                     const Progress& progress) {
  const View& view = scan.view;
  if (!state.model) return firstRegistration(view.T_object_scanner);
  if (turnedByGuess(*view.image)) return registerOnTurn(state, scan, options, progress);
  progress.checkpoint(0.0);
  const RegistrationTarget target = targetInStand(state, scan.station().stand);
  progress.checkpoint(0.0);
  IcpOptions registration = options.registration;
  if (const KeptScan* last = lastWhereSaid(state, scan.station().stand)) {
    registration.prior = priorOf(options, *last, scan);
    if (registration.prior) registration.prior = aboutTable(*registration.prior, tableOf(state, scan.station().stand));
  }
  const std::vector<PreparedView> prepared = preparedViews({&scan}, progress);
  return registerView(prepared.front().surface, view.T_object_scanner, target, registration, progress);
}

// Where in the workspace a scan fits which does not fit its own position.
std::optional<FittingPose> otherPlace(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options,
                                      const Progress& progress) {
  if (!state.profile || !state.model || !scan.station().position) return std::nullopt;
  std::vector<Pose> candidates;
  RangeImage there = *scan.view.image;
  for (const Pose& T_table_scanner : state.profile->workspace.poses) {
    there.T_table_scanner = T_table_scanner;
    candidates.push_back(expectedPose(state, there));
  }
  IcpOptions registration = options.registration;
  registration.prior.reset();
  return poseThatFits(preparedViews({&scan}, progress).front().surface, candidates,
                      targetInStand(state, scan.station().stand), registration, progress);
}

// Whether a table moved by itself and said where to: a person may have meant another position.
bool movedByItself(const RangeImage& image) {
  return !image.takenWith.empty() &&
         (image.poseKnownBy == PoseSource::Commanded || image.poseKnownBy == PoseSource::Reported);
}

// How much farther than it said the table turned, when the scan was found there [deg], counter-clockwise from above.
double slipOf(const Pose& expected, const Pose& found) {
  const Eigen::Matrix3d turn = expected.linear() * found.linear().transpose();
  return degrees(std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1)));
}

// Whether the plan sent the scan where it shows nothing of the model.
bool plannedByTable(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options) {
  return state.plan && state.plan->tableAlone && options.mechanics && state.plan->position == scan.station().position &&
         lastView(state, scan.station().stand) != nullptr;
}

// A scan that shows next to nothing of the model, as it was to be expected, and nothing against it, stays where the
// table has it.
void placeByTable(const KeptScan& scan, const StepOptions& options, RegistrationResult& found) {
  if (found.finding.reason != VerdictReason::FewPairs) return;
  if (found.conflictShare > options.registration.limits.maxConflicts) return;
  found.T_object_scanner = scan.view.T_object_scanner;
  found.verdict = Verdict::Doubtful;
  found.finding = {VerdictReason::TableAlone, static_cast<double>(found.pairs), {}};
}

// A table that slipped, or was pushed, brought the scan elsewhere: it counts there, but nothing is good about it.
bool placeWhereSlipped(const AcquisitionState& state, KeptScan& scan, const FittingPose& fits,
                       const StepOptions& options, const Progress& progress) {
  if (!movedByItself(*scan.view.image) || fits.registration.verdict != Verdict::Good || fits.rivalDistance > 0.0)
    return false;
  KeptScan there = scan;
  there.record.registration = fits.registration;
  there.record.registration.verdict = Verdict::Doubtful;
  there.record.registration.finding = {
      VerdictReason::TableSlipped, slipOf(scan.view.T_object_scanner, fits.registration.T_object_scanner), {}};
  checkAgainstOthers(state, there, options, progress);
  if (there.record.registration.verdict == Verdict::Failed) return false;
  scan.record.registration = there.record.registration;
  return true;
}

// The same where the surface alone does not hold the scan, and the axis of the table does.
void placeWhereTurned(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                      const Progress& progress) {
  if (!movedByItself(*scan.view.image)) return;
  KeptScan there = scan;
  there.status = ScanStatus::Rejected;
  const std::vector<double> turns = turnsThatFit(state, there);
  if (turns.size() != 1 || !placedAtTurn(state, there, turns.front(), options, progress.part(0.0, 0.7))) return;
  RegistrationResult& found = there.record.registration;
  found.verdict = Verdict::Doubtful;
  found.finding = {VerdictReason::TableSlipped, slipOf(scan.view.T_object_scanner, found.T_object_scanner), {}};
  checkAgainstOthers(state, there, options, progress.part(0.7, 1.0));
  if (found.verdict != Verdict::Failed) scan.record.registration = found;
}

// A scan that fits another turn of the table counts there where a table that moved by itself slipped; else it is said.
void placeOrNameOtherTurn(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                          const Progress& progress) {
  auto elsewhere = otherTurnOf(state, scan, options, progress.part(0.0, 0.6));
  if (!elsewhere) return;
  scan.record.registration.finding = std::move(*elsewhere);
  placeWhereTurned(state, scan, options, progress.part(0.6, 1.0));
}

// A scan that does not fit its own position may not have been meant to, or fit another.
void explainFailure(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                    const Progress& progress) {
  RegistrationResult& found = scan.record.registration;
  if (plannedByTable(state, scan, options)) return placeByTable(scan, options, found);
  std::optional<FittingPose> fits;
  if (!turnedByGuess(*scan.view.image)) fits = otherPlace(state, scan, options, progress.part(0.0, 0.3));
  if (fits && placeWhereSlipped(state, scan, *fits, options, progress.part(0.3, 0.5))) return;
  placeOrNameOtherTurn(state, scan, options, progress.part(0.5, 1.0));
  const VerdictReason reason = found.finding.reason;
  if (found.verdict != Verdict::Failed || !fits || reason == VerdictReason::OtherTurn ||
      reason == VerdictReason::OtherPosition)
    return;
  const int other = static_cast<int>(fits->candidate);
  if (other != *scan.station().position) found.finding = {VerdictReason::OtherPosition, static_cast<double>(other), {}};
}

// Only looks where a scan was expected.
void placeWhereExpected(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                        const Progress& progress) {
  scan.view.T_object_scanner = expectedPose(state, *scan.view.image);
  scan.record.registration = registerWithModel(state, scan, options, progress.part(0.0, 0.7));
  if (scan.record.registration.verdict != Verdict::Failed)
    checkAgainstOthers(state, scan, options, progress.part(0.7, 1.0));
}

// Whether the last that was seen of the table is that it stands elsewhere than it says: a scan fits another turn.
bool tableInDoubt(const AcquisitionState& state, int stand) {
  for (auto scan = state.scans.rbegin(); scan != state.scans.rend(); ++scan) {
    if (scan->station().stand != stand || !movedByItself(*scan->view.image)) continue;
    if (scan->status == ScanStatus::In) return false;
    if (!turnsThatFit(state, *scan).empty()) return true;
  }
  return false;
}

// What the table's word alone holds is refused while that is in doubt.
void refuseInDoubt(const AcquisitionState& state, KeptScan& scan) {
  RegistrationResult& found = scan.record.registration;
  const VerdictReason reason = found.finding.reason;
  const bool onItsWord = found.verdict == Verdict::Doubtful &&
                         (reason == VerdictReason::HeldByMechanics || reason == VerdictReason::TableAlone);
  if (!onItsWord || !movedByItself(*scan.view.image) || !tableInDoubt(state, scan.station().stand)) return;
  found.verdict = Verdict::Failed;
  found.finding = {VerdictReason::TableInDoubt, std::nullopt, {}};
}

// What became of the scan follows from its registration. @return whether it found its place
bool settled(KeptScan& scan) {
  const bool found = scan.record.registration.verdict != Verdict::Failed;
  scan.status = found ? ScanStatus::In : ScanStatus::Rejected;
  if (found) {
    scan.view.T_object_scanner = scan.record.registration.T_object_scanner;
  } else {
    scan.view.mesh = nullptr;
    scan.prepared.reset();
  }
  return found;
}

}  // namespace

std::optional<PosePrior> priorOf(const StepOptions& options, const KeptScan& from, const KeptScan& to) {
  const RangeImage& image = *to.view.image;
  const std::optional<Mechanics>& mechanics = image.poseUncertainty ? image.poseUncertainty : options.mechanics;
  if (!mechanics) return options.registration.prior;
  if (image.poseKnownBy == PoseSource::ByHand) return turntablePrior(*mechanics);
  const auto moves = std::clamp<std::int64_t>(to.number - from.number, 1, kMostMoves);
  return turntablePrior(*mechanics, static_cast<int>(moves));
}

PosePrior aboutTable(const PosePrior& onTable, const Pose& T_object_table) {
  if (T_object_table.matrix() == Pose::Identity().matrix()) return onTable;
  Mat6 turn = Mat6::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = T_object_table.linear();
  return {turn * onTable.information * turn.transpose(), T_object_table * onTable.centre};
}

std::vector<PoseTie> tiesOf(const AcquisitionState& state, const StepOptions& options) {
  std::vector<PoseTie> ties;
  const std::vector<const KeptScan*> scans = scansOf(state, ScanStatus::In);
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const int stand = scans[i]->station().stand;
    if (scans[i - 1]->station().stand != stand) continue;
    if (scans[i]->record.registration.finding.reason == VerdictReason::TableSlipped) continue;
    if (takenElsewhere(*scans[i - 1]) || takenElsewhere(*scans[i])) continue;
    const Pose T_from_to = scans[i - 1]->view.image->T_table_scanner.inverse() * scans[i]->view.image->T_table_scanner;
    if (const auto prior = priorOf(options, *scans[i - 1], *scans[i]))
      ties.push_back({i - 1, i, T_from_to, aboutTable(*prior, tableOf(state, stand))});
  }
  return ties;
}

Pose expectedPose(const AcquisitionState& state, const RangeImage& image) {
  const KeptScan* last = lastWhereSaid(state, image.station.stand);
  if (last == nullptr) return tableOf(state, image.station.stand) * image.T_table_scanner;
  return last->view.T_object_scanner * last->view.image->T_table_scanner.inverse() * image.T_table_scanner;
}

bool findPlace(const AcquisitionState& state, KeptScan& scan, const StepOptions& options, const Progress& progress) {
  placeWhereExpected(state, scan, options, progress.part(0.0, 0.7));
  const RegistrationResult& registration = scan.record.registration;
  const Progress explaining = progress.part(0.7, 1.0);
  if (registration.verdict == Verdict::Failed) {
    if (registration.finding.reason == VerdictReason::ContradictsOthers)
      placeOrNameOtherTurn(state, scan, options, explaining);
    else
      explainFailure(state, scan, options, explaining);
  }
  refuseInDoubt(state, scan);
  return settled(scan);
}

bool findPlaceAgain(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                    const Progress& progress) {
  placeWhereExpected(state, scan, options, progress);
  return settled(scan);
}

}  // namespace vantage
