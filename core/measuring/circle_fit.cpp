#include "measuring/circle_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/errors.h"
#include "measuring/surface_plane.h"

namespace vantage {
namespace {

constexpr int kIterations = 30;
constexpr double kConverged = 1e-12;
// Normals of a cylinder are across from its axis; those of a plane or a ball tell none.
constexpr double kLeastSpread = 1e-3;
constexpr std::size_t kCylinderPoints = 6;

struct FlatCircle {
  Vec2 centre;
  double radius;
};

// Kasa: |p|^2 = 2 c . p + (r^2 - |c|^2).
FlatCircle algebraicFit(const std::vector<Vec2>& points) {
  Eigen::MatrixX3d a(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd b(a.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const Vec2& p = points[static_cast<std::size_t>(i)];
    a.row(i) << 2.0 * p.x(), 2.0 * p.y(), 1.0;
    b[i] = p.squaredNorm();
  }
  const Vec3 x = a.colPivHouseholderQr().solve(b);
  return {x.head<2>(), std::sqrt(std::max(0.0, x[2] + x.head<2>().squaredNorm()))};
}

FlatCircle refined(FlatCircle circle, const std::vector<Vec2>& points) {
  for (int i = 0; i < kIterations; ++i) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Vec3 right = Vec3::Zero();
    for (const Vec2& p : points) {
      const Vec2 offset = p - circle.centre;
      const double distance = offset.norm();
      if (!(distance > 0.0)) continue;
      const Vec3 row(-offset.x() / distance, -offset.y() / distance, -1.0);
      normal += row * row.transpose();
      right -= (distance - circle.radius) * row;
    }
    const Vec3 step = normal.ldlt().solve(right);
    if (!step.allFinite()) break;
    circle.centre += step.head<2>();
    circle.radius += step[2];
    if (step.norm() < kConverged * circle.radius) break;
  }
  return circle;
}

double rmsOf(const FlatCircle& circle, const std::vector<Vec2>& points) {
  double squares = 0.0;
  for (const Vec2& p : points) {
    const double off = (p - circle.centre).norm() - circle.radius;
    squares += off * off;
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

Vec3 meanOf(std::span<const Vec3> points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p;
  return mean / static_cast<double>(points.size());
}

// Points in a plane through their mean, across from a direction.
struct Flattened {
  Vec3 origin;
  Vec3 x;
  Vec3 y;
  std::vector<Vec2> points;
};

Flattened flattened(std::span<const Vec3> points, const Vec3& normal) {
  const Vec3 x = normal.unitOrthogonal();
  Flattened flat{meanOf(points), x, normal.cross(x), {}};
  for (const Vec3& p : points) flat.points.emplace_back((p - flat.origin).dot(flat.x), (p - flat.origin).dot(flat.y));
  return flat;
}

Circle circleAcross(std::span<const Vec3> points, const Vec3& normal) {
  const Flattened flat = flattened(points, normal);
  const FlatCircle circle = refined(algebraicFit(flat.points), flat.points);
  return {flat.origin + circle.centre.x() * flat.x + circle.centre.y() * flat.y, normal, circle.radius,
          rmsOf(circle, flat.points)};
}

// One step of the axis' direction: the derivative of the distance from a cylinder by a tilt about x and y.
Vec3 tilted(std::span<const Vec3> points, const Circle& circle) {
  const Vec3 x = circle.normal.unitOrthogonal();
  const Vec3 y = circle.normal.cross(x);
  using Row = Eigen::Matrix<double, 5, 1>;
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  Row right = Row::Zero();
  for (const Vec3& p : points) {
    const Vec3 offset = p - circle.centre;
    const double along = offset.dot(circle.normal);
    const Vec3 across = offset - along * circle.normal;
    const double distance = across.norm();
    if (!(distance > 0.0)) continue;
    const double u = across.dot(x) / distance;
    const double v = across.dot(y) / distance;
    Row row;
    row << -u, -v, -1.0, -along * u, -along * v;
    normal += row * row.transpose();
    right -= (distance - circle.radius) * row;
  }
  const Row step = normal.ldlt().solve(right);
  if (!step.allFinite()) return circle.normal;
  return (circle.normal + step[3] * x + step[4] * y).normalized();
}

void checkFinite(std::span<const Vec3> points) {
  if (!std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.allFinite(); }))
    throw InvalidInput("a point to fit is not finite");
}

}  // namespace

Circle circleThrough(const std::array<Vec3, 3>& points) {
  const SurfacePlane plane = planeThrough(points);
  // From the corner at the first point (barycentric coordinates of the circumcentre).
  const Vec3 a = points[1] - points[0];
  const Vec3 b = points[2] - points[0];
  const Vec3 cross = a.cross(b);
  const Vec3 offset =
      (a.squaredNorm() * b.cross(cross) + b.squaredNorm() * cross.cross(a)) / (2.0 * cross.squaredNorm());
  return {points[0] + offset, plane.normal, offset.norm(), 0.0};
}

Circle circleFit(std::span<const Vec3> points) {
  checkFinite(points);
  const SurfacePlane plane = planeFit(points, Vec3::UnitZ());
  return circleAcross(points, plane.normal);
}

Cylinder cylinderFit(std::span<const Vec3> points, std::span<const Vec3> normals) {
  if (points.size() < kCylinderPoints || normals.size() != points.size())
    throw InvalidInput("a cylinder needs six points at least, each with its normal");
  checkFinite(points);
  checkFinite(normals);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& n : normals) spread += n * n.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread / static_cast<double>(normals.size()));
  if (!(solver.eigenvalues()[1] > kLeastSpread + solver.eigenvalues()[0]))
    throw InvalidInput("the normals there are those of a plane, not of a cylinder");
  Circle circle = circleAcross(points, solver.eigenvectors().col(0));
  for (int i = 0; i < kIterations; ++i) {
    const Vec3 axis = tilted(points, circle);
    const double change = (axis - circle.normal).norm();
    circle = circleAcross(points, axis);
    if (change < kConverged) break;
  }
  return {circle.centre, circle.normal, circle.radius, circle.rms};
}

}  // namespace vantage
