#include "calibration/ray_field_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "base/errors.h"
#include "calibration/screw_motion.h"

namespace vantage {
namespace {

constexpr Eigen::Index kTerms = 10;
constexpr std::size_t kFewest = 100;
// Holds what samples do not tell, as the spread of rays of one flat scan.
constexpr double kRidge = 1e-7;

// u^i v^j with i + j <= 3 of the place in the grid, each in -1 .. 1.
Eigen::Matrix<double, kTerms, 1> termsAt(double row, double column, int rows, int columns) {
  const double u = 2.0 * column / (columns - 1) - 1.0;
  const double v = 2.0 * row / (rows - 1) - 1.0;
  Eigen::Matrix<double, kTerms, 1> terms;
  terms << 1.0, u, v, u * u, u * v, v * v, u * u * u, u * u * v, u * v * v, v * v * v;
  return terms;
}

}  // namespace

RayGrid fitRayField(std::span<const GridSample> samples, int rows, int columns, const Vec3& sight, double standoff) {
  if (samples.size() < kFewest)
    throw InvalidInput("the scans have " + std::to_string(samples.size()) +
                       " samples, expected 100 or more to tell the rays of their scanner");
  const AcrossAxis across(sight);
  double middle = 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const GridSample& s : samples) {
    middle += s.point.dot(sight) / static_cast<double>(samples.size());
    nearest = std::min(nearest, s.point.dot(sight));
  }
  constexpr double kUnit = 100.0;  // of depth, so that both halves of the unknowns weigh alike [mm]
  using Terms = Eigen::Matrix<double, 2 * kTerms, 1>;
  Eigen::Matrix<double, 2 * kTerms, 2 * kTerms> products = decltype(products)::Zero();
  Eigen::Matrix<double, 2 * kTerms, 2> values = decltype(values)::Zero();
  for (const GridSample& s : samples) {
    const auto at = termsAt(s.row, s.column, rows, columns);
    Terms terms;
    terms << at, (s.point.dot(sight) - middle) / kUnit * at;
    products += terms * terms.transpose();
    values += terms * Eigen::RowVector2d(s.point.dot(across.first), s.point.dot(across.second));
  }
  products.diagonal().array() += kRidge * products.diagonal().maxCoeff();
  const Eigen::Matrix<double, 2 * kTerms, 2> solution = products.ldlt().solve(values);

  std::vector<RangingRay> rays;
  const double begin = nearest - standoff;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto at = termsAt(row, column, rows, columns);
      const Eigen::RowVector2d place = at.transpose() * solution.topRows<kTerms>();
      const Eigen::RowVector2d slope = at.transpose() * solution.bottomRows<kTerms>() / kUnit;
      const Eigen::RowVector2d there = place + (begin - middle) * slope;
      rays.push_back({begin * sight + there[0] * across.first + there[1] * across.second,
                      (sight + slope[0] * across.first + slope[1] * across.second).normalized()});
    }
  }
  return {rows, columns, std::move(rays), {}, 0};
}

}  // namespace vantage
