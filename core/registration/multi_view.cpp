#include "registration/multi_view.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"
#include "base/parallel.h"
#include "registration/view_network.h"

namespace vantage {
namespace {

constexpr double kLeastSigma = 1e-4;  // [mm]
constexpr double kPriorAngle = radians(3.0);
constexpr double kPriorShift = 3.0;  // [mm]
// See Aligner: a motion counts as measured when its information is this many times what normals' noise pretends.
constexpr double kMeasured = 2.0;
// While few points are looked up the poses need not be better than this [mm].
constexpr double kCoarseTolerance = 0.02;

// What one link says about the motion of one view against the other.
struct LinkTerm {
  Mat6 information = Mat6::Zero();
  Vec6 pull = Vec6::Zero();
};

// Sums of a link in object coordinates about `centre`; directions that only noise seems to hold are left out.
LinkTerm termOf(const ViewLink& link, const Pose& T_object_to, const Vec3& centre, double radius, double sigma) {
  MotionSums sums;
  Vec6 gradient = Vec6::Zero();
  double spread = 0.0;
  for (const Pair& pair : link.pairs) {
    if (pair.state != PairState::Paired) continue;
    const double w = pair.weight * robustWeight(pair.distance, 3.0 * sigma);
    const Vec3 d = T_object_to * pair.point - centre;
    const Vec3 n = T_object_to.linear() * pair.normal;
    sums.add(d, n, w);
    Vec6 j;
    j << d.cross(n), n;
    gradient -= (w * pair.distance) * j;
    spread += w * pair.normalSpread;
  }
  LinkTerm term;
  if (sums.weight <= 0.0) return term;
  Vec6 scale;
  scale << Vec3::Constant(1.0 / radius), Vec3::Ones();
  const Mat6 toMotion = scale.asDiagonal();
  const Mat6 toScaled = scale.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Mat6> solver(Mat6(toMotion * sums.pairs * toMotion));
  const Mat6 pretended = toMotion * sums.pretended(std::sqrt(spread / sums.weight / 8.0)) * toMotion;
  for (int k = 0; k < 6; ++k) {
    const Vec6 v = solver.eigenvectors().col(k);
    if (solver.eigenvalues()[k] <= kMeasured * v.dot(pretended * v)) continue;
    term.information += (solver.eigenvalues()[k] / (sigma * sigma)) * (toScaled * v) * (toScaled * v).transpose();
    term.pull += (v.dot(toMotion * gradient) / (sigma * sigma)) * (toScaled * v);
  }
  return term;
}

class Refiner {
 public:
  Refiner(std::span<const View> views, const MultiViewOptions& options, const Progress& progress)
      : options_(options), views_(prepareViews(views, progress)) {
    for (const View& view : views) start_.push_back(view.T_object_scanner);
    poses_ = start_;
    measureObject();
    priors_ = options.priors;
    for (std::size_t i = priors_.size(); i < views.size(); ++i)
      priors_.push_back(isotropicPrior(kPriorAngle, kPriorShift, centres_[i]));
  }

  MultiViewResult run(const Progress& progress) {
    MultiViewResult result;
    auto rough = findLinks(views_, poses_, gatesAt(options_.coarseGate), options_.minOverlap, options_.coarsePoints,
                           progress.part(0.0, 0.1));
    result.rmsBefore = errorOf(rough, progress.part(0.1, 0.15));
    std::vector<ViewLink> judges = rough;
    settle(rough, options_.coarseGate, kCoarseTolerance, progress.part(0.15, 0.4), result.iterations);
    auto fine = findLinks(views_, poses_, gatesAt(options_.finalGate), options_.minOverlap, options_.finePoints,
                          progress.part(0.4, 0.45));
    settle(fine, options_.finalGate, options_.tolerance, progress.part(0.45, 0.95), result.iterations);
    result.rmsAfter = errorOf(judges, progress.part(0.95, 1.0));
    result.improved = result.rmsAfter < result.rmsBefore;
    if (!result.improved) {
      poses_ = start_;
      result.rmsAfter = result.rmsBefore;
      findPairs(views_, poses_, gatesAt(options_.finalGate), progress.part(0.95, 1.0), fine);
    }
    result.poses = poses_;
    for (const ViewLink& link : fine)
      result.pairs += static_cast<std::size_t>(std::count_if(
          link.pairs.begin(), link.pairs.end(), [](const Pair& p) { return p.state == PairState::Paired; }));
    for (std::size_t i = 0; i < views_.size(); ++i) result.stability.push_back(stabilityOf(i, fine));
    return result;
  }

 private:
  [[nodiscard]] PairGates gatesAt(double gate) const { return {gate, options_.hiddenDepth, options_.maxAngle}; }

  // Centre and size of all views together, centre of each.
  void measureObject() {
    Vec3 sum = Vec3::Zero();
    std::size_t count = 0;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      Vec3 own = Vec3::Zero();
      for (const Vec3& p : views_[i].points.points) own += p;
      const auto n = views_[i].points.size();
      centres_.push_back(start_[i] * Vec3(own / static_cast<double>(std::max<std::size_t>(n, 1))));
      sum += static_cast<double>(n) * centres_.back();
      count += n;
    }
    centre_ = sum / static_cast<double>(std::max<std::size_t>(count, 1));
    double squares = 0.0;
    for (std::size_t i = 0; i < views_.size(); ++i)
      for (const Vec3& p : views_[i].points.points) squares += (start_[i] * p - centre_).squaredNorm();
    radius_ = std::max(std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count, 1))), 1e-6);
  }

  double errorOf(std::vector<ViewLink>& links, const Progress& progress) const {
    findPairs(views_, poses_, gatesAt(options_.finalGate), progress, links);
    return robustRms(links, options_.finalGate);
  }

  void settle(std::vector<ViewLink>& links, double gate, double tolerance, const Progress& progress, int& iterations) {
    for (int round = 0; round < options_.maxIterations; ++round) {
      findPairs(views_, poses_, gatesAt(gate), progress, links);
      const double sigma = std::max(kLeastSigma, deviation(links));
      const double moved = step(links, sigma, progress);
      ++iterations;
      if (gate <= options_.finalGate && moved < tolerance) break;
      const double wanted = moved < 0.1 * gate ? std::min(0.5 * gate, 4.0 * sigma) : 4.0 * sigma;
      gate = std::max(options_.finalGate, std::min(gate, wanted));
    }
    findPairs(views_, poses_, gatesAt(options_.finalGate), progress, links);
  }

  // One Gauss-Newton step of all poses but the first; returns how far the farthest view moves [mm].
  double step(const std::vector<ViewLink>& links, double sigma, const Progress& progress) {
    std::vector<LinkTerm> terms(links.size());
    parallelChunks(links.size(), 1, progress, [&](std::size_t l, std::size_t) {
      terms[l] = termOf(links[l], poses_[links[l].to], centre_, radius_, sigma);
    });
    const auto unknowns = static_cast<Eigen::Index>(6 * (views_.size() - 1));
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(unknowns);
    auto addBlock = [&](std::size_t i, std::size_t j, const Mat6& block) {
      if (i == 0 || j == 0) return;
      for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c)
          entries.emplace_back(static_cast<int>(6 * (i - 1)) + r, static_cast<int>(6 * (j - 1)) + c, block(r, c));
    };
    auto addPull = [&](std::size_t i, const Vec6& v) {
      if (i > 0) pull.segment<6>(static_cast<Eigen::Index>(6 * (i - 1))) += v;
    };
    for (std::size_t l = 0; l < links.size(); ++l) {
      addBlock(links[l].from, links[l].from, terms[l].information);
      addBlock(links[l].to, links[l].to, terms[l].information);
      addBlock(links[l].from, links[l].to, -terms[l].information);
      addBlock(links[l].to, links[l].from, -terms[l].information);
      addPull(links[l].from, terms[l].pull);
      addPull(links[l].to, -terms[l].pull);
    }
    for (std::size_t i = 1; i < views_.size(); ++i) {
      const Mat6 toPrior = changeOfCentre(centre_, priors_[i].centre);
      addBlock(i, i, informationAbout(priors_[i], centre_));
      addPull(i, -toPrior.transpose() * priors_[i].information *
                     motionVector(poses_[i] * start_[i].inverse(), priors_[i].centre));
    }
    Eigen::SparseMatrix<double> system(unknowns, unknowns);
    system.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
    if (solver.info() != Eigen::Success) return 0.0;
    const Eigen::VectorXd x = solver.solve(pull);
    if (!x.allFinite()) return 0.0;

    double farthest = 0.0;
    for (std::size_t i = 1; i < views_.size(); ++i) {
      const Vec6 motion = x.segment<6>(static_cast<Eigen::Index>(6 * (i - 1)));
      poses_[i] = motionAbout(centre_, motion) * poses_[i];
      farthest = std::max(farthest, std::hypot(radius_ * motion.head<3>().norm(), motion.tail<3>().norm()));
    }
    return farthest;
  }

  Stability stabilityOf(std::size_t view, const std::vector<ViewLink>& links) const {
    std::vector<Vec3> points;
    std::vector<Vec3> normals;
    std::vector<double> weights;
    double spread = 0.0;
    StabilityOptions options;
    options.noiseSigma = std::max(kLeastSigma, deviation(links));
    for (const ViewLink& link : links) {
      if (link.from != view && link.to != view) continue;
      for (const Pair& pair : link.pairs) {
        if (pair.state != PairState::Paired) continue;
        points.push_back(poses_[link.to] * pair.point);
        normals.push_back(poses_[link.to].linear() * pair.normal);
        weights.push_back(pair.weight);
        spread += pair.normalSpread;
      }
    }
    if (!points.empty()) options.normalSigma = std::sqrt(spread / static_cast<double>(points.size()) / 8.0);
    return analyseStability(points, normals, weights, options);
  }

  const MultiViewOptions& options_;
  std::vector<PreparedView> views_;
  std::vector<Pose> start_;
  std::vector<Pose> poses_;
  std::vector<PosePrior> priors_;
  std::vector<Vec3> centres_;
  Vec3 centre_ = Vec3::Zero();
  double radius_ = 1.0;
};

}  // namespace

MultiViewResult refineViews(std::span<const View> views, const MultiViewOptions& options, const Progress& progress) {
  if (!(options.finalGate > 0.0) || !(options.coarseGate >= options.finalGate))
    throw InvalidInput("multi-view registration needs gates with 0 < final gate <= coarse gate");
  if (!options.priors.empty() && options.priors.size() != views.size())
    throw InvalidInput(std::to_string(options.priors.size()) + " priors given for " + std::to_string(views.size()) +
                       " views");
  if (views.size() < 2) {
    MultiViewResult result;
    for (const View& view : views) {
      result.poses.push_back(view.T_object_scanner);
      result.stability.push_back(analyseStability({}, {}, {}, {}));
    }
    return result;
  }
  Refiner refiner(views, options, progress.part(0.0, 0.1, "Refining all views"));
  return refiner.run(progress.part(0.1, 1.0));
}

}  // namespace vantage
