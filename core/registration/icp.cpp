#include "registration/icp.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/errors.h"
#include "registration/aligner.h"
#include "registration/pair_term.h"
#include "registration/registration_scale.h"
#include "registration/rivals.h"

namespace vantage {
namespace {

// Before the last rounds the pose need not be better than this share of the final gate.
constexpr double kCoarseTolerance = 0.02;
// A closed model shows a view a part of its points only: this many times the wanted number are looked at.
constexpr std::size_t kLookAtFirst = 4;
constexpr std::size_t kLookAtLast = 8;

void checkOptions(const IcpOptions& options) {
  if (!(*options.finalGate > 0.0) || !(*options.coarseGate >= *options.finalGate))
    throw InvalidInput("registration needs gates with 0 < final gate <= coarse gate");
  if (options.maxIterations < 1) throw InvalidInput("registration needs at least one iteration");
}

PosePrior priorOf(const ViewSurface& surface, const Pose& T_object_scanner, const IcpOptions& options) {
  if (options.prior) return *options.prior;
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : surface.view().mesh.vertices) centre += p;
  centre /= static_cast<double>(std::max<std::size_t>(surface.view().mesh.vertices.size(), 1));
  return isotropicPrior(radians(3.0), looseShift(scaleOf(surface)), T_object_scanner * centre);
}

// What the last round's pairs say about the quality of the fit.
void countPairs(std::span<const Pair> pairs, RegistrationResult& result) {
  std::size_t inFront = 0;
  std::size_t expected = 0;
  double squares = 0.0;
  for (const Pair& pair : pairs) {
    if (pair.state == PairState::Unseen || pair.state == PairState::Border) continue;
    ++expected;
    if (pair.state == PairState::InFront) ++inFront;
    if (pair.state != PairState::Paired) continue;
    ++result.pairs;
    squares += pair.distance * pair.distance;
  }
  if (expected == 0) return;
  result.inlierShare = static_cast<double>(result.pairs) / static_cast<double>(expected);
  result.conflictShare = static_cast<double>(inFront) / static_cast<double>(expected);
  if (result.pairs > 0) result.rms = std::sqrt(squares / static_cast<double>(result.pairs));
}

// Farthest motion for one sigma of the weakest direction, once the prior has had its say.
double sigmaWithPrior(const Stability& s, const PosePrior& prior) {
  Vec6 scale;
  scale << Vec3::Constant(1.0 / std::max(s.radius, 1e-6)), Vec3::Ones();
  const Mat6 toMotion = scale.asDiagonal();
  const Mat6 all = toMotion * (s.information + informationAbout(prior, s.centre)) * toMotion;
  const double least = Eigen::SelfAdjointEigenSolver<Mat6>(all, Eigen::EigenvaluesOnly).eigenvalues()[0];
  return least > 0.0 ? 1.0 / std::sqrt(least) : std::numeric_limits<double>::infinity();
}

// The deviation of pairs that the noise of two surfaces and the straight lines between samples explain [mm].
double explainedDeviation(const ViewSurface& surface) {
  return std::sqrt(2.0) * surface.noise() + 0.03 * surface.view().spacing;
}

RegistrationResult summary(const Fit& fit, const PosePrior& prior) {
  RegistrationResult result;
  result.T_object_scanner = fit.T_object_scanner;
  result.iterations = fit.iterations;
  countPairs(fit.pairs, result);
  PairStability stability;
  stability.add(fit.pairs, fit.T_object_scanner);
  result.stability = stability.analyse(fit.sigma);
  result.poseSigma = sigmaWithPrior(result.stability, prior);
  return result;
}

Evidence evidenceOf(const RegistrationResult& result, const Fit& fit, const ViewSurface& surface) {
  Evidence evidence;
  evidence.pairs = result.pairs;
  evidence.inlierShare = result.inlierShare;
  evidence.conflictShare = result.conflictShare;
  evidence.residual = fit.sigma / std::max(explainedDeviation(surface), 1e-9);
  evidence.heldByPrior = fit.heldByPrior;
  evidence.settled = fit.settled;
  evidence.stability = result.stability;
  return evidence;
}

}  // namespace

RegistrationResult registerView(const ViewMesh& view, const RayGrid& rays, const Pose& T_object_scanner,
                                const RegistrationTarget& model, const IcpOptions& options, const Progress& progress) {
  return registerView(ViewSurface(view, rays), T_object_scanner, model, options, progress);
}

RegistrationResult registerView(const ViewSurface& surface, const Pose& T_object_scanner,
                                const RegistrationTarget& model, const IcpOptions& given, const Progress& progress) {
  const IcpOptions options = resolved(given, scaleOf(surface));
  checkOptions(options);
  const PosePrior prior = priorOf(surface, T_object_scanner, options);
  const Aligner aligner(surface, model, T_object_scanner, prior, options);
  const auto some = aligner.visible(T_object_scanner, aligner.pick(kLookAtFirst * options.coarsePoints),
                                    options.coarsePoints, progress.part(0.0, 0.1, "register"));
  const Fit rough = aligner.run(
      T_object_scanner, some,
      {*options.coarseGate, *options.finalGate, kCoarseTolerance * *options.finalGate, options.maxIterations},
      progress.part(0.1, 0.3));
  const auto many = aligner.visible(rough.T_object_scanner, aligner.pick(kLookAtLast * options.finePoints),
                                    options.finePoints, progress.part(0.3, 0.4));
  const Fit fit = aligner.run(rough.T_object_scanner, many,
                              {*options.finalGate, *options.finalGate, options.tolerance, options.maxIterations},
                              progress.part(0.4, 0.8));

  RegistrationResult result = summary(fit, prior);
  result.iterations += rough.iterations;
  Evidence evidence = evidenceOf(result, fit, surface);
  evidence.motion = aligner.motionInSigmas(fit.T_object_scanner);
  // Only a pose that would be believed needs to fear rivals.
  if (options.searchRivals && judge(evidence, options.limits).verdict == Verdict::Good)
    evidence.rivalDistance =
        findRival(aligner, fit, many, result.stability, prior, options, progress.part(0.8, 1.0)).distance;
  Judgement judgement = judge(evidence, options.limits);
  result.verdict = judgement.verdict;
  result.finding = std::move(judgement.finding);
  return result;
}

}  // namespace vantage
