#include "measuring/surface_plane.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "base/errors.h"

namespace vantage {
namespace {

// A triangle so much flatter than long tells no plane.
constexpr double kThinnest = 1e-9;

}  // namespace

SurfacePlane planeThrough(const std::array<Vec3, 3>& points) {
  const Vec3 a = points[1] - points[0];
  const Vec3 b = points[2] - points[0];
  const Vec3 normal = a.cross(b);
  const double size = std::max(a.squaredNorm(), b.squaredNorm());
  if (!(normal.norm() > kThinnest * size) || !normal.allFinite())
    throw InvalidInput("the three points are on one line, they do not tell a plane");
  const Vec3 unit = normal.normalized();
  return {unit, unit.dot((points[0] + points[1] + points[2]) / 3.0)};
}

SurfacePlane planeFit(std::span<const Vec3> points, const Vec3& front) {
  if (points.size() < 3) throw InvalidInput("a plane needs three points at least");
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) spread += (p - mean) * (p - mean).transpose();
  if (!spread.allFinite()) throw InvalidInput("a point of the plane is not finite");
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  if (!(solver.eigenvalues()[1] > kThinnest * kThinnest * solver.eigenvalues()[2]))
    throw InvalidInput("the points are on one line, they do not tell a plane");
  Vec3 normal = solver.eigenvectors().col(0);
  if (normal.dot(front) < 0.0) normal = -normal;
  return {normal, normal.dot(mean)};
}

}  // namespace vantage
