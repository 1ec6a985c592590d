#include "registration/position_search.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "registration/pair_finding.h"
#include "registration/registration_scale.h"

namespace vantage {
namespace {

constexpr std::size_t kAsked = 3000;
// Where fewer of them should be seen nothing is known.
constexpr double kLeastExpected = 0.04 * static_cast<double>(kAsked);
// What the prior holds is known to so many times what makes a pose sure.
constexpr double kHeld = 4.0;
// Candidates turned by less from where a view was found would find the same again [rad].
constexpr double kSamePlace = radians(4.5);

// What share of the model's points that the view should see it saw, less those that it did not; where much of the model
// is in sight of a wrong pose more points meet than at the right one.
double scoreAt(const ViewSurface& surface, const Pose& T_object_scanner, const RegistrationTarget& model,
               const std::vector<std::uint32_t>& ids, const PairGates& gates) {
  std::vector<std::optional<GridPosition>> positions(ids.size());
  std::vector<Pair> pairs(ids.size());
  findPairs(model.surface(), ids, T_object_scanner.inverse(), surface, gates, positions, Progress(), pairs);
  double met = 0.0;
  double missed = 0.0;
  for (const Pair& pair : pairs) {
    if (pair.state == PairState::Paired) met += 1.0;
    if (pair.state == PairState::InFront || pair.state == PairState::Turned) missed += 1.0;
  }
  return met + missed < kLeastExpected ? -1.0 : (met - missed) / (met + missed);
}

Vec3 centreOf(const ViewSurface& surface) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : surface.view().mesh.vertices) sum += p;
  return sum / static_cast<double>(std::max<std::size_t>(surface.view().mesh.vertices.size(), 1));
}

// How far apart two poses put a view: its centre, and what a turn moves at that distance [mm].
double distanceBetween(const Pose& a, const Pose& b, const Vec3& centre) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(a.linear().transpose() * b.linear()));
  return (a * centre - b * centre).norm() + centre.norm() * turn.angle();
}

// Whether a view is where it was registered: that is good, or would be with more overlap, or the prior holds what the
// surface lets go of.
bool isPlace(const RegistrationResult& result, const IcpOptions& options) {
  if (result.verdict != Verdict::Doubtful) return result.verdict == Verdict::Good;
  if (result.finding.reason == VerdictReason::HeldByMechanics)
    return result.poseSigma <= kHeld * *options.limits.maxPoseSigma;
  return result.finding.reason == VerdictReason::FewPairs;
}

// A registration reaches farther than from one position to the next.
std::size_t nearest(std::span<const Pose> candidates, const Pose& found, const Vec3& centre) {
  const auto least = std::min_element(candidates.begin(), candidates.end(), [&](const Pose& a, const Pose& b) {
    return distanceBetween(a, found, centre) < distanceBetween(b, found, centre);
  });
  return static_cast<std::size_t>(least - candidates.begin());
}

}  // namespace

std::optional<FittingPose> poseThatFits(const ViewSurface& surface, std::span<const Pose> candidates,
                                        const RegistrationTarget& model, const IcpOptions& options,
                                        const Progress& progress, std::size_t tried) {
  const RegistrationScale scale = scaleOf(surface);
  const IcpOptions icp = resolved(options, scale);
  const PairGates gates{std::max(looseShift(scale), fineGate(scale)), *icp.hiddenDepth, icp.coarseAngle};
  const auto ids = thinned(allIndices(model.size()), kAsked);
  std::vector<double> scores(candidates.size());
  parallelChunks(candidates.size(), 1, progress.part(0.0, 0.5),
                 [&](std::size_t i, std::size_t) { scores[i] = scoreAt(surface, candidates[i], model, ids, gates); });
  std::vector<std::size_t> best(candidates.size());
  std::iota(best.begin(), best.end(), std::size_t{0});
  std::stable_sort(best.begin(), best.end(), [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
  const Vec3 centre = centreOf(surface);
  const double near = kSamePlace * centre.norm() + looseShift(scale);
  std::optional<FittingPose> fits;
  std::size_t registered = 0;
  for (const std::size_t i : best) {
    if (registered == tried) break;
    // Those around it found it already: the rivals are elsewhere.
    if (fits && distanceBetween(candidates[i], fits->registration.T_object_scanner, centre) < near) continue;
    ++registered;
    const RegistrationResult result = registerView(surface, candidates[i], model, options, progress.part(0.5, 1.0));
    if (!isPlace(result, icp)) continue;
    if (!fits) {
      fits = {nearest(candidates, result.T_object_scanner, centre), result, 0.0, {}};
      continue;
    }
    // A good place fears good ones only.
    if (fits->registration.verdict == Verdict::Good && result.verdict != Verdict::Good) continue;
    const double distance = distanceBetween(fits->registration.T_object_scanner, result.T_object_scanner, centre);
    if (distance <= gates.distance) continue;
    fits->rivalDistance = std::max(fits->rivalDistance, distance);
    fits->rivals.push_back(result.T_object_scanner);
  }
  return fits;
}

}  // namespace vantage
