#include "composites/picked_pairs.h"

#include <Eigen/Eigenvalues>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

// Points whose spread across their main direction is less than this share of the composite's radius are on a line.
constexpr double kLeastSpread = 0.02;

Vec3 snapped(const CompositeModel& composite, const Vec3& p) {
  const CompositeSurface& surface = composite.surface();
  if (const auto near = composite.field().nearest(p)) return surface.point(surface.walkTo(p, *near));
  return p;
}

void checkSpread(const Eigen::Matrix3Xd& points, double radius, const char* which) {
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  const Eigen::Matrix3d spread = centred * centred.transpose() / static_cast<double>(points.cols());
  const double second = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues()[1];
  if (!(second > kLeastSpread * kLeastSpread * radius * radius))
    throw InvalidInput(std::string("the points picked on the ") + which +
                       " composite lie on a line, which leaves a turn open: pick them farther apart");
}

}  // namespace

Pose poseOfPairs(const CompositeModel& reference, const CompositeModel& moved, std::span<const PickedPair> pairs) {
  if (pairs.size() < 3)
    throw InvalidInput("three pairs of points are needed to bring two composites together, there are " +
                       std::to_string(pairs.size()));
  const auto n = static_cast<Eigen::Index>(pairs.size());
  Eigen::Matrix3Xd from(3, n);
  Eigen::Matrix3Xd to(3, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const PickedPair& pair = pairs[static_cast<std::size_t>(k)];
    if (!pair.reference.allFinite() || !pair.moved.allFinite())
      throw InvalidInput("picked point " + std::to_string(k + 1) + " is not finite");
    to.col(k) = snapped(reference, pair.reference);
    from.col(k) = snapped(moved, pair.moved);
  }
  checkSpread(to, reference.radius(), "first");
  checkSpread(from, moved.radius(), "second");
  return Pose(Eigen::umeyama(from, to, false));
}

}  // namespace vantage
