#include "acquisition/other_turn.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "acquisition/erased_regions.h"
#include "acquisition/hand_placing.h"
#include "acquisition/prepared_scans.h"
#include "acquisition/scan_placing.h"
#include "acquisition/stand_composites.h"
#include "base/errors.h"
#include "registration/position_search.h"
#include "registration/registration_target.h"
#include "registration/scan_set.h"
#include "registration/view_network.h"
#include "scanner/table_turn.h"

namespace vantage {
namespace {

// A registration finds its way from so far [rad].
constexpr double kReach = radians(3.0);
// Turns that differ by less are one [deg].
constexpr double kSameDeg = 1.0;
// To so much they are shown [deg].
constexpr double kShownDeg = 0.1;
// What is known of where the axis is, without mechanics [mm].
constexpr double kAxisSigma = 0.3;
// All around there are more candidates than around one place.
constexpr std::size_t kTried = 12;

Pose standPose(const AcquisitionState& state, const KeptScan& scan) {
  return tableOf(state, scan.station().stand);
}

double differenceDeg(double a, double b) {
  return std::abs(std::remainder(a - b, 360.0));
}

// Of the table, where the scanner is at a pose [deg].
double turnAt(const AcquisitionState& state, const KeptScan& scan, const Pose& T_object_scanner) {
  return inOneTurn(degrees(tableAngle(state.profile->workspace, standPose(state, scan).inverse() * T_object_scanner)));
}

double turnSaid(const AcquisitionState& state, const KeptScan& scan) {
  return degrees(tableAngle(state.profile->workspace, scan.view.image->T_table_scanner));
}

IcpOptions freely(const StepOptions& options) {
  IcpOptions registration = options.registration;
  registration.prior.reset();
  return registration;
}

IcpOptions aboutAxis(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options) {
  const std::optional<Mechanics>& said =
      scan.view.image->poseUncertainty ? scan.view.image->poseUncertainty : options.mechanics;
  IcpOptions registration = options.registration;
  registration.prior =
      aboutTable(turntablePrior({kReach, said ? said->positionSigma : kAxisSigma}), standPose(state, scan));
  return registration;
}

// Whether views whose place is known speak against a place; also that a scan misses much of what they saw does.
bool contradictsOthers(const AcquisitionState& state, const KeptScan& scan, const RegistrationResult& place,
                       const StepOptions& options, const Progress& progress) {
  std::vector<const KeptScan*> scans = firmScans(state);
  scans.push_back(&scan);
  std::vector<View> views;
  for (const KeptScan* each : scans) views.push_back(each->view);
  views.back().T_object_scanner = place.T_object_scanner;
  const std::vector<PreparedView> prepared = preparedViews(scans, progress.part(0.0, 0.5));
  return contradictionOfLast(views, prepared, true, surfaceInStand(state, scan.station().stand), options.registration,
                             progress.part(0.5, 1.0))
      .has_value();
}

// A scan that shows next to nothing of the model may well be where it was said to be: a person turned too far.
bool nothingAgainst(const RegistrationResult& registration, const StepOptions& options) {
  return registration.finding.reason == VerdictReason::FewPairs &&
         registration.conflictShare <= options.registration.limits.maxConflicts;
}

// Every place, the best first, where the scan is a good view and nothing speaks against it.
std::vector<RegistrationResult> goodPlaces(const AcquisitionState& state, const KeptScan& scan,
                                           const std::vector<Pose>& candidates, const StepOptions& options,
                                           const Progress& progress) {
  const PreparedView prepared = preparedViews({&scan}, progress).front();
  const RegistrationTarget target = targetOf(state, scan.station().stand);
  const auto good = [](const std::optional<FittingPose>& fits) {
    return fits && fits->registration.verdict == Verdict::Good;
  };
  std::optional<FittingPose> fits =
      poseThatFits(prepared.surface, candidates, target, freely(options), progress.part(0.0, 0.4), kTried);
  if (!good(fits))
    fits = poseThatFits(prepared.surface, candidates, target, aboutAxis(state, scan, options), progress.part(0.4, 0.8),
                        kTried);
  if (!good(fits)) return {};
  std::vector<RegistrationResult> places{fits->registration};
  for (const Pose& rival : fits->rivals) {
    places.push_back(fits->registration);
    places.back().T_object_scanner = rival;
  }
  const double share = 0.2 / static_cast<double>(places.size());
  double done = 0.8;
  std::erase_if(places, [&](const RegistrationResult& place) {
    const Progress part = progress.part(done, done + share);
    done += share;
    return contradictsOthers(state, scan, place, options, part);
  });
  return places;
}

// All around at the scanner's tilt, and at the other tilts the positions of the workspace.
std::vector<Pose> allAround(const AcquisitionState& state, const KeptScan& scan) {
  std::vector<Pose> candidates;
  const int steps = static_cast<int>(std::lround(2.0 * kPi / kReach));
  for (int i = 0; i < steps; ++i)
    candidates.push_back(turnedBy(kReach * i, scan.view.T_object_scanner, standPose(state, scan)));
  for (const Pose& T_table_scanner : state.profile->workspace.poses)
    candidates.push_back(standPose(state, scan) * T_table_scanner);
  return candidates;
}

// The position that stands at a turn, if one does.
std::optional<int> positionAt(const AcquisitionState& state, const KeptScan& scan, const Pose& T_object_scanner) {
  const Workspace& workspace = state.profile->workspace;
  const Pose T_table_scanner = standPose(state, scan).inverse() * T_object_scanner;
  std::optional<int> nearest;
  double least = 0.0;
  for (int i = 0; i < static_cast<int>(workspace.size()); ++i) {
    const Pose& pose = workspace.poses[static_cast<std::size_t>(i)];
    const double angle =
        Eigen::AngleAxisd(Eigen::Matrix3d(pose.linear().transpose() * T_table_scanner.linear())).angle();
    if (nearest && angle >= least) continue;
    nearest = i;
    least = angle;
  }
  return nearest;
}

bool standsAt(const AcquisitionState& state, const KeptScan& scan, int position, const Pose& T_object_scanner) {
  const Pose there = standPose(state, scan) * state.profile->workspace.poses[static_cast<std::size_t>(position)];
  const Eigen::AngleAxisd off(Eigen::Matrix3d(there.linear().transpose() * T_object_scanner.linear()));
  return degrees(off.angle()) < kSameDeg;
}

}  // namespace

std::optional<Finding> otherTurnOf(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options,
                                   const Progress& progress) {
  if (!state.profile || !state.model || !scan.station().position) return std::nullopt;
  if (turnedByGuess(*scan.view.image) && nothingAgainst(scan.record.registration, options)) return std::nullopt;
  const auto places = goodPlaces(state, scan, allAround(state, scan), options, progress);
  if (places.empty()) return std::nullopt;
  std::vector<double> turns;
  for (const RegistrationResult& place : places) {
    const double turn = turnAt(state, scan, place.T_object_scanner);
    const auto same = [&](double other) { return differenceDeg(turn, other) < kSameDeg; };
    if (std::none_of(turns.begin(), turns.end(), same)) turns.push_back(turn);
  }
  const auto position = positionAt(state, scan, places.front().T_object_scanner);
  if (turns.size() == 1 && position && standsAt(state, scan, *position, places.front().T_object_scanner)) {
    if (*position == *scan.station().position) return std::nullopt;
    if (!turnedByGuess(*scan.view.image))
      return Finding{VerdictReason::OtherPosition, static_cast<double>(*position), {}};
  }
  if (turns.size() == 1 && differenceDeg(turns.front(), turnSaid(state, scan)) < kSameDeg) return std::nullopt;
  return Finding{VerdictReason::OtherTurn, turns.front(), {}, {turns.begin() + 1, turns.end()}};
}

double inOneTurn(double tableDeg) {
  const double turn = std::fmod(std::fmod(tableDeg, 360.0) + 360.0, 360.0);
  return turn < 360.0 - 0.5 * kShownDeg ? turn : 0.0;
}

std::vector<double> turnsThatFit(const AcquisitionState& state, const KeptScan& scan) {
  const Finding& finding = scan.record.registration.finding;
  if (scan.status != ScanStatus::Rejected || !finding.value || !state.profile) return {};
  const Workspace& workspace = state.profile->workspace;
  if (finding.reason == VerdictReason::OtherPosition) {
    const auto position = static_cast<std::size_t>(*finding.value);
    if (position >= workspace.size()) return {};
    return {inOneTurn(degrees(tableAngle(workspace, workspace.poses[position])))};
  }
  if (finding.reason != VerdictReason::OtherTurn) return {};
  std::vector<double> turns{*finding.value};
  turns.insert(turns.end(), finding.rivals.begin(), finding.rivals.end());
  // Those of earlier versions may be negative.
  std::transform(turns.begin(), turns.end(), turns.begin(), inOneTurn);
  return turns;
}

bool fitsTurn(const AcquisitionState& state, const KeptScan& scan, double tableDeg) {
  const std::vector<double> turns = turnsThatFit(state, scan);
  return std::any_of(turns.begin(), turns.end(), [&](double t) { return differenceDeg(t, tableDeg) < kSameDeg; });
}

bool takenElsewhere(const KeptScan& scan) {
  return scan.status == ScanStatus::In && scan.record.registration.finding.reason == VerdictReason::TakenElsewhere;
}

std::optional<int> positionTaken(const AcquisitionState& state, const KeptScan& scan) {
  if (!takenElsewhere(scan) || !scan.station().position) return scan.station().position;
  return positionAt(state, scan, scan.view.T_object_scanner);
}

Pose poseAtTurn(const AcquisitionState& state, const KeptScan& scan, double tableDeg) {
  const Pose T_object_table = standPose(state, scan);
  const Finding& finding = scan.record.registration.finding;
  if (finding.reason == VerdictReason::OtherPosition)
    return T_object_table * state.profile->workspace.poses[static_cast<std::size_t>(*finding.value)];
  // The scanner goes round the object the other way than the table turns.
  return turnedBy(radians(turnSaid(state, scan) - tableDeg), T_object_table * scan.view.image->T_table_scanner,
                  T_object_table);
}

bool placedAtTurn(const AcquisitionState& state, KeptScan& scan, double tableDeg, const StepOptions& options,
                  const Progress& progress) {
  const Pose there = poseAtTurn(state, scan, tableDeg);
  const Pose T_object_table = standPose(state, scan);
  const std::vector<Pose> around{there, turnedBy(0.5 * kReach, there, T_object_table),
                                 turnedBy(-0.5 * kReach, there, T_object_table)};
  const auto places = goodPlaces(state, scan, around, options, progress);
  if (places.empty() || differenceDeg(turnAt(state, scan, places.front().T_object_scanner), tableDeg) > degrees(kReach))
    return false;
  const bool hasRivals = !scan.record.registration.finding.rivals.empty();
  scan.record.registration = places.front();
  scan.record.registration.finding = {VerdictReason::TakenElsewhere, inOneTurn(tableDeg), {}};
  if (hasRivals) scan.record.registration.verdict = Verdict::Doubtful;
  scan.view.T_object_scanner = places.front().T_object_scanner;
  scan.status = ScanStatus::In;
  return true;
}

}  // namespace vantage
