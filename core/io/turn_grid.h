#pragma once

#include <optional>

#include "io/range_grid_rays.h"
#include "scanner/scan_reading.h"

namespace vantage {

/// A grid whose columns go about an axis of coordinates in equal steps: column c lies at start + step * c [rad], and
/// rows beside it at start + step * c + lean * r.
struct TurnSight {
  Axis axis = Axis::Z;
  double start = 0.0;
  double step = 0.0;
  double lean = 0.0;

  [[nodiscard]] double at(int row, int column) const { return start + step * column + lean * row; }
};

/// The grid with rows as columns.
[[nodiscard]] SampleGrid transposed(const SampleGrid& grid);

/// The angle of a point about an axis [rad], counter-clockwise from the next axis: about z from x.
[[nodiscard]] double angleAbout(Axis axis, const Vec3& p);

/// How the columns go about an axis, as neighbours tell; nothing without neighbours.
[[nodiscard]] std::optional<TurnSight> fitTurn(const SampleGrid& grid, Axis axis);

/// The turn of a grid that goes at least two thirds around an axis of coordinates, its rows at equal heights along it:
/// the scanner looked at the axis from all around. Nothing for other grids.
[[nodiscard]] std::optional<TurnSight> findTurn(const SampleGrid& grid);

/// The ranging rays of a grid that goes around an axis: they begin at the distance `radius` from it and meet it square.
[[nodiscard]] std::vector<RangingRay> turntableRays(const SampleGrid& grid, const TurnSight& turn, double radius);

/// The ranging rays of a scanner at the origin that turns about z.
[[nodiscard]] std::vector<RangingRay> pointRays(const SampleGrid& grid, const TurnSight& turn);

}  // namespace vantage
