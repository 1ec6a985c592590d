#include "acquisition/hand_placing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "acquisition/erased_regions.h"
#include "acquisition/prepared_scans.h"
#include "acquisition/scan_placing.h"
#include "acquisition/stand_composites.h"
#include "planning/turn_spread.h"
#include "registration/position_search.h"
#include "registration/registration_scale.h"
#include "registration/registration_target.h"
#include "registration/scan_set.h"
#include "registration/view_network.h"

namespace vantage {
namespace {

// A registration finds its way from so far [rad].
constexpr double kReach = radians(3.0);
// Hands are not trusted beyond so many sigmas: a turn has two ends.
constexpr double kFarthest = 3.2;
constexpr double kWidest = radians(180.0);
// Where little tells turns apart, the best of them by a glance need not be it: so many are registered.
constexpr std::size_t kTried = 12;
// A pose is known when it is sure to this share of the sample spacing.
constexpr double kKnown = 0.4;

// So many views in a row, up to the last one of the stand, are loose: errors of relative turns add up over them.
int looseRun(const AcquisitionState& state, int stand) {
  int run = 0;
  for (auto scan = state.scans.rbegin(); scan != state.scans.rend(); ++scan) {
    if (scan->status != ScanStatus::In || scan->station().stand != stand) continue;
    if (!isLoose(*scan)) break;
    ++run;
  }
  return run;
}

// Where to look for a scan, and how.
struct Search {
  std::vector<Pose> poses;
  IcpOptions free;      // anything is possible around each of them
  IcpOptions onTable;   // nothing that the table does not let happen
  IcpOptions fromHand;  // and all that a hand may do
  double sure = 0.0;    // [mm]
};

Search searchFor(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options) {
  const RangeImage& image = *scan.view.image;
  const int stand = scan.station().stand;
  const Pose T_object_table = tableOf(state, stand);
  const Mechanics& hand = *image.poseUncertainty;
  Search search;
  const double upTo = std::min(kWidest, kFarthest * hand.angleSigma * std::sqrt(1.0 + looseRun(state, stand)));
  const int steps = static_cast<int>(std::ceil(upTo / kReach));
  for (int i = -steps; i <= steps; ++i)
    search.poses.push_back(turnedBy(kReach * i, scan.view.T_object_scanner, T_object_table));
  search.free = search.onTable = search.fromHand = options.registration;
  search.free.prior.reset();
  search.onTable.prior = aboutTable(turntablePrior({kReach, hand.positionSigma}), T_object_table);
  search.fromHand.prior = aboutTable(turntablePrior(hand), T_object_table);
  return search;
}

// Where the few best turns by a glance lead nowhere: the one that is good among more of them.
std::optional<RegistrationResult> goodAmongMore(const Search& search, const ViewSurface& surface,
                                                const RegistrationTarget& target, const Progress& progress) {
  const auto isSure = [](const std::optional<FittingPose>& fits) {
    return fits && fits->registration.verdict == Verdict::Good && fits->rivalDistance == 0.0;
  };
  auto fits = poseThatFits(surface, search.poses, target, search.free, progress.part(0.0, 0.5), kTried);
  if (!isSure(fits))
    fits = poseThatFits(surface, search.poses, target, search.onTable, progress.part(0.5, 1.0), kTried);
  return isSure(fits) ? std::optional(fits->registration) : std::nullopt;
}

// Nothing where the scan fits nowhere by itself.
std::optional<RegistrationResult> foundIn(const Search& search, const ViewSurface& surface,
                                          const RegistrationTarget& target, const Progress& progress) {
  auto fits = poseThatFits(surface, search.poses, target, search.free, progress.part(0.0, 0.3));
  if (!fits) fits = poseThatFits(surface, search.poses, target, search.onTable, progress.part(0.3, 0.6));
  if (!fits) return goodAmongMore(search, surface, target, progress.part(0.6, 1.0));
  if (fits->rivalDistance > 0.0) {
    fits->registration.verdict = Verdict::Doubtful;
    fits->registration.finding = {VerdictReason::Rival, fits->rivalDistance, {}};
  }
  return fits->registration;
}

// A scan that fits views only of which nobody knows how far they were turned is no better known.
RegistrationResult asLoose(RegistrationResult result, const ViewSurface& surface, const Mechanics& hand) {
  if (result.verdict == Verdict::Failed || isUnknown(result, surface.view().spacing)) return result;
  result.verdict = Verdict::Doubtful;
  result.finding = {VerdictReason::HeldByMechanics, std::nullopt, {{WeakMotion::Kind::Turn, Vec3::UnitZ()}}};
  result.poseSigma = std::max(result.poseSigma, hand.angleSigma * 0.5 * scaleOf(surface).extent);
  return result;
}

// What fits only together with doubtful views is no better than they are: an error of theirs is one of its own.
RegistrationResult noBetterThanOthers(const AcquisitionState& state, RegistrationResult result,
                                      const ViewSurface& surface, const IcpOptions& options, const Progress& progress) {
  if (result.verdict != Verdict::Good) return result;
  std::vector<View> good;
  for (const KeptScan* scan : firmScans(state))
    if (scan->record.registration.verdict == Verdict::Good) good.push_back(scan->view);
  if (good.size() == countScans(state, ScanStatus::In)) return result;
  IcpOptions free = options;
  free.prior.reset();
  if (!good.empty() &&
      registerView(surface, result.T_object_scanner, RegistrationTarget(good), free, progress).verdict == Verdict::Good)
    return result;
  result.verdict = Verdict::Doubtful;
  result.finding = {VerdictReason::OnDoubtful, std::nullopt, {}};
  return result;
}

}  // namespace

bool turnedByGuess(const RangeImage& image) {
  return image.poseUncertainty && isGuess(*image.poseUncertainty);
}

bool isUnknown(const RegistrationResult& registration, double spacing) {
  if (registration.verdict != Verdict::Doubtful) return false;
  const VerdictReason reason = registration.finding.reason;
  const bool isMeasured = reason == VerdictReason::HeldByMechanics || reason == VerdictReason::OnDoubtful ||
                          reason == VerdictReason::HeldByFew;
  if (isMeasured) return registration.poseSigma > kKnown * spacing;
  return reason != VerdictReason::FewPairs;
}

bool isLoose(const KeptScan& scan) {
  if (scan.status != ScanStatus::In || !scan.view.image || !scan.view.mesh) return false;
  return turnedByGuess(*scan.view.image) && isUnknown(scan.record.registration, scan.view.mesh->spacing);
}

std::vector<const KeptScan*> firmScans(const AcquisitionState& state) {
  std::vector<const KeptScan*> scans = scansOf(state, ScanStatus::In);
  std::erase_if(scans, [](const KeptScan* scan) { return isLoose(*scan); });
  return scans;
}

std::vector<View> firmViews(const AcquisitionState& state) {
  std::vector<View> views;
  for (const KeptScan* scan : firmScans(state)) views.push_back(scan->view);
  return views;
}

Pose turnedBy(double angle, const Pose& T_object_scanner, const Pose& T_object_table) {
  return T_object_table * Eigen::AngleAxisd(angle, Vec3::UnitZ()) * T_object_table.inverse() * T_object_scanner;
}

RegistrationTarget targetOf(const AcquisitionState& state, int stand) {
  const std::vector<View> firm = firmViews(state);
  if (!firm.empty() && firm.size() != countScans(state, ScanStatus::In)) return RegistrationTarget(firm);
  return targetInStand(state, stand);
}

RegistrationResult registerOnTurn(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options,
                                  const Progress& progress) {
  const PreparedView prepared = preparedViews({&scan}, progress).front();
  const ViewSurface& surface = prepared.surface;
  const Search search = searchFor(state, scan, options);
  const std::vector<View> firm = firmViews(state);
  const bool allFirm = firm.size() == countScans(state, ScanStatus::In);
  if (!allFirm) {
    if (const auto found = foundIn(search, surface, RegistrationTarget(firm), progress.part(0.0, 0.4)))
      return noBetterThanOthers(state, *found, surface, options.registration, progress);
  }
  const RegistrationTarget whole = targetInStand(state, scan.station().stand);
  const auto found = foundIn(search, surface, whole, progress.part(0.4, 0.8));
  const RegistrationResult result =
      found ? *found
            : registerView(surface, scan.view.T_object_scanner, whole, search.fromHand, progress.part(0.8, 1.0));
  return allFirm ? noBetterThanOthers(state, result, surface, options.registration, progress)
                 : asLoose(result, surface, *scan.view.image->poseUncertainty);
}

bool settleLooseViews(AcquisitionState& state, const StepOptions& options, const Progress& progress) {
  bool changed = false;
  for (KeptScan& scan : state.scans) {
    if (!isLoose(scan)) continue;
    const std::vector<View> firm = firmViews(state);
    std::vector<const KeptScan*> scans = firmScans(state);
    scans.push_back(&scan);
    const std::vector<PreparedView> prepared = preparedViews(scans, progress);
    const auto found =
        foundIn(searchFor(state, scan, options), prepared.back().surface, RegistrationTarget(firm), progress);
    std::vector<View> views = firm;
    views.push_back(scan.view);
    if (found) views.back().T_object_scanner = found->T_object_scanner;
    const bool isGood = found && found->verdict == Verdict::Good;
    const bool isKnown = found && found->verdict != Verdict::Failed && !isUnknown(*found, scan.view.mesh->spacing);
    const auto contradiction = contradictionOfLast(
        views, prepared, !isGood, surfaceInStand(state, scan.station().stand), options.registration, progress);
    if (contradiction) {
      scan.status = ScanStatus::Rejected;
      scan.record.registration.verdict = Verdict::Failed;
      scan.record.registration.finding = {VerdictReason::ContradictsOthers, *contradiction, {}};
      scan.view.mesh = nullptr;
      scan.prepared.reset();
    } else if (isKnown) {
      scan.record.registration =
          noBetterThanOthers(state, *found, prepared.back().surface, options.registration, progress);
      scan.view.T_object_scanner = found->T_object_scanner;
    }
    changed = changed || contradiction || isKnown;
  }
  return changed;
}

}  // namespace vantage
