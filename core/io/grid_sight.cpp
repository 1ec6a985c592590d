#include "io/grid_sight.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/mesh.h"

namespace vantage {
namespace {

using Vec4 = Eigen::Vector4d;
using Vec8 = Eigen::Matrix<double, 8, 1>;
using Mat8 = Eigen::Matrix<double, 8, 8>;

constexpr std::size_t kMostSamples = 20'000;
constexpr std::size_t kLeastSamples = 60;
constexpr int kReweightings = 12;
constexpr double kFloor = 0.02;       // [cells] smaller errors count alike
constexpr double kFits = 0.3;         // [cells] a grid that lies so well is one
constexpr double kSpreadGain = 0.25;  // planes that meet must lie so much better than parallel ones
constexpr double kSpreadSeen = 0.05;  // [cells] and parallel ones at least so badly
constexpr double kLeastRelief = 3.0;  // [pitches] a flatter surface does not tell lines of sight
constexpr double kOneSide = 0.999;

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Sample {
  Vec4 p;    // about the middle, in units of the spread
  double c;  // column or row, about the middle
};

// One coordinate of the grid as a function of the point.
struct PlaneFit {
  Vec4 a = Vec4::Zero();
  Vec4 g = Vec4::UnitW();
  double error = 0.0;

  [[nodiscard]] double at(const Vec4& p) const { return a.dot(p) / g.dot(p); }
  // Gradient of the coordinate, but for its length.
  [[nodiscard]] Vec3 normalAt(const Vec4& p) const { return (a - at(p) * g).head<3>().normalized(); }
};

double errorOf(const PlaneFit& fit, const std::vector<Sample>& samples) {
  std::vector<double> errors;
  errors.reserve(samples.size());
  for (const Sample& s : samples) errors.push_back(std::abs(fit.at(s.p) - s.c));
  return median(std::move(errors));
}

double weightOf(const PlaneFit& fit, const Sample& s) {
  return 1.0 / (kFloor + std::abs(fit.at(s.p) - s.c));
}

// Least absolute deviations by reweighting.
PlaneFit fitParallel(const std::vector<Sample>& samples) {
  PlaneFit fit;
  for (int i = 0; i < kReweightings; ++i) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    Vec4 b = Vec4::Zero();
    for (const Sample& s : samples) {
      const double weight = i == 0 ? 1.0 : weightOf(fit, s);
      m += weight * s.p * s.p.transpose();
      b += weight * s.c * s.p;
    }
    m.diagonal().array() += 1e-12 * m.trace();
    fit.a = m.ldlt().solve(b);
  }
  fit.error = errorOf(fit, samples);
  return fit;
}

PlaneFit fitMeeting(const std::vector<Sample>& samples, const PlaneFit& parallel) {
  PlaneFit fit = parallel;
  for (int i = 0; i < kReweightings; ++i) {
    Mat8 m = Mat8::Zero();
    for (const Sample& s : samples) {
      const double below = fit.g.dot(s.p);
      Vec8 row;
      row << s.p, -s.c * s.p;
      m += weightOf(fit, s) / std::max(below * below, 1e-9) * row * row.transpose();
    }
    const Vec8 least = Eigen::SelfAdjointEigenSolver<Mat8>(m).eigenvectors().col(0);
    if (std::abs(least[7]) < 1e-12) return parallel;
    fit.a = least.head<4>() / least[7];
    fit.g = least.tail<4>() / least[7];
  }
  fit.error = errorOf(fit, samples);
  const auto ahead =
      std::count_if(samples.begin(), samples.end(), [&](const Sample& s) { return fit.g.dot(s.p) > 0.0; });
  if (static_cast<double>(ahead) < kOneSide * static_cast<double>(samples.size())) return parallel;
  return fit;
}

template <typename Visit>
void forCells(const SampleGrid& grid, const Visit& visit) {
  std::size_t i = 0;
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c, ++i)
      if (grid.cell[i] != kNoIndex) visit(r, c, grid.points[grid.cell[i]]);
}

double spreadOf(const SampleGrid& grid, const Vec3& middle) {
  double sum = 0.0;
  for (const Vec3& p : grid.points) sum += (p - middle).squaredNorm();
  return std::sqrt(sum / static_cast<double>(grid.points.size()));
}

// How far the samples lie from a plane through them, root mean square.
double reliefOf(const SampleGrid& grid, const Vec3& middle) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (const Vec3& p : grid.points) m += (p - middle) * (p - middle).transpose();
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvalues()[0];
  return std::sqrt(std::max(0.0, least) / static_cast<double>(grid.points.size()));
}

struct CoordinateFit {
  PlaneFit parallel;
  PlaneFit best;
  bool meets = false;
};

CoordinateFit fitCoordinate(const std::vector<Sample>& samples) {
  CoordinateFit fit;
  fit.parallel = fitParallel(samples);
  const PlaneFit meeting = fitMeeting(samples, fit.parallel);
  fit.meets = fit.parallel.error > kSpreadSeen && meeting.error < kSpreadGain * fit.parallel.error;
  fit.best = fit.meets ? meeting : fit.parallel;
  return fit;
}

class SightFinder {
 public:
  explicit SightFinder(const SampleGrid& grid)
      : grid_(grid), middle_(middleOf(grid)), spread_(std::max(spreadOf(grid, middle_), 1e-300)) {
    const std::size_t stride = grid.points.size() / kMostSamples + 1;
    std::size_t i = 0;
    forCells(grid, [&](int r, int c, const Vec3& p) {
      if (i++ % stride != 0) return;
      Vec4 h;
      h << (p - middle_) / spread_, 1.0;
      columns_.push_back({h, c - 0.5 * grid.columns});
      rows_.push_back({h, r - 0.5 * grid.rows});
    });
  }

  GridSight find() const {
    const CoordinateFit column = fitCoordinate(columns_);
    const CoordinateFit row = fitCoordinate(rows_);
    GridSight sight;
    sight.error = std::hypot(column.best.error, row.best.error);
    const Vec3 along = column.best.normalAt(Vec4::UnitW()).cross(row.best.normalAt(Vec4::UnitW()));
    if (!(along.norm() > 0.1) || !(sight.error < kFits)) return sight;
    sight.fits = true;
    sight.direction = along.normalized();
    addSide(column, row, sight);
    return sight;
  }

 private:
  // How fast the planes spread along the direction, relative to their distance from each other [1 / unit].
  [[nodiscard]] double spreading(const CoordinateFit& fit, const Vec3& direction) const {
    return fit.meets ? fit.best.g.head<3>().dot(direction) / spread_ : 0.0;
  }

  void addSide(const CoordinateFit& column, const CoordinateFit& row, GridSight& sight) const {
    const double c = spreading(column, sight.direction);
    const double r = spreading(row, sight.direction);
    if (c * r < 0.0 || (c == 0.0 && r == 0.0)) return;
    if (c + r < 0.0) sight.direction = -sight.direction;
    sight.spreads = true;
    sight.distance = 1.0 / std::max(std::abs(c), std::abs(r));
  }

  const SampleGrid& grid_;
  Vec3 middle_;
  double spread_;
  std::vector<Sample> columns_;
  std::vector<Sample> rows_;
};

std::vector<double> neighbourDistances(const SampleGrid& grid, std::size_t stride) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i + stride < grid.cell.size(); ++i)
    if (grid.cell[i] != kNoIndex && grid.cell[i + stride] != kNoIndex)
      lengths.push_back((grid.points[grid.cell[i + stride]] - grid.points[grid.cell[i]]).norm());
  return lengths;
}

}  // namespace

Vec3 middleOf(const SampleGrid& grid) {
  // About the first point, so that nothing is lost far from the origin.
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : grid.points) sum += p - grid.points.front();
  return grid.points.front() + sum / static_cast<double>(grid.points.size());
}

double medianPitch(const SampleGrid& grid) {
  return median(neighbourDistances(grid, 1));
}

GridSight findGridSight(const SampleGrid& grid) {
  if (grid.points.size() < kLeastSamples) return {};
  if (reliefOf(grid, middleOf(grid)) < kLeastRelief * medianPitch(grid)) return {};
  return SightFinder(grid).find();
}

bool isExchanged(const SampleGrid& grid) {
  constexpr double kClearly = 0.5;
  if (grid.rows == grid.columns) return false;
  const auto below = neighbourDistances(grid, static_cast<std::size_t>(grid.columns));
  const auto exchanged = neighbourDistances(grid, static_cast<std::size_t>(grid.rows));
  if (exchanged.size() < kLeastSamples || below.size() < kLeastSamples) return false;
  return median(exchanged) < kClearly * median(below);
}

}  // namespace vantage
