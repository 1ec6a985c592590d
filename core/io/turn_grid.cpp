#include "io/turn_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "geometry/mesh.h"

namespace vantage {
namespace {

constexpr std::size_t kLeastSteps = 60;
constexpr double kConcentration = 0.995;        // of the angles about their columns
constexpr double kLeastTurn = 4.0 * kPi / 3.0;  // [rad] so much of a circle at least
constexpr double kLevel = 0.05;                 // [steps] rows lie so level along the axis

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * kPi);
}

int index(Axis axis, int further) {
  return (static_cast<int>(axis) + further) % 3;
}

Vec3 radial(Axis axis, double angle) {
  Vec3 direction = Vec3::Zero();
  direction[index(axis, 1)] = std::cos(angle);
  direction[index(axis, 2)] = std::sin(angle);
  return direction;
}

double radiusAbout(Axis axis, const Vec3& p) {
  return std::hypot(p[index(axis, 1)], p[index(axis, 2)]);
}

std::size_t cellAt(const SampleGrid& grid, int r, int c) {
  return static_cast<std::size_t>(r) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(c);
}

template <typename Visit>
void forCells(const SampleGrid& grid, const Visit& visit) {
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c)
      if (grid.cell[cellAt(grid, r, c)] != kNoIndex) visit(r, c, grid.points[grid.cell[cellAt(grid, r, c)]]);
}

// `value(a, b)` of all samples with a neighbour `rows` and `columns` on.
template <typename Value>
std::vector<double> overNeighbours(const SampleGrid& grid, int rows, int columns, const Value& value) {
  std::vector<double> values;
  forCells(grid, [&](int r, int c, const Vec3& p) {
    if (r + rows >= grid.rows || c + columns >= grid.columns) return;
    const std::uint32_t other = grid.cell[cellAt(grid, r + rows, c + columns)];
    if (other != kNoIndex) values.push_back(value(p, grid.points[other]));
  });
  return values;
}

// Mean of exp(i (angle - step c - lean r)).
std::complex<double> meanAbout(const SampleGrid& grid, const TurnSight& turn) {
  std::complex<double> sum = 0.0;
  forCells(grid, [&](int r, int c, const Vec3& p) {
    sum += std::polar(1.0, angleAbout(turn.axis, p) - turn.step * c - turn.lean * r);
  });
  return sum / static_cast<double>(grid.points.size());
}

// The step that fits best: as found, or that of a whole turn in all columns or in one less.
void settleStep(const SampleGrid& grid, TurnSight& turn) {
  const double whole = std::copysign(2.0 * kPi, turn.step);
  TurnSight best = turn;
  for (const double step : {whole / grid.columns, whole / (grid.columns - 1)}) {
    TurnSight other = turn;
    other.step = step;
    if (std::abs(meanAbout(grid, other)) > std::abs(meanAbout(grid, best))) best = other;
  }
  turn = best;
  turn.start = std::arg(meanAbout(grid, turn));
}

// Whether the rows lie at equal heights along the axis.
bool isLevel(const SampleGrid& grid, Axis axis) {
  const auto height = [&](const Vec3& a, const Vec3& b) { return b[index(axis, 0)] - a[index(axis, 0)]; };
  auto down = overNeighbours(grid, 1, 0, height);
  auto along = overNeighbours(grid, 0, 1, [&](const Vec3& a, const Vec3& b) { return std::abs(height(a, b)); });
  if (down.size() < kLeastSteps || along.size() < kLeastSteps) return false;
  const double step = median(down);
  std::vector<double> off;
  off.reserve(down.size());
  for (const double d : down) off.push_back(std::abs(d - step));
  return std::abs(step) > 0.0 && median(along) < kLevel * std::abs(step) && median(off) < kLevel * std::abs(step);
}

// Angle about the turn's axis, unwrapped, and a second coordinate; empty cells filled in.
template <typename Second>
std::vector<Vec2> filledPositions(const SampleGrid& grid, const TurnSight& turn, const Second& second) {
  std::vector<Vec2> positions(grid.cell.size(), Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
  forCells(grid, [&](int r, int c, const Vec3& p) {
    const double expected = turn.at(r, c);
    positions[cellAt(grid, r, c)] = {expected + wrapped(angleAbout(turn.axis, p) - expected), second(p)};
  });
  fillGridPositions(grid.rows, grid.columns, positions);
  return positions;
}

}  // namespace

SampleGrid transposed(const SampleGrid& grid) {
  SampleGrid turned{grid.columns, grid.rows, grid.points, grid.cell, grid.colours};
  for (int r = 0; r < turned.rows; ++r)
    for (int c = 0; c < turned.columns; ++c) turned.cell[cellAt(turned, r, c)] = grid.cell[cellAt(grid, c, r)];
  return turned;
}

double angleAbout(Axis axis, const Vec3& p) {
  return std::atan2(p[index(axis, 2)], p[index(axis, 1)]);
}

std::optional<TurnSight> fitTurn(const SampleGrid& grid, Axis axis) {
  const auto turned = [&](const Vec3& a, const Vec3& b) { return wrapped(angleAbout(axis, b) - angleAbout(axis, a)); };
  auto along = overNeighbours(grid, 0, 1, turned);
  auto down = overNeighbours(grid, 1, 0, turned);
  if (along.size() < kLeastSteps || down.size() < kLeastSteps) return std::nullopt;
  TurnSight turn{axis, 0.0, median(along), median(down)};
  turn.start = std::arg(meanAbout(grid, turn));
  return turn;
}

std::optional<TurnSight> findTurn(const SampleGrid& grid) {
  for (const Axis axis : {Axis::Z, Axis::Y, Axis::X}) {
    auto turn = fitTurn(grid, axis);
    if (!turn || std::abs(turn->step) * grid.columns < kLeastTurn) continue;
    turn->lean = 0.0;
    settleStep(grid, *turn);
    if (std::abs(meanAbout(grid, *turn)) > kConcentration && isLevel(grid, axis)) return turn;
  }
  return std::nullopt;
}

std::vector<RangingRay> turntableRays(const SampleGrid& grid, const TurnSight& turn, double radius) {
  const int up = index(turn.axis, 0);
  const auto positions = filledPositions(grid, turn, [up](const Vec3& p) { return p[up]; });
  std::vector<RangingRay> rays(positions.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Vec3 out = radial(turn.axis, positions[i].x());
    Vec3 origin = radius * out;
    origin[up] = positions[i].y();
    rays[i] = {origin, -out};
  }
  return rays;
}

std::vector<RangingRay> pointRays(const SampleGrid& grid, const TurnSight& turn) {
  const int up = index(turn.axis, 0);
  const auto positions =
      filledPositions(grid, turn, [&](const Vec3& p) { return std::atan2(p[up], radiusAbout(turn.axis, p)); });
  std::vector<RangingRay> rays(positions.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Vec3 direction = std::cos(positions[i].y()) * radial(turn.axis, positions[i].x());
    direction[up] = std::sin(positions[i].y());
    rays[i] = {Vec3::Zero(), direction.normalized()};
  }
  return rays;
}

}  // namespace vantage
