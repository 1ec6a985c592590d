#include "calibration/screw_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "registration/pair_term.h"

namespace vantage {
namespace {

constexpr double kShrink = 0.7;
constexpr double kLeastSigma = 1e-3;  // [mm]
constexpr double kCoarseAngle = radians(45.0);
constexpr double kFineAngle = radians(35.0);
// Unknowns of the axis, before the angles.
constexpr Eigen::Index kAxis = 4;
// Weight of points that nobody sees, in a misfit.
constexpr double kUnseen = 0.1;

// What the unknowns do to a view: the columns are the small motions, rotation and translation about a centre, of
// T_object_scanner of a scan.
Eigen::MatrixXd motionOf(const ScrewMotion& motion, std::size_t scan, const Vec3& centre) {
  const AcrossAxis across(motion.direction);
  const Eigen::Matrix3d left =
      Eigen::Matrix3d::Identity() - Eigen::AngleAxisd(-motion.angles[scan], motion.direction).toRotationMatrix();
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(6, kAxis + static_cast<Eigen::Index>(motion.angles.size()) - 1);
  auto set = [&](Eigen::Index column, const Vec3& rotation, const Vec3& translationOfPoint) {
    columns.col(column).head<3>() = rotation;
    columns.col(column).tail<3>() = translationOfPoint + rotation.cross(centre - motion.point);
  };
  set(0, left * across.first, Vec3::Zero());
  set(1, left * across.second, Vec3::Zero());
  set(2, Vec3::Zero(), left * across.first);
  set(3, Vec3::Zero(), left * across.second);
  if (scan > 0) set(kAxis + static_cast<Eigen::Index>(scan) - 1, -motion.direction, Vec3::Zero());
  return columns;
}

struct Normal {
  Eigen::MatrixXd information;
  Eigen::VectorXd pull;
};

Normal normalEquations(const ScrewMotion& motion, std::span<const ViewLink> links, const PairNoise& noise) {
  const Eigen::Index size = kAxis + static_cast<Eigen::Index>(motion.angles.size()) - 1;
  Normal normal{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  for (const ViewLink& link : links) {
    const Pose T_object_to = motion.pose(link.to);
    const Extent extent = extentOf(link.pairs, T_object_to);
    const PairTerm term = pairTerm(link.pairs, T_object_to, extent.centre, extent.radius, noise);
    const Eigen::MatrixXd x = motionOf(motion, link.to, extent.centre) - motionOf(motion, link.from, extent.centre);
    normal.information += x.transpose() * term.information * x;
    normal.pull += x.transpose() * term.pull;
  }
  return normal;
}

ScrewMotion moved(const ScrewMotion& motion, const Eigen::VectorXd& step) {
  const AcrossAxis across(motion.direction);
  ScrewMotion result = motion;
  const Vec3 lean = step[0] * across.first + step[1] * across.second;
  if (lean.norm() > 0.0)
    result.direction = (Eigen::AngleAxisd(lean.norm(), lean.normalized()) * motion.direction).normalized();
  result.point += step[2] * across.first + step[3] * across.second;
  for (std::size_t k = 1; k < motion.angles.size(); ++k)
    result.angles[k] += step[kAxis + static_cast<Eigen::Index>(k) - 1];
  return result;
}

// Where a motion is against where it began, in its own unknowns.
Eigen::VectorXd awayFrom(const ScrewMotion& start, const ScrewMotion& motion) {
  const AcrossAxis across(motion.direction);
  const Vec3 lean = start.direction.cross(motion.direction);
  const Vec3 shift = motion.point - start.nearestTo(motion.point);
  Eigen::VectorXd away(kAxis + static_cast<Eigen::Index>(motion.angles.size()) - 1);
  away.head<4>() << lean.dot(across.first), lean.dot(across.second), shift.dot(across.first), shift.dot(across.second);
  for (std::size_t k = 1; k < motion.angles.size(); ++k)
    away[kAxis + static_cast<Eigen::Index>(k) - 1] = motion.angles[k] - start.angles[k];
  return away;
}

void hold(const ScrewPrior& prior, const ScrewMotion& start, const ScrewMotion& motion, Normal& normal) {
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(normal.pull.size(), 1.0 / (prior.angle * prior.angle));
  weights.head<2>().setConstant(1.0 / (prior.lean * prior.lean));
  weights.segment<2>(2).setConstant(1.0 / (prior.shift * prior.shift));
  normal.information += weights.asDiagonal();
  normal.pull -= weights.asDiagonal() * awayFrom(start, motion);
}

// The farthest that a step moves anything at a distance from the axis [mm].
double lengthOf(const Eigen::VectorXd& step, double distance) {
  const double turn =
      std::max(step.head<2>().norm(), step.size() > kAxis ? step.tail(step.size() - kAxis).cwiseAbs().maxCoeff() : 0.0);
  return distance * turn + step.segment<2>(2).norm();
}

}  // namespace

ScrewFit fitScrew(std::span<const PreparedView> views, const ScrewMotion& start, std::vector<ViewLink> links,
                  const ScrewSchedule& schedule, const std::optional<ScrewPrior>& prior, const Progress& progress) {
  constexpr double kDistance = 50.0;  // [mm]
  ScrewFit fit{start, std::move(links), 0.0, {}, false};
  double gate = schedule.firstGate;
  for (int round = 0;; ++round) {
    const bool fine = gate <= schedule.lastGate;
    const PairGates gates{gate, schedule.depth, fine ? kFineAngle : kCoarseAngle};
    findPairs(views, fit.motion.poses(), gates, progress, fit.links);
    fit.sigma = std::max(deviation(fit.links), kLeastSigma);
    Normal normal = normalEquations(fit.motion, fit.links, pairNoise(fit.sigma, gate, schedule.lastGate));
    fit.information = normal.information;
    if (fit.settled || round >= schedule.maxIterations) return fit;
    if (prior) hold(*prior, start, fit.motion, normal);
    // What nothing holds stays.
    normal.information.diagonal().array() += 1e-9 * (1.0 + normal.information.diagonal().maxCoeff());
    const Eigen::VectorXd step = normal.information.ldlt().solve(normal.pull);
    if (!step.allFinite()) return fit;
    fit.motion = moved(fit.motion, step);
    fit.settled = fine && lengthOf(step, kDistance) < schedule.tolerance;
    gate = std::max(schedule.lastGate, kShrink * gate);
    progress.checkpoint(std::min(1.0, (round + 1.0) / (schedule.maxIterations + 1.0)));
  }
}

std::vector<double> turnInformation(const ScrewFit& fit) {
  const ScrewMotion& motion = fit.motion;
  const AcrossAxis across(motion.direction);
  // A turn, and the places that it can be about.
  Eigen::Matrix<double, 6, 3> motions = Eigen::Matrix<double, 6, 3>::Zero();
  motions.col(0).head<3>() = motion.direction;
  motions.col(1).tail<3>() = across.first;
  motions.col(2).tail<3>() = across.second;
  std::vector<double> information(motion.angles.size(), 0.0);
  for (const ViewLink& link : fit.links) {
    const Pose T_object_to = motion.pose(link.to);
    const Extent extent = extentOf(link.pairs, T_object_to);
    const PairTerm term = pairTerm(link.pairs, T_object_to, extent.centre, extent.radius, {fit.sigma, 3.0 * fit.sigma});
    const Eigen::Matrix3d m = motions.transpose() * term.information * motions;
    Eigen::Matrix2d places = m.bottomRightCorner<2, 2>();
    places.diagonal().array() += 1e-12 * (1.0 + places.trace());
    const Eigen::Vector2d mixed = m.bottomLeftCorner<2, 1>();
    const double turn = std::max(0.0, m(0, 0) - mixed.dot(places.inverse() * mixed));
    information[link.from] += turn;
    information[link.to] += turn;
  }
  return information;
}

double misfit(std::span<const ViewLink> links, double gate) {
  double sum = 0.0;
  double count = 0.0;
  for (const ViewLink& link : links) {
    sum += kUnseen * static_cast<double>(link.pairs.size());
    count += kUnseen * static_cast<double>(link.pairs.size());
    for (const Pair& pair : link.pairs) {
      if (pair.state == PairState::Unseen || pair.state == PairState::Border) continue;
      const double share = pair.state == PairState::Paired ? std::min(1.0, std::abs(pair.distance) / gate) : 1.0;
      sum += share * share;
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : 1.0;
}

}  // namespace vantage
