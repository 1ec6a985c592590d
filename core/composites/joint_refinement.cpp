#include "composites/joint_refinement.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <span>

#include "registration/oriented_points.h"
#include "registration/prepared_refinement.h"

namespace vantage {
namespace {

// Points of every view that say how it moved.
constexpr std::size_t kProbes = 200;

// Where points of all views were in the composite, and where they are.
struct Displacement {
  std::vector<Vec3> before;
  std::vector<Vec3> after;

  // The rigid motion that explains it best, in the sense of least squares.
  [[nodiscard]] Pose motion() const {
    if (before.empty()) return Pose::Identity();
    const auto n = static_cast<Eigen::Index>(before.size());
    Eigen::Matrix3Xd from(3, n);
    Eigen::Matrix3Xd to(3, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      from.col(k) = before[static_cast<std::size_t>(k)];
      to.col(k) = after[static_cast<std::size_t>(k)];
    }
    return Pose(Eigen::umeyama(from, to, false));
  }

  // What a rigid motion leaves unexplained, RMS [mm].
  [[nodiscard]] double restAfter(const Pose& motion) const {
    double squares = 0.0;
    for (std::size_t k = 0; k < before.size(); ++k) squares += (motion * before[k] - after[k]).squaredNorm();
    return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(before.size(), 1)));
  }
};

Displacement displacementOf(const CompositeModel& composite, std::span<const Pose> poses) {
  Displacement all;
  for (std::size_t v = 0; v < poses.size(); ++v) {
    const OrientedVertices& points = composite.prepared()[v].points;
    for (const std::uint32_t i : thinned(allIndices(points.size()), kProbes)) {
      all.before.push_back(composite.composite().views[v].T_object_scanner * points.pointAt(i));
      all.after.push_back(poses[v] * points.pointAt(i));
    }
  }
  return all;
}

double stretchOf(const PoseTie& tie, std::span<const Pose> poses) {
  const Vec6 x = motionVector(poses[tie.to] * (poses[tie.from] * tie.T_from_to).inverse(), tie.prior.centre);
  return std::sqrt(std::max(0.0, x.dot(tie.prior.information * x)));
}

}  // namespace

PoseTie movedTie(const PoseTie& tie, const Pose& T_target_composite) {
  PoseTie other = tie;
  Mat6 turn = Mat6::Zero();
  turn.topLeftCorner<3, 3>() = T_target_composite.linear();
  turn.bottomRightCorner<3, 3>() = T_target_composite.linear();
  other.prior.information = turn * tie.prior.information * turn.transpose();
  other.prior.centre = T_target_composite * tie.prior.centre;
  return other;
}

JointRefinement refineTogether(const CompositeModel& reference, const CompositeModel& moved,
                               const Pose& T_reference_moved, const MultiViewOptions& options,
                               const Progress& progress) {
  const std::size_t first = reference.composite().views.size();
  std::vector<View> views = reference.composite().views;
  std::vector<PreparedView> prepared = reference.prepared();
  for (View view : moved.composite().views) {
    view.T_object_scanner = T_reference_moved * view.T_object_scanner;
    views.push_back(std::move(view));
  }
  prepared.insert(prepared.end(), moved.prepared().begin(), moved.prepared().end());
  MultiViewOptions all = options;
  all.given.clear();
  all.ties = reference.composite().ties;
  for (const PoseTie& tie : moved.composite().ties) {
    all.ties.push_back(movedTie(tie, T_reference_moved));
    all.ties.back().from += first;
    all.ties.back().to += first;
  }
  const MultiViewResult refined = refinePrepared(views, prepared, all, progress);

  JointRefinement result;
  const auto middle = refined.poses.begin() + static_cast<std::ptrdiff_t>(first);
  result.reference.assign(refined.poses.begin(), middle);
  result.moved.assign(middle, refined.poses.end());
  const Displacement ofReference = displacementOf(reference, result.reference);
  result.referenceBend = ofReference.restAfter(ofReference.motion());
  const Displacement ofMoved = displacementOf(moved, result.moved);
  result.T_reference_moved = ofMoved.motion();
  result.movedBend = ofMoved.restAfter(result.T_reference_moved);
  for (const PoseTie& tie : all.ties) result.tension = std::max(result.tension, stretchOf(tie, refined.poses));
  return result;
}

}  // namespace vantage
