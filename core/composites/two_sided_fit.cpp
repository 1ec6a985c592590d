#include "composites/two_sided_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "registration/pose_prior.h"

namespace vantage {
namespace {

const double kLeastCosine = std::cos(radians(50.0));
// Geman-McClure's scale is so much of the gate.
constexpr double kRobustShare = 0.4;
// So much of the mean information is added in every direction: motions with less are as good as open.
constexpr double kDamping = 1e-5;
constexpr double kSettled = 1e-5;  // [radii]

double evenly(double first, double last, int round, int rounds) {
  return rounds < 2 ? last : first * std::pow(last / first, static_cast<double>(round) / (rounds - 1));
}

}  // namespace

bool isBelowTable(const Composite& composite, const Vec3& p, double depth) {
  return std::any_of(composite.tables.begin(), composite.tables.end(),
                     [&](const TablePlane& table) { return table.normal.dot(p) < table.height - depth; });
}

TwoSidedFit::TwoSidedFit(const CompositeModel& reference, const CompositeModel& moved, PointLevel level, Lookup lookup,
                         double tableDepth)
    : reference_(reference),
      moved_(moved),
      level_(level),
      lookup_(lookup),
      tableDepth_(tableDepth),
      aside_(lookup == Lookup::Exact ? 1.5 * std::max(reference.scale().spacing, moved.scale().spacing) : 0.0) {}

// The partner of p, both in coordinates of the composite that it is looked up on.
Pair TwoSidedFit::pairOf(const CompositeModel& on, const Vec3& p, const Vec3& normal, double gate) const {
  Pair pair;
  auto nearest = on.field().nearest(p);
  if (!nearest) return pair;
  const CompositeSurface& surface = on.surface();
  if (lookup_ == Lookup::Exact) nearest = surface.walkTo(p, *nearest);
  const Vec3 offset = p - surface.point(*nearest);
  const double reach = gate + aside_;
  if (offset.squaredNorm() > reach * reach) return pair;
  if (!surface.isInside(*nearest)) {
    pair.state = PairState::Border;
    return pair;
  }
  const double agreement = normal.dot(surface.normal(*nearest));
  pair.point = surface.point(*nearest);
  pair.normal = agreement > -0.9 ? Vec3((normal + surface.normal(*nearest)).normalized()) : surface.normal(*nearest);
  pair.distance = pair.normal.dot(offset);
  pair.normalSpread = 2.0 - 2.0 * agreement;
  pair.weight = 1.0F;
  if (std::abs(pair.distance) > gate) return pair;
  pair.state = agreement < kLeastCosine ? PairState::Turned : PairState::Paired;
  return pair;
}

std::vector<Pair> TwoSidedFit::pairs(const Pose& T_reference_moved, double gate) const {
  std::vector<Pair> all;
  const Pose T_moved_reference = T_reference_moved.inverse();
  for (const std::uint32_t i : moved_.points(level_)) {
    const Vec3 p = T_reference_moved * moved_.surface().point(i);
    all.push_back(pairOf(reference_, p, T_reference_moved.linear() * moved_.surface().normal(i), gate));
  }
  for (const std::uint32_t i : reference_.points(level_)) {
    const Vec3 p = T_moved_reference * reference_.surface().point(i);
    Pair pair = pairOf(moved_, p, T_moved_reference.linear() * reference_.surface().normal(i), gate);
    pair.point = T_reference_moved * pair.point;
    pair.normal = T_reference_moved.linear() * pair.normal;
    all.push_back(pair);
  }
  return all;
}

Pose TwoSidedFit::run(const Pose& T_reference_moved, const Schedule& schedule) const {
  Pose T = T_reference_moved;
  const std::size_t fromMoved = moved_.points(level_).size();
  const double radius = std::max(reference_.radius(), moved_.radius());
  for (int round = 0; round < schedule.rounds; ++round) {
    const double gate = evenly(schedule.firstGate, schedule.lastGate, round, schedule.rounds);
    const Vec3 centre = T * moved_.centroid();
    Mat6 information = Mat6::Zero();
    Vec6 pull = Vec6::Zero();
    const std::vector<Pair> found = pairs(T, gate);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Pair& pair = found[k];
      if (pair.state != PairState::Paired) continue;
      // Of the moved point against the reference, whichever of the two was looked up.
      const double distance = k < fromMoved ? pair.distance : -pair.distance;
      Vec6 j;
      j << (pair.point - centre).cross(pair.normal) / radius, pair.normal;
      const double w = robustWeight(distance, kRobustShare * gate);
      information.selfadjointView<Eigen::Lower>().rankUpdate(j, w);
      pull -= (w * distance) * j;
    }
    const double mean = information.trace() / 6.0;
    if (!(mean > 0.0)) return T;
    information.diagonal().array() += kDamping * mean;
    Vec6 motion = information.selfadjointView<Eigen::Lower>().ldlt().solve(pull);
    const double moves = motion.norm();
    motion.head<3>() /= radius;
    T = motionAbout(centre, motion) * T;
    if (moves < kSettled * radius && gate <= schedule.lastGate) break;
  }
  // Turns of many rounds add up to a little more than a turn.
  T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  return T;
}

FitQuality TwoSidedFit::quality(const Pose& T_reference_moved, double gate) const {
  FitQuality quality;
  const std::vector<Pair> found = pairs(T_reference_moved, gate);
  const Pose T_moved_reference = T_reference_moved.inverse();
  double squares = 0.0;
  for (const Pair& pair : found) {
    if (pair.state != PairState::Paired) continue;
    quality.overlap += 1.0;
    squares += pair.distance * pair.distance;
  }
  quality.rms = std::sqrt(squares / std::max(quality.overlap, 1.0));
  const auto look = [&](const CompositeModel& from, const CompositeModel& on, const Pose& T_on_from) {
    for (const std::uint32_t i : from.points(level_)) {
      const Vec3 p = T_on_from * from.surface().point(i);
      if (on.field().isFree(p)) quality.conflict += 1.0;
      if (isBelowTable(on.composite(), p, tableDepth_)) quality.table += 1.0;
    }
  };
  look(moved_, reference_, T_reference_moved);
  look(reference_, moved_, T_moved_reference);
  const auto all = static_cast<double>(std::max<std::size_t>(found.size(), 1));
  quality.overlap /= all;
  quality.conflict /= all;
  quality.table /= all;
  return quality;
}

}  // namespace vantage
