#include "registration/rivals.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace vantage {
namespace {

constexpr std::size_t kPoints = 800;
constexpr int kDirections = 3;
constexpr int kMaxIterations = 20;
constexpr double kFirstGates = 3.0;  // [final gates]
constexpr double kTolerance = 0.06;  // [final gates]
// Starts at this many sigmas of the prior to either side.
constexpr double kFarthest = 3.0;
constexpr int kStartsPerSide = 3;
// Poses nearer than this many final gates are the same pose.
constexpr double kSameGates = 1.5;
// A rival has nearly the share of pairs of the pose found, not many fewer, and nearly its residual.
constexpr double kShareOfBest = 0.97;
constexpr double kPairsOfBest = 0.7;
constexpr double kSigmaOfBest = 1.2;

std::vector<Vec6> startMotions(const Stability& stability, const PosePrior& prior, double least) {
  Vec6 scale;
  scale << Vec3::Constant(1.0 / std::max(stability.radius, 1e-6)), Vec3::Ones();
  const Mat6 toMotion = scale.asDiagonal();
  const Mat6 known = toMotion * informationAbout(prior, stability.centre) * toMotion;
  const Eigen::SelfAdjointEigenSolver<Mat6> solver(Mat6(toMotion * stability.information * toMotion));
  std::vector<Vec6> motions;
  for (int k = 0; k < kDirections; ++k) {
    const Vec6 v = solver.eigenvectors().col(k);
    const double reach = kFarthest / std::sqrt(std::max(v.dot(known * v), 1e-12));
    if (reach < least) continue;
    for (int i = 1; i <= kStartsPerSide; ++i)
      for (const double side : {-1.0, 1.0}) motions.push_back(toMotion * v * (side * reach * i / kStartsPerSide));
  }
  return motions;
}

struct Score {
  double paired = 0.0;
  double expected = 0.0;

  [[nodiscard]] double share() const { return expected > 0.0 ? paired / expected : 0.0; }
};

Score scoreOf(std::span<const Pair> pairs) {
  Score score;
  for (const Pair& pair : pairs) {
    if (pair.state == PairState::Unseen || pair.state == PairState::Border) continue;
    score.expected += 1.0;
    if (pair.state == PairState::Paired) score.paired += 1.0;
  }
  return score;
}

double distanceBetween(const Pose& a, const Pose& b, const Stability& s) {
  const Vec6 motion = motionVector(a * b.inverse(), s.centre);
  return std::hypot(s.radius * motion.head<3>().norm(), motion.tail<3>().norm());
}

}  // namespace

Rival findRival(const Aligner& aligner, const Fit& found, const std::vector<std::uint32_t>& points,
                const Stability& stability, const PosePrior& prior, const IcpOptions& options,
                const Progress& progress) {
  const double same = kSameGates * *options.finalGate;
  const std::vector<Vec6> motions = startMotions(stability, prior, same);
  if (motions.empty()) return {};
  const auto ids = aligner.visible(found.T_object_scanner, points, kPoints, progress.part(0.0, 0.1));
  const Aligner::Schedule inPlace{*options.finalGate, *options.finalGate, 0.0, 0};
  const Fit best = aligner.run(found.T_object_scanner, ids, inPlace, progress.part(0.1, 0.2));
  const Score bestScore = scoreOf(best.pairs);

  std::vector<double> distances(motions.size(), 0.0);
  parallelChunks(motions.size(), 1, progress.part(0.2, 1.0), [&](std::size_t begin, std::size_t) {
    const Pose start = motionAbout(stability.centre, motions[begin]) * found.T_object_scanner;
    const Aligner::Schedule schedule{kFirstGates * *options.finalGate, *options.finalGate,
                                     kTolerance * *options.finalGate, kMaxIterations};
    const Fit other = aligner.run(start, ids, schedule, Progress());
    const double distance = distanceBetween(other.T_object_scanner, found.T_object_scanner, stability);
    const Score score = scoreOf(other.pairs);
    const bool asGood = score.share() >= kShareOfBest * bestScore.share() &&
                        score.paired >= kPairsOfBest * bestScore.paired && other.sigma <= kSigmaOfBest * best.sigma;
    const bool allowed = aligner.motionInSigmas(other.T_object_scanner) <= options.limits.maxMotion;
    if (distance >= same && asGood && allowed && other.settled && other.heldByPrior == 0) distances[begin] = distance;
  });
  Rival rival;
  for (const double distance : distances)
    if (distance > 0.0 && (rival.distance == 0.0 || distance < rival.distance)) rival.distance = distance;
  return rival;
}

}  // namespace vantage
