#include "calibration/pinhole_fit.h"

#include <Eigen/Dense>
#include <cmath>

namespace vantage {
namespace {

constexpr std::size_t kFewest = 50;
constexpr int kRounds = 30;
using Vec7 = Eigen::Matrix<double, 7, 1>;  // position, azimuth and elevation of the view, tangents of the half angles

struct Normalised {
  double x, y;  // -1 .. 1, to the right and up
  Vec3 point;
};

// The camera as in ray_patterns.h: pixel centres, row 0 on top.
std::vector<Normalised> normalised(std::span<const GridSample> samples, int rows, int columns) {
  std::vector<Normalised> result;
  for (const GridSample& s : samples)
    result.push_back({2.0 * (s.column + 0.5) / columns - 1.0, 1.0 - 2.0 * (s.row + 0.5) / rows, s.point});
  return result;
}

Vec3 forwardOf(const Vec7& v) {
  return {std::cos(v[4]) * std::cos(v[3]), std::cos(v[4]) * std::sin(v[3]), std::sin(v[4])};
}

Vec3 rayOf(const Vec7& v, double x, double y) {
  const Vec3 forward = forwardOf(v);
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  return (forward + x * v[5] * right + y * v[6] * right.cross(forward)).normalized();
}

Vec3 offRay(const Vec7& v, const Normalised& s) {
  return (s.point - v.head<3>()).cross(rayOf(v, s.x, s.y));
}

// Hartley and Zisserman 2004, 7.1, with points moved and scaled about their middle.
std::optional<Vec7> directLinear(const std::vector<Normalised>& samples) {
  Vec3 middle = Vec3::Zero();
  for (const auto& s : samples) middle += s.point / static_cast<double>(samples.size());
  double size = 0.0;
  for (const auto& s : samples) size += (s.point - middle).squaredNorm() / static_cast<double>(samples.size());
  size = std::sqrt(size);
  if (!(size > 1e-9)) return {};
  Eigen::Matrix<double, 12, 12> products = Eigen::Matrix<double, 12, 12>::Zero();
  for (const auto& s : samples) {
    const Eigen::Vector4d p = ((s.point - middle) / size).homogeneous();
    Eigen::Matrix<double, 12, 1> a;
    a << p, Eigen::Vector4d::Zero(), -s.x * p;
    products += a * a.transpose();
    a << Eigen::Vector4d::Zero(), p, -s.y * p;
    products += a * a.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>> solver(products);
  if (solver.eigenvalues()[1] < 1e-9 * solver.eigenvalues()[11]) return {};  // more than one camera sees that
  const Eigen::Matrix<double, 12, 1> v = solver.eigenvectors().col(0);
  Eigen::Matrix<double, 3, 4> camera;
  camera << v.segment<4>(0).transpose(), v.segment<4>(4).transpose(), v.segment<4>(8).transpose();
  const Eigen::Matrix3d m = camera.leftCols<3>();
  if (std::abs(m.determinant()) < 1e-15) return {};
  const Vec3 centre = -m.inverse() * camera.col(3);
  Vec3 forward = m.row(2).transpose().normalized();
  if ((-centre).dot(forward) < 0.0) forward = -forward;  // the samples are before the camera
  if (std::abs(forward.z()) > 0.999) return {};
  Vec7 result;
  result << middle + size * centre, std::atan2(forward.y(), forward.x()), std::asin(forward.z()), 0.0, 0.0;
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  const Vec3 up = right.cross(forward);
  double xx = 0.0, xt = 0.0, yy = 0.0, yt = 0.0;
  for (const auto& s : samples) {
    const Vec3 d = s.point - result.head<3>();
    xx += s.x * s.x;
    xt += s.x * d.dot(right) / d.dot(forward);
    yy += s.y * s.y;
    yt += s.y * d.dot(up) / d.dot(forward);
  }
  result[5] = xt / xx;
  result[6] = yt / yy;
  return result;
}

Vec7 refined(Vec7 v, const std::vector<Normalised>& samples) {
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix<double, 7, 7> information = Eigen::Matrix<double, 7, 7>::Zero();
    Vec7 pull = Vec7::Zero();
    for (const auto& s : samples) {
      const Vec3 off = offRay(v, s);
      Eigen::Matrix<double, 3, 7> slope;
      for (int k = 0; k < 7; ++k) {
        const double step = k < 3 ? 1e-3 : 1e-6;
        Vec7 moved = v;
        moved[k] += step;
        slope.col(k) = (offRay(moved, s) - off) / step;
      }
      const double w = 1.0 / (1.0 + off.squaredNorm());
      information += w * slope.transpose() * slope;
      pull -= w * slope.transpose() * off;
    }
    information.diagonal() *= 1.0 + 1e-9;
    const Vec7 step = information.ldlt().solve(pull);
    if (!step.allFinite()) return v;
    v += step;
    if (step.head<3>().norm() < 1e-5) break;
  }
  return v;
}

}  // namespace

std::optional<Pinhole> fitPinhole(std::span<const GridSample> samples, int rows, int columns) {
  if (samples.size() < kFewest) return {};
  const auto all = normalised(samples, rows, columns);
  const auto first = directLinear(all);
  if (!first) return {};
  const Vec7 v = refined(*first, all);
  if (!v.allFinite() || v[5] <= 1e-3 || v[6] <= 1e-3 || v[5] > 10.0 || v[6] > 10.0) return {};
  return Pinhole{v.head<3>(),          v.head<3>() + 100.0 * forwardOf(v), rows, columns, 2.0 * std::atan(v[5]),
                 2.0 * std::atan(v[6])};
}

}  // namespace vantage
