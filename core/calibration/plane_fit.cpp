#include "calibration/plane_fit.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "base/random.h"

namespace vantage {
namespace {

constexpr int kTries = 500;
constexpr std::size_t kTried = 3000;  // points
constexpr int kRounds = 10;

PlaneFit through(std::span<const Vec3> points, const PlaneFit& plane, double tolerance) {
  PlaneFit result = plane;
  result.count = 0;
  result.centre.setZero();
  for (const Vec3& p : points) {
    if (std::abs(plane.distance(p)) > tolerance) continue;
    result.centre += p;
    ++result.count;
  }
  if (result.count < 3) return result;
  result.centre /= static_cast<double>(result.count);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points)
    if (std::abs(plane.distance(p)) <= tolerance) moments += (p - result.centre) * (p - result.centre).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments / static_cast<double>(result.count));
  result.normal = solver.eigenvectors().col(0);
  if (result.normal.dot(plane.normal) < 0.0) result.normal = -result.normal;
  result.offset = -result.normal.dot(result.centre);
  result.rms = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  result.extent = std::sqrt(std::max(0.0, solver.eigenvalues()[1]));
  return result;
}

}  // namespace

std::optional<PlaneFit> fitPlane(std::span<const Vec3> points, const Vec3& normal, double mostLean, double tolerance) {
  if (points.size() < 3) return {};
  std::vector<Vec3> some;
  const std::size_t step = points.size() / kTried + 1;
  for (std::size_t k = 0; k < points.size(); k += step) some.push_back(points[k]);
  Random random(1);
  PlaneFit best;
  auto pick = [&] { return some[random.below(some.size())]; };
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const Vec3 a = pick();
    const Vec3 across = (pick() - a).cross(pick() - a);
    if (across.norm() < 1e-6) continue;
    PlaneFit plane;
    plane.normal = across.dot(normal) < 0.0 ? -across.normalized() : across.normalized();
    if (plane.normal.dot(normal) < std::cos(mostLean)) continue;
    plane.offset = -plane.normal.dot(a);
    for (const Vec3& p : some) plane.count += std::abs(plane.distance(p)) <= tolerance ? 1 : 0;
    if (plane.count > best.count) best = plane;
  }
  if (best.count < 3) return {};
  for (int round = 0; round < kRounds; ++round) best = through(points, best, tolerance);
  if (best.count < 3 || best.normal.dot(normal) < std::cos(mostLean)) return {};
  return best;
}

}  // namespace vantage
