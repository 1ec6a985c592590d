#include "calibration/table_calibrator.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.h"
#include "calibration/commanded_turns.h"
#include "calibration/rough_axis.h"
#include "calibration/table_plane.h"
#include "calibration/turning_views.h"

namespace vantage {
namespace {

constexpr std::size_t kFewestScans = 3;
constexpr std::size_t kMostScans = 12;
constexpr double kPlaneLean = radians(6.0);
constexpr double kMinOverlap = 0.05;
constexpr std::size_t kFinePoints = 60000;
constexpr std::size_t kLeastPoints = 500;
constexpr double kFineGates = 3.0;
// A search that came to less than that need not be repeated from elsewhere.
constexpr double kGoodMisfit = 0.25;
// Where angles count, by what they do at that distance from the axis [mm].
constexpr double kDistance = 50.0;
constexpr double kResidualLarge = 3.0;
constexpr double kUnderside = 0.1;  // of the extent of what a view shows
// Covariances of surfaces take samples for independent, which they are not.
constexpr double kSigmaFactor = 2.0;

void require(std::span<const CalibrationScan> scans) {
  if (scans.size() < kFewestScans || scans.size() > kMostScans)
    throw InvalidInput("there are " + std::to_string(scans.size()) + " scans, expected " +
                       std::to_string(kFewestScans) + " to " + std::to_string(kMostScans) + " at known table angles");
  for (std::size_t k = 0; k < scans.size(); ++k)
    if (!std::isfinite(scans[k].tableAngle))
      throw InvalidInput("scan " + std::to_string(k + 1) + " has no table angle, expected a number of degrees");
}

// The scans as they are worked on: all on the rays of the first one.
std::vector<CalibrationScan> thinnedScans(std::span<const CalibrationScan> scans, const ThinningOptions& options) {
  std::vector<CalibrationScan> some(scans.begin(), scans.end());
  const int step = thinningStep(*scans.front().image, options);
  std::shared_ptr<const RayGrid> rays;
  for (CalibrationScan& scan : some) {
    if (scan.image->rays->rows() != scans.front().image->rays->rows() ||
        scan.image->rays->columns() != scans.front().image->rays->columns())
      return {scans.begin(), scans.end()};
    scan.image = thinned(scan.image, step, rays);
    rays = scan.image->rays;
  }
  return some;
}

std::vector<double> anglesOf(std::span<const CalibrationScan> scans) {
  std::vector<double> angles;
  for (const CalibrationScan& scan : scans) angles.push_back(scan.tableAngle);
  return angles;
}

double spanOf(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

std::vector<TurnCandidate> search(const TurningViews& views, std::span<const CalibrationScan> scans,
                                  const std::optional<PlaneFit>& table, const RegistrationScale& scale,
                                  const RatioRange& range, const Progress& progress) {
  const std::vector<double> tableAngles = anglesOf(scans);
  const auto axes = roughAxes(table, views.centre(), *scans.front().image->rays, scale.extent);
  std::vector<TurnCandidate> best;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const double count = static_cast<double>(axes.size());
    auto candidates = searchTurns(views.views(), tableAngles, axes[k].point, axes[k].direction, scale, range,
                                  progress.part(static_cast<double>(k) / count, static_cast<double>(k + 1) / count));
    if (candidates.empty()) continue;
    if (best.empty() || candidates.front().misfit < best.front().misfit) best = std::move(candidates);
    if (best.front().misfit < kGoodMisfit) break;
  }
  return best;
}

// The motion fitted to all pairs of scans that overlap.
ScrewFit refined(const TurningViews& views, const ScrewMotion& start, const RegistrationScale& scale,
                 const Progress& progress) {
  const double gate = fineGate(scale);
  const PairGates gates{kFineGates * gate, std::max(scale.extent / 12.0, 4.0 * gate), radians(45.0)};
  auto links =
      findLinks(views.views(), start.poses(), gates, kMinOverlap, kFinePoints, kLeastPoints, progress.part(0.0, 0.2));
  const ScrewSchedule schedule{gates.distance, gate, gates.depth, 40, 1e-3};
  return fitScrew(views.views(), start, std::move(links), schedule, ScrewPrior(), progress.part(0.2, 1.0));
}

struct Sigmas {
  double lean = 1e3;   // [rad]
  double shift = 1e6;  // [mm]
  double angle = 1e3;  // [rad]
};

double largest(const Eigen::Matrix2d& covariance) {
  return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues()[1]));
}

// What covariances are multiplied by: a sample that is in many pairs says no more than one.
double inflation(const ScrewFit& fit, const std::vector<std::size_t>& samples) {
  double pairs = 0.0;
  double independent = 0.0;
  for (const ViewLink& link : fit.links) pairs += static_cast<double>(link.pairs.size());
  for (const std::size_t count : samples) independent += static_cast<double>(count);
  return kSigmaFactor * kSigmaFactor * std::max(1.0, pairs / std::max(independent, 1.0));
}

Sigmas sigmasOf(const ScrewFit& fit, const std::vector<std::size_t>& samples) {
  const Eigen::Index size = fit.information.rows();
  const Eigen::LDLT<Eigen::MatrixXd> factors(fit.information);
  if (factors.info() != Eigen::Success || !factors.isPositive() || factors.rcond() < 1e-14) return {};
  const Eigen::MatrixXd covariance = inflation(fit, samples) * factors.solve(Eigen::MatrixXd::Identity(size, size));
  if (!covariance.allFinite() || covariance.diagonal().minCoeff() < 0.0) return {};
  // What the usual scan shows of its turn by itself.
  std::vector<double> turns = turnInformation(fit);
  std::sort(turns.begin(), turns.end());
  const double turn = std::sqrt(inflation(fit, samples) / std::max(turns[turns.size() / 2], 1e-6));
  return {largest(covariance.topLeftCorner<2, 2>()), largest(covariance.block<2, 2>(2, 2)),
          std::max(turn, std::sqrt(covariance.diagonal().tail(size - 4).maxCoeff()))};
}

// The same turns about the axis in the direction that points up from the table.
ScrewMotion upright(ScrewMotion motion, const Vec3& up, const Vec3& centre) {
  motion.point = motion.nearestTo(centre);
  if (motion.direction.dot(up) >= 0.0) return motion;
  motion.direction = -motion.direction;
  for (double& angle : motion.angles) angle = -angle;
  return motion;
}

// Root mean square and number of the pairs of one scan with the others.
void addPairs(const ScrewFit& fit, std::size_t scan, ScanResidual& residual) {
  double squares = 0.0;
  for (const ViewLink& link : fit.links) {
    if (link.from != scan && link.to != scan) continue;
    for (const Pair& pair : link.pairs) {
      if (pair.state != PairState::Paired) continue;
      squares += pair.distance * pair.distance;
      ++residual.pairs;
    }
  }
  if (residual.pairs > 0) residual.rms = std::sqrt(squares / static_cast<double>(residual.pairs));
}

// How badly one scan lies between the others.
double misfitOf(const ScrewFit& fit, std::size_t scan, double gate) {
  std::vector<ViewLink> links;
  for (const ViewLink& link : fit.links)
    if (link.from == scan || link.to == scan) links.push_back(link);
  return misfit(links, gate);
}

// Height of the lowest point of what turns, along an axis from its point.
double lowestPoint(const TurningViews& views, const ScrewMotion& motion) {
  std::vector<double> heights;
  for (const PreparedView& view : views.views())
    for (std::size_t k = 0; k < view.points.size(); ++k)
      heights.push_back((view.points.pointAt(k) - motion.point).dot(motion.direction));
  if (heights.empty()) return 0.0;
  // A few samples fly.
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 200);
  std::nth_element(heights.begin(), low, heights.end());
  return *low;
}

// Makes the findings one after the other; the first that is fatal ends it.
class Calibrator {
 public:
  Calibrator(std::span<const CalibrationScan> scans, const ScannerProfile& profile, const CalibrationOptions& options)
      : scans_(scans.begin(), scans.end()), profile_(profile), options_(options) {}

  CalibrationResult run(const Progress& progress) {
    solve(progress);
    auto& findings = result_.findings;
    std::stable_sort(findings.begin(), findings.end(),
                     [](const auto& a, const auto& b) { return worthOf(a) > worthOf(b); });
    result_.calibration.verdict = findings.empty() ? CalibrationVerdict::Good : worthOf(findings.front());
    return std::move(result_);
  }

 private:
  void find(CalibrationReason reason, std::optional<double> value = {}, std::optional<std::size_t> scan = {}) {
    if (scan && !place_.empty()) scan = place_[*scan];
    result_.findings.push_back({reason, value, scan});
  }

  void solve(const Progress& progress);
  [[nodiscard]] bool keepTurning(const std::vector<std::size_t>& samples);
  [[nodiscard]] bool judgeFit(const std::vector<TurnCandidate>& candidates);
  void judgeRivals(const std::vector<TurnCandidate>& candidates);
  [[nodiscard]] bool judgeSigmas(const ScrewFit& fit, const TurningViews& views);
  void judgeScans(const ScrewFit& fit, double gate);
  void judgeTurns(const ScrewFit& fit);
  void judgeResiduals(const ScrewFit& fit, const RegistrationScale& scale);
  [[nodiscard]] Vec3 upSide(const ScrewMotion& motion, std::span<const std::vector<SampleMotion>> motions) const;
  void placeTable(const ScrewMotion& motion, const TurningViews& views,
                  std::span<const std::vector<SampleMotion>> motions, const RegistrationScale& scale);

  std::vector<CalibrationScan> scans_;  // those that are used
  std::vector<std::size_t> place_;      // of each, among all
  const ScannerProfile& profile_;
  const CalibrationOptions& options_;
  CalibrationResult result_;
};

void Calibrator::solve(const Progress& progress) {
  const double commanded = spanOf(anglesOf(scans_));
  if (options_.ratio.most * radians(commanded) < options_.leastTurn)
    return find(CalibrationReason::TooSmallTurn, commanded);
  auto motions = sampleMotions(scans_);
  TablePlaneSearch rough;
  rough.mostLean = kRoughAxisLean;
  const auto table = findTablePlane(scans_, motions, rough);
  progress.checkpoint(0.05);
  TurningViews moving(scans_, motions, table, profile_.breakdownAngle, progress.part(0.05, 0.1));
  if (!keepTurning(moving.samples())) return;
  if (place_.size() < motions.size()) {
    std::vector<std::vector<SampleMotion>> kept;
    for (const std::size_t k : place_) kept.push_back(std::move(motions[k]));
    motions = std::move(kept);
    moving = TurningViews(scans_, motions, table, profile_.breakdownAngle, progress.part(0.1, 0.1));
  }

  const RegistrationScale scale = scaleOf(moving.views());
  const auto candidates = search(moving, scans_, table, scale, options_.ratio, progress.part(0.1, 0.6));
  if (!judgeFit(candidates)) return;
  const ScrewFit first = refined(moving, candidates.front().fit.motion, scale, progress.part(0.6, 0.7));
  const TurningViews whole = moving.withRound(first.motion, kFineGates * fineGate(scale), progress.part(0.7, 0.8));
  // What is sure of the axis counts where the object is.
  ScrewMotion start = first.motion;
  start.point = start.nearestTo(whole.centre());
  ScrewFit fit = refined(whole, start, scale, progress.part(0.8, 0.98));
  if (!judgeSigmas(fit, whole)) return;
  judgeRivals(candidates);
  const ScrewMotion motion = upright(fit.motion, table ? table->normal : upSide(fit.motion, motions), whole.centre());
  fit.motion = motion;
  judgeScans(fit, kFineGates * fineGate(scale));
  judgeTurns(fit);
  judgeResiduals(fit, scale);
  placeTable(motion, whole, motions, scale);
}

// The side of the table that the object is on, where the table top was not seen in the profile's frame: as samples of
// the top tell, else as z or the rows of the grid do.
Vec3 Calibrator::upSide(const ScrewMotion& motion, std::span<const std::vector<SampleMotion>> motions) const {
  for (const double side : {1.0, -1.0}) {
    const TablePlaneSearch near{side * motion.direction, kPlaneLean, motion.point, 1.2 * profile_.viewingVolume.radius};
    if (findTablePlane(scans_, motions, near)) return near.normal;
  }
  if (std::abs(motion.direction.z()) > 0.5) return Vec3::UnitZ();
  return upAlongColumns(*scans_.front().image->rays, motion.point);
}

// Keeps the scans that show enough of what turns.
bool Calibrator::keepTurning(const std::vector<std::size_t>& samples) {
  std::vector<CalibrationScan> kept;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    result_.scans.push_back({scans_[k].tableAngle, 0.0, 0.0, 0.0, 0, samples[k], false});
    if (samples[k] < options_.leastSamples) continue;
    kept.push_back(scans_[k]);
    place_.push_back(k);
  }
  scans_ = std::move(kept);
  if (scans_.size() >= kFewestScans) return true;
  const auto fewest = std::min_element(samples.begin(), samples.end());
  place_.clear();
  find(CalibrationReason::NothingTurns, static_cast<double>(*fewest),
       static_cast<std::size_t>(fewest - samples.begin()));
  return false;
}

bool Calibrator::judgeFit(const std::vector<TurnCandidate>& candidates) {
  if (candidates.empty() || candidates.front().misfit > options_.mostMisfit) {
    find(CalibrationReason::NoCommonAxis, candidates.empty() ? 1.0 : candidates.front().misfit);
    return false;
  }
  return true;
}

void Calibrator::judgeRivals(const std::vector<TurnCandidate>& candidates) {
  const TurnCandidate& best = candidates.front();
  for (std::size_t k = 1; k < candidates.size(); ++k) {
    if (candidates[k].misfit > options_.leastRival * best.misfit) continue;
    return find(CalibrationReason::Rival, candidates[k].turnsPerCount);
  }
}

bool Calibrator::judgeSigmas(const ScrewFit& fit, const TurningViews& views) {
  const Sigmas sigmas = sigmasOf(fit, views.samples());
  result_.calibration.sigma = std::min(sigmas.shift, 1e5);
  result_.calibration.angleSigma = std::min(sigmas.lean, kPi);
  const double unsure = std::max({sigmas.shift, kDistance * sigmas.lean, kDistance * sigmas.angle});
  if (unsure > options_.notObservable) {
    find(CalibrationReason::RotationNotObservable, std::min(unsure, 1e5));
    return false;
  }
  if (sigmas.shift > options_.unsure || sigmas.lean > options_.unsureAngle)
    find(CalibrationReason::Unsure, std::max(sigmas.shift, kDistance * sigmas.lean));
  return true;
}

// A scan that lies badly is one that the table did not turn to.
void Calibrator::judgeScans(const ScrewFit& fit, double gate) {
  for (std::size_t k = 0; k < scans_.size(); ++k) {
    const double bad = misfitOf(fit, k, gate);
    if (bad > options_.mostMisfit) return find(CalibrationReason::NoCommonAxis, bad, k);
  }
}

void Calibrator::judgeTurns(const ScrewFit& fit) {
  const CommandedTurns turns = explainTurns(anglesOf(scans_), fit.motion.angles);
  result_.calibration.sense = turns.sense;
  result_.calibration.degreesPerCommandedDegree = turns.ratio;
  for (std::size_t k = 0; k < scans_.size(); ++k) {
    ScanResidual& residual = result_.scans[place_[k]];
    residual.used = true;
    residual.turned = fit.motion.angles[k];
    residual.off = turns.off[k];
    addPairs(fit, k, residual);
  }
  const double turned = spanOf(fit.motion.angles);
  if (turned < options_.leastTurn) find(CalibrationReason::TooSmallTurn, degrees(turned));
  if (turns.slippedBefore)
    find(CalibrationReason::Slip, turns.sense * degrees(turns.off[*turns.slippedBefore]), turns.slippedBefore);
  if (turns.sense < 0) find(CalibrationReason::TurnsOtherWay);
  if (turns.ratio != 1.0) find(CalibrationReason::OtherRatio, turns.ratio);
}

void Calibrator::judgeResiduals(const ScrewFit& fit, const RegistrationScale& scale) {
  double squares = 0.0;
  double pairs = 0.0;
  std::size_t worst = 0;
  for (std::size_t k = 0; k < result_.scans.size(); ++k) {
    const ScanResidual& scan = result_.scans[k];
    squares += scan.rms * scan.rms * static_cast<double>(scan.pairs);
    pairs += static_cast<double>(scan.pairs);
    if (scan.rms > result_.scans[worst].rms) worst = k;
  }
  result_.calibration.residual = pairs > 0.0 ? std::sqrt(squares / pairs) : 0.0;
  // Both surfaces of a pair have noise; between samples they are chords.
  const double explained = std::sqrt(2.0) * scale.noise + 0.05 * scale.spacing;
  if (fit.sigma <= kResidualLarge * explained) return;
  result_.findings.push_back({CalibrationReason::ResidualLarge, fit.sigma / explained, worst});
}

void Calibrator::placeTable(const ScrewMotion& motion, const TurningViews& views,
                            std::span<const std::vector<SampleMotion>> motions, const RegistrationScale& scale) {
  TableCalibration& calibration = result_.calibration;
  calibration.axisPoint = motion.point;
  calibration.axisDirection = motion.direction;
  const TablePlaneSearch near{motion.direction, kPlaneLean, motion.point, 1.2 * profile_.viewingVolume.radius};
  if (const auto plane = findTablePlane(scans_, motions, near)) {
    result_.planeSeen = true;
    calibration.planeNormal = plane->normal;
    calibration.planeOffset = plane->offset;
    result_.planeSigma = plane->rms / std::sqrt(static_cast<double>(plane->count)) *
                         (1.0 + (tableCentre(calibration) - plane->centre).norm() / std::max(plane->extent, 1.0));
    const double lean = std::acos(std::min(1.0, plane->normal.dot(motion.direction)));
    if (lean > options_.planeLean) find(CalibrationReason::PlaneLeans, degrees(lean));
    return;
  }
  // The profile's table plane is z = 0; nothing of the object is below the table. How far up level rays end on an
  // underside that is rounded nobody knows: a tenth of the object is usual.
  const double lowest = lowestPoint(views, motion);
  double height = lowest;
  double off = std::max(scale.spacing, kUnderside * scale.extent);
  if (motion.direction.z() > std::cos(kRoughAxisLean)) {
    const double said = -motion.point.z() / motion.direction.z();
    height = std::min(lowest, said);
    off = std::max(off, 0.5 * std::abs(lowest - said));
  }
  result_.planeSigma = off;
  find(CalibrationReason::TableNotSeen, off);
  calibration.planeNormal = motion.direction;
  calibration.planeOffset = -motion.direction.dot(motion.point) - height;
}

}  // namespace

CalibrationResult calibrateTable(std::span<const CalibrationScan> scans, const ScannerProfile& profile,
                                 const CalibrationOptions& options, const Progress& progress) {
  require(scans);
  CalibrationResult result = Calibrator(thinnedScans(scans, options.thinning), profile, options).run(progress);
  progress.checkpoint(1.0);
  return result;
}

}  // namespace vantage
