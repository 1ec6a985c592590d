#include "registration/prepared_refinement.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"
#include "base/parallel.h"
#include "registration/icp.h"
#include "registration/pair_term.h"
#include "registration/registration_scale.h"

namespace vantage {
namespace {

constexpr double kLeastSigma = 1e-4;  // [mm]
constexpr double kPriorAngle = radians(3.0);
// While few points are looked up the poses need not be better than this share of the final gate.
constexpr double kCoarseTolerance = 0.02;
// The error may rise so much when poses give in to the ties: the pairs' noise has been fitted before.
constexpr double kMayRise = 1.02;
// Motions are open where the pairs hold them so many times less surely than a good pose.
constexpr double kOpenSigmas = 4.0;
constexpr int kRoundsBack = 4;
// What was open has been fitted to the noise before, and is not afterwards.
constexpr double kMayRiseBack = 1.1;
// Sigma of a motion that no pairs hold [fine gates].
constexpr double kLoose = 1000.0;

// The sparse normal equations of all poses but the first, which stays.
class NormalEquations {
 public:
  explicit NormalEquations(std::size_t views)
      : unknowns_(static_cast<Eigen::Index>(6 * (views - 1))), pull_(Eigen::VectorXd::Zero(unknowns_)) {}

  // The motion of `to` against `from`.
  void addLink(std::size_t from, std::size_t to, const PairTerm& term) {
    addBlock(from, from, term.information);
    addBlock(to, to, term.information);
    addBlock(from, to, -term.information);
    addBlock(to, from, -term.information);
    addPull(from, -term.pull);
    addPull(to, term.pull);
  }

  void addPrior(std::size_t view, const Mat6& information, const Vec6& pull) {
    addBlock(view, view, information);
    addPull(view, pull);
  }

  // The motions of all views, that of the first zero; all zero when there is no solution.
  [[nodiscard]] std::vector<Vec6> solve() const {
    std::vector<Vec6> motions(static_cast<std::size_t>(unknowns_ / 6) + 1, Vec6::Zero());
    Eigen::SparseMatrix<double> system(unknowns_, unknowns_);
    system.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
    if (solver.info() != Eigen::Success) return motions;
    const Eigen::VectorXd x = solver.solve(pull_);
    if (!x.allFinite()) return motions;
    for (std::size_t i = 1; i < motions.size(); ++i) motions[i] = x.segment<6>(first(i));
    return motions;
  }

  // About the motions of all views but the first, rotations measured by what they do at a radius [1/mm^2].
  [[nodiscard]] Eigen::MatrixXd information(double radius) const {
    const Eigen::VectorXd scales = scalesFor(radius);
    Eigen::SparseMatrix<double> system(unknowns_, unknowns_);
    system.setFromTriplets(entries_.begin(), entries_.end());
    return scales.asDiagonal() * Eigen::MatrixXd(system) * scales.asDiagonal();
  }

  // Where they are least is information times motions = pull [1/mm].
  [[nodiscard]] Eigen::VectorXd pull(double radius) const { return scalesFor(radius).asDiagonal() * pull_; }

 private:
  [[nodiscard]] Eigen::VectorXd scalesFor(double radius) const {
    Vec6 scale;
    scale << Vec3::Constant(1.0 / radius), Vec3::Ones();
    return scale.replicate(unknowns_ / 6, 1);
  }

  static Eigen::Index first(std::size_t view) { return static_cast<Eigen::Index>(6 * (view - 1)); }

  void addBlock(std::size_t i, std::size_t j, const Mat6& block) {
    if (i == 0 || j == 0) return;
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c)
        entries_.emplace_back(static_cast<int>(first(i)) + r, static_cast<int>(first(j)) + c, block(r, c));
  }
  void addPull(std::size_t i, const Vec6& v) {
    if (i > 0) pull_.segment<6>(first(i)) += v;
  }

  Eigen::Index unknowns_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd pull_;
};

class Refiner {
 public:
  Refiner(std::span<const View> views, std::span<const PreparedView> prepared, const MultiViewOptions& options)
      : views_(prepared), scale_(scaleOf(views_)), options_(resolved(options, scale_)) {
    for (const View& view : views) start_.push_back(view.T_object_scanner);
    poses_ = start_;
    measureObject();
    tied_.assign(views.size(), false);
    for (const PoseTie& tie : options.ties) tied_[tie.to] = true;
  }

  MultiViewResult run(const Progress& progress) {
    MultiViewResult result;
    auto rough = findLinks(views_, poses_, gatesAt(*options_.coarseGate), options_.minOverlap, options_.coarsePoints,
                           options_.leastPoints, progress.part(0.0, 0.1));
    result.rmsBefore = errorOf(rough, progress.part(0.1, 0.15));
    const double tensionBefore = tension();
    std::vector<ViewLink> judges = rough;
    settle(rough, *options_.coarseGate, kCoarseTolerance * *options_.finalGate, progress.part(0.15, 0.4),
           result.iterations);
    auto fine = findLinks(views_, poses_, gatesAt(*options_.finalGate), options_.minOverlap, options_.finePoints,
                          options_.leastPoints, progress.part(0.4, 0.45));
    settle(fine, *options_.finalGate, options_.tolerance, progress.part(0.45, 0.95), result.iterations);
    result.rmsAfter = errorOf(judges, progress.part(0.95, 1.0));
    result.improved = result.rmsAfter < result.rmsBefore ||
                      (tension() < tensionBefore && result.rmsAfter < kMayRise * result.rmsBefore);
    if (!result.improved) {
      poses_ = start_;
      result.rmsAfter = result.rmsBefore;
      findPairs(views_, poses_, gatesAt(*options_.finalGate), progress.part(0.95, 1.0), fine);
    }
    goBack(fine, progress);
    result.poses = poses_;
    for (const ViewLink& link : fine)
      result.pairs += static_cast<std::size_t>(std::count_if(
          link.pairs.begin(), link.pairs.end(), [](const Pair& p) { return p.state == PairState::Paired; }));
    result.covariance = PoseCovariance(equationsOf(fine, progress).information(radius_), centre_, radius_,
                                       kLoose * *options_.finalGate);
    for (std::size_t i = 0; i < views_.size(); ++i)
      result.poseSigmas.push_back(result.covariance.sigma(i, 0, views_[i].points, poses_[i]));
    return result;
  }

 private:
  [[nodiscard]] PairGates gatesAt(double gate) const { return {gate, *options_.hiddenDepth, options_.maxAngle}; }

  // Centre and size of all views together, centre of each.
  void measureObject() {
    Vec3 sum = Vec3::Zero();
    std::size_t count = 0;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      Vec3 own = Vec3::Zero();
      const auto n = views_[i].points.size();
      for (std::size_t k = 0; k < n; ++k) own += views_[i].points.pointAt(k);
      centres_.push_back(start_[i] * Vec3(own / static_cast<double>(std::max<std::size_t>(n, 1))));
      sum += static_cast<double>(n) * centres_.back();
      count += n;
    }
    centre_ = sum / static_cast<double>(std::max<std::size_t>(count, 1));
    double squares = 0.0;
    for (std::size_t i = 0; i < views_.size(); ++i)
      for (std::size_t k = 0; k < views_[i].points.size(); ++k)
        squares += (start_[i] * views_[i].points.pointAt(k) - centre_).squaredNorm();
    radius_ = std::max(std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count, 1))), 1e-6);
  }

  // How far a pose is from where its tie wants it.
  [[nodiscard]] Vec6 stretch(const PoseTie& tie) const {
    return motionVector(poses_[tie.to] * (poses_[tie.from] * tie.T_from_to).inverse(), tie.prior.centre);
  }

  // Of all ties, as a sum of squares in sigmas.
  [[nodiscard]] double tension() const {
    double sum = 0.0;
    for (const PoseTie& tie : options_.ties) {
      const Vec6 x = stretch(tie);
      sum += x.dot(tie.prior.information * x);
    }
    return sum;
  }

  double errorOf(std::vector<ViewLink>& links, const Progress& progress) const {
    findPairs(views_, poses_, gatesAt(*options_.finalGate), progress, links);
    return robustRms(links, *options_.finalGate);
  }

  void settle(std::vector<ViewLink>& links, double gate, double tolerance, const Progress& progress, int& iterations) {
    const double rounds = options_.maxIterations + 1.0;
    for (int round = 0; round < options_.maxIterations; ++round) {
      const Progress part = progress.part(round / rounds, (round + 1) / rounds);
      findPairs(views_, poses_, gatesAt(gate), part.part(0.0, 0.8), links);
      const double sigma = std::max(kLeastSigma, deviation(links));
      const double moved = step(links, pairNoise(sigma, gate, *options_.finalGate), part.part(0.8, 1.0));
      ++iterations;
      if (gate <= *options_.finalGate && moved < tolerance) break;
      const double wanted = moved < 0.1 * gate ? 0.5 * gate : std::max(0.5 * gate, 4.0 * sigma);
      gate = std::max(*options_.finalGate, std::min(gate, wanted));
    }
    findPairs(views_, poses_, gatesAt(*options_.finalGate), progress.part(1.0 - 1.0 / rounds, 1.0), links);
  }

  [[nodiscard]] std::vector<PairTerm> termsOf(const std::vector<ViewLink>& links, const PairNoise& noise,
                                              const Progress& progress) const {
    std::vector<PairTerm> terms(links.size());
    parallelChunks(links.size(), 1, progress, [&](std::size_t l, std::size_t) {
      terms[l] = pairTerm(links[l].pairs, poses_[links[l].to], centre_, radius_, noise);
    });
    return terms;
  }

  // One Gauss-Newton step of all poses but the first; returns how far the farthest view moves [mm].
  double step(const std::vector<ViewLink>& links, const PairNoise& noise, const Progress& progress) {
    const std::vector<PairTerm> terms = termsOf(links, noise, progress);
    NormalEquations equations(views_.size());
    for (std::size_t l = 0; l < links.size(); ++l) equations.addLink(links[l].from, links[l].to, terms[l]);
    for (std::size_t i = 1; i < views_.size(); ++i) {
      if (tied_[i]) continue;
      const PosePrior prior = isotropicPrior(kPriorAngle, looseShift(scale_), centres_[i]);
      const Mat6 toPrior = changeOfCentre(centre_, prior.centre);
      const Vec6 away = motionVector(poses_[i] * start_[i].inverse(), prior.centre);
      equations.addPrior(i, informationAbout(prior, centre_), -toPrior.transpose() * prior.information * away);
    }
    for (const PoseTie& tie : options_.ties) {
      PairTerm term;
      term.information = informationAbout(tie.prior, centre_);
      term.pull = -changeOfCentre(centre_, tie.prior.centre).transpose() * tie.prior.information * stretch(tie);
      equations.addLink(tie.from, tie.to, term);
    }
    const std::vector<Vec6> motions = equations.solve();
    double farthest = 0.0;
    for (std::size_t i = 1; i < views_.size(); ++i) {
      poses_[i] = motionAbout(centre_, motions[i]) * poses_[i];
      farthest = std::max(farthest, std::hypot(radius_ * motions[i].head<3>().norm(), motions[i].tail<3>().norm()));
    }
    return farthest;
  }

  // Of the pairs alone.
  [[nodiscard]] NormalEquations equationsOf(const std::vector<ViewLink>& links, const Progress& progress) const {
    const double sigma = std::max(kLeastSigma, deviation(links));
    const PairNoise noise = pairNoise(sigma, *options_.finalGate, *options_.finalGate);
    NormalEquations equations(views_.size());
    const std::vector<PairTerm> terms = termsOf(links, noise, progress);
    for (std::size_t l = 0; l < links.size(); ++l) equations.addLink(links[l].from, links[l].to, terms[l]);
    return equations;
  }

  // Along motions that no pairs hold the views go back to where they were said to be, unless surfaces part by that.
  void goBack(std::vector<ViewLink>& links, const Progress& progress) {
    if (options_.given.empty()) return;
    const std::vector<Pose> found = poses_;
    const double before = errorOf(links, progress);
    for (int round = 0; round < kRoundsBack; ++round) {
      move(stepBack(equationsOf(links, progress)));
      findPairs(views_, poses_, gatesAt(*options_.finalGate), progress, links);
    }
    if (errorOf(links, progress) <= kMayRiseBack * before) return;
    poses_ = found;
    findPairs(views_, poses_, gatesAt(*options_.finalGate), progress, links);
  }

  // All the way along what is open, and a Gauss-Newton step along the rest: large turns bend what is open.
  [[nodiscard]] Eigen::VectorXd stepBack(const NormalEquations& equations) const {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(equations.information(radius_));
    const double open = kOpenSigmas * *resolved(IcpOptions(), scale_).limits.maxPoseSigma;
    const Eigen::VectorXd away = awayFromGiven();
    const Eigen::VectorXd pull = equations.pull(radius_);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(away.size());
    for (Eigen::Index k = 0; k < away.size(); ++k) {
      const auto motion = solver.eigenvectors().col(k);
      const double information = solver.eigenvalues()[k];
      step += (information < 1.0 / (open * open) ? motion.dot(away) : motion.dot(pull) / information) * motion;
    }
    return step;
  }

  void move(const Eigen::VectorXd& motions) {
    for (std::size_t i = 1; i < views_.size(); ++i) {
      Vec6 motion = motions.segment<6>(static_cast<Eigen::Index>(6 * (i - 1)));
      motion.head<3>() /= radius_;
      poses_[i] = motionAbout(centre_, motion) * poses_[i];
    }
  }

  // The motions that would bring all views but the first to where they were said to be, as the information has them.
  [[nodiscard]] Eigen::VectorXd awayFromGiven() const {
    const Pose T_here_given = poses_[0] * options_.given[0].inverse();
    Eigen::VectorXd away(static_cast<Eigen::Index>(6 * (views_.size() - 1)));
    for (std::size_t i = 1; i < views_.size(); ++i) {
      Vec6 motion = motionVector(T_here_given * options_.given[i] * poses_[i].inverse(), centre_);
      motion.head<3>() *= radius_;
      away.segment<6>(static_cast<Eigen::Index>(6 * (i - 1))) = motion;
    }
    return away;
  }

  std::span<const PreparedView> views_;
  RegistrationScale scale_;
  MultiViewOptions options_;
  std::vector<Pose> start_;
  std::vector<Pose> poses_;
  std::vector<bool> tied_;  // whether a tie leads to the view
  std::vector<Vec3> centres_;
  Vec3 centre_ = Vec3::Zero();
  double radius_ = 1.0;
};

void checkOptions(std::span<const View> views, const MultiViewOptions& options) {
  if ((options.finalGate && !(*options.finalGate > 0.0)) ||
      (options.finalGate && options.coarseGate && !(*options.coarseGate >= *options.finalGate)))
    throw InvalidInput("multi-view registration needs gates with 0 < final gate <= coarse gate");
  for (const PoseTie& tie : options.ties)
    if (tie.from >= views.size() || tie.to >= views.size() || tie.from == tie.to)
      throw InvalidInput("a tie leads from view " + std::to_string(tie.from) + " to view " + std::to_string(tie.to) +
                         ", expected two of " + std::to_string(views.size()) + " views");
  if (!options.given.empty() && options.given.size() != views.size())
    throw InvalidInput("there are " + std::to_string(options.given.size()) + " given poses for " +
                       std::to_string(views.size()) + " views, expected one for each");
}

// Fewer than two views stay where they are.
MultiViewResult unmoved(std::span<const View> views) {
  MultiViewResult result;
  for (const View& view : views) {
    result.poses.push_back(view.T_object_scanner);
    result.poseSigmas.push_back(0.0);
  }
  return result;
}

}  // namespace

MultiViewResult refinePrepared(std::span<const View> views, std::span<const PreparedView> prepared,
                               const MultiViewOptions& options, const Progress& progress) {
  checkOptions(views, options);
  if (views.size() < 2) return unmoved(views);
  return Refiner(views, prepared, options).run(progress);
}

}  // namespace vantage
