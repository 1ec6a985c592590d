#include "registration/aligner.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "registration/pair_term.h"

namespace vantage {
namespace {

// Points move less than this share of the pose's own uncertainty: it has settled.
constexpr double kSettledShare = 0.1;
// After so many rounds at the final gate steps are halved, in case pairs come and go with every one.
constexpr int kFullSteps = 6;

}  // namespace

struct Aligner::Step {
  Pose motion = Pose::Identity();
  double distance = 0.0;  // [mm] that points move
  double sigma = 0.0;     // [mm] of the weakest motion, with the prior
  int heldByPrior = 0;
};

Aligner::Aligner(const ViewSurface& surface, const RegistrationTarget& model, const Pose& T_object_scanner,
                 const PosePrior& prior, const IcpOptions& options)
    : surface_(surface), model_(model), options_(options), T_start_(T_object_scanner), prior_(prior) {}

std::vector<std::uint32_t> Aligner::pick(std::size_t count) const {
  return thinned(allIndices(model_.size()), count);
}

std::vector<std::uint32_t> Aligner::visible(const Pose& T_object_scanner, const std::vector<std::uint32_t>& ids,
                                            std::size_t count, const Progress& progress) const {
  std::vector<std::optional<GridPosition>> positions(ids.size());
  std::vector<Pair> pairs(ids.size());
  PairGates gates = gatesAt(*options_.coarseGate);
  gates.depth = 3.0 * std::max(*options_.hiddenDepth, *options_.coarseGate);
  findPairs(model_.surface(), ids, T_object_scanner.inverse(), surface_, gates, positions, progress, pairs);
  std::vector<std::uint32_t> seen;
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (pairs[k].state != PairState::Unseen) seen.push_back(ids[k]);
  return thinned(std::move(seen), count);
}

double Aligner::motionInSigmas(const Pose& T_object_scanner) const {
  const Vec6 motion = motionVector(T_object_scanner * T_start_.inverse(), prior_.centre);
  return std::sqrt(std::max(0.0, motion.dot(prior_.information * motion)));
}

PairGates Aligner::gatesAt(double gate) const {
  const bool coarse = gate > 2.5 * *options_.finalGate;
  return {gate, *options_.hiddenDepth, coarse ? options_.coarseAngle : options_.finalAngle};
}

// One Gauss-Newton step of sum w r^2 / sigma^2 + prior.
Aligner::Step Aligner::solve(const Pose& T, std::span<const Pair> pairs, const PairNoise& noise, double share) const {
  const Extent extent = extentOf(pairs, T);
  const PairTerm term = pairTerm(pairs, T, extent.centre, extent.radius, noise);
  const Mat6 toPrior = changeOfCentre(extent.centre, prior_.centre);
  const Vec6 away = motionVector(T * T_start_.inverse(), prior_.centre);
  // Rotations are measured by what they do at the pairs' radius.
  Vec6 scale;
  scale << Vec3::Constant(1.0 / extent.radius), Vec3::Ones();
  const Mat6 toMotion = scale.asDiagonal();
  const Mat6 information =
      toMotion * (term.information + toPrior.transpose() * prior_.information * toPrior) * toMotion;
  const Vec6 pull = toMotion * (term.pull - toPrior.transpose() * prior_.information * away);
  const Vec6 y = share * information.ldlt().solve(pull);

  Step step;
  step.heldByPrior = term.leftOut;
  if (!y.allFinite()) return step;
  step.motion = motionAbout(extent.centre, toMotion * y);
  step.distance = y.norm();
  const double least = Eigen::SelfAdjointEigenSolver<Mat6>(information, Eigen::EigenvaluesOnly).eigenvalues()[0];
  step.sigma = 1.0 / std::sqrt(std::max(least, 1e-12));
  return step;
}

Fit Aligner::run(const Pose& T_object_scanner, const std::vector<std::uint32_t>& ids, const Schedule& schedule,
                 const Progress& progress) const {
  const double leastSigma = std::max(1e-4, 0.02 * surface_.view().spacing);
  Fit fit;
  fit.T_object_scanner = T_object_scanner;
  fit.pairs.resize(ids.size());
  std::vector<std::optional<GridPosition>> positions(ids.size());
  double gate = schedule.firstGate;
  int finalRounds = 0;
  while (true) {
    const double done = fit.iterations / (schedule.maxIterations + 1.0);
    const Progress round = progress.part(done, done + 1.0 / (schedule.maxIterations + 1.0));
    findPairs(model_.surface(), ids, fit.T_object_scanner.inverse(), surface_, gatesAt(gate), positions, round,
              fit.pairs);
    fit.sigma = std::max(leastSigma, 1.4826 * medianDistance(fit.pairs));
    if (fit.settled || fit.iterations == schedule.maxIterations) return fit;
    const Step step = solve(fit.T_object_scanner, fit.pairs, pairNoise(fit.sigma, gate, schedule.lastGate),
                            finalRounds < kFullSteps ? 1.0 : 0.5);
    fit.T_object_scanner = step.motion * fit.T_object_scanner;
    fit.heldByPrior = step.heldByPrior;
    ++fit.iterations;
    if (gate <= schedule.lastGate) {
      ++finalRounds;
      fit.settled = step.distance < std::max(schedule.tolerance, kSettledShare * step.sigma);
    } else {
      // Half at most: what is off by more than most has to be given time to pull.
      const double wanted = step.distance < 0.1 * gate ? 0.5 * gate : std::max(0.5 * gate, 4.0 * fit.sigma);
      gate = std::max(schedule.lastGate, std::min(gate, wanted));
    }
  }
}

}  // namespace vantage
