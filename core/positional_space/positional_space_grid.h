#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "geometry/vectors.h"
#include "scanner/profile.h"

namespace vantage {

/// A cell (w, y, phi, psi) of positional space: a cell of the surface and a cell of the directions in which rays leave
/// through it.
struct PositionalCell {
  int row = 0;     ///< of the surface, from below (cylinder) or from the south pole (sphere)
  int column = 0;  ///< of the surface, counter-clockwise from about +x (see PositionalSpaceShape::firstColumn)
  int phi = 0;     ///< direction cell about the surface's vertical, from -pi/2 to pi/2 off the normal
  int psi = 0;     ///< direction cell above the surface's horizon, from -pi/2 to pi/2

  bool operator==(const PositionalCell&) const = default;
};

/// A directed line out of the viewing volume: an observation ray, or a ranging ray r seen from its surface (-r).
struct OutwardRay {
  Vec3 point = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();  ///< unit
};

/// One cell of the positional space surface (PSS) as a rectangle (cylinder) or a trapezoid (sphere) of its tangent
/// plane.
struct SurfaceCell {
  Vec3 centre = Vec3::Zero();
  Vec3 normal = Vec3::UnitX();  ///< unit, outward
  Vec3 across = Vec3::UnitY();  ///< unit, along a row, counter-clockwise
  Vec3 up = Vec3::UnitZ();      ///< unit, along a column
  double halfWidth = 0.0;       ///< [mm] along across, at the middle
  double halfHeight = 0.0;      ///< [mm] along up
  double taper = 0.0;           ///< [1/mm] at the height u above the middle it is halfWidth * (1 - taper * u) wide

  [[nodiscard]] double widest() const { return halfWidth * (1.0 + std::abs(taper) * halfHeight); }  ///< [mm] half
};

/// Where positional space lies and how it is divided.
struct PositionalSpaceShape {
  PositionalSpaceSurface surface = PositionalSpaceSurface::Cylinder;
  int rows = 20;
  int columns = 90;
  double radius = 155.0;     ///< [mm] of the cylinder about the z axis, or of the sphere
  double bottom = 0.0;       ///< [mm] z of the cylinder's lower rim
  double top = 300.0;        ///< [mm] z of its upper rim; the sphere's centre is halfway between the two
  double firstColumn = 0.0;  ///< [rad] azimuth at which column 0 begins
  int directions = 61;       ///< direction cells over pi, for phi and for psi; odd: the normal is a cell's centre
  /// [rad] How far the directions of an observation ray and a ranging ray that meet in a cell can differ, for a surface
  /// at the middle of the viewing volume: half a cell as seen from there and from the scanner's head, and half a
  /// direction cell.
  double angularError = 0.0;
};

/// Positional space (Pito 1999, 5.1): a surface that encloses the viewing volume (PSS) and at each of its cells the
/// local polar directions (PSD) about the cell's normal,
///   phi = atan2(d.across, d.normal),  psi = asin(d.up)
/// for a ray that leaves in the direction d. Immutable.
class PositionalSpaceGrid {
 public:
  static constexpr int kMostColumns = 3600;

  /// @throws InvalidInput for a shape without cells or size, or with more than kMostColumns columns.
  explicit PositionalSpaceGrid(const PositionalSpaceShape& shape);

  [[nodiscard]] const PositionalSpaceShape& shape() const { return shape_; }
  [[nodiscard]] int rows() const { return shape_.rows; }
  [[nodiscard]] int columns() const { return shape_.columns; }
  [[nodiscard]] double directionStep() const { return kPi / shape_.directions; }  ///< [rad] width of a direction cell

  /// The cell that the line leaves the surface through; none when it misses the surface (the lids of a cylinder are
  /// not part of it). A border belongs to the cell with the higher index.
  [[nodiscard]] std::optional<PositionalCell> project(const OutwardRay& ray) const;

  /// A ranging ray's cell: that of the observation ray that looks back along it, -r.
  [[nodiscard]] std::optional<PositionalCell> project(const RangingRay& ray) const {
    return project(OutwardRay{ray.origin, -ray.direction});
  }

  /// The ray through the middle of a cell: project(unproject(cell)) == cell wherever the direction leaves the surface.
  [[nodiscard]] OutwardRay unproject(const PositionalCell& cell) const;

  /// Cells of the surface, row-major.
  [[nodiscard]] const SurfaceCell& surfaceCell(int row, int column) const {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(shape_.columns) +
                  static_cast<std::size_t>(column)];
  }
  [[nodiscard]] const std::vector<SurfaceCell>& surfaceCells() const { return cells_; }

  /// Direction cell of a unit direction that leaves through a surface cell; `row` and `column` are left at 0.
  [[nodiscard]] PositionalCell directionCell(const SurfaceCell& cell, const Vec3& direction) const;

 private:
  PositionalSpaceShape shape_;
  std::vector<SurfaceCell> cells_;
};

/// Positional space for a scanner. The cylinder that the profile asks for is made tall enough that every ranging ray of
/// every position that meets the viewing volume leaves through it, at the profile's height of a row; where it would
/// have to be taller than twice the viewing volume (rays from far above), the surface becomes a sphere.
///
/// Direction cells are as fine as they can be (0.5 degrees), as the fans of the scanner and of a surface point over a
/// surface cell are taken into account one by one; nothing falls between cells. Where more than 3 positions look
/// through a surface cell in directions that differ by less than rays of one position do, direction cells are a third
/// as wide as that, and positions share them: the cost of an image then does not grow with their number.
/// @throws Cancelled
[[nodiscard]] PositionalSpaceGrid makePositionalSpaceGrid(const ScannerProfile& profile, const Progress& progress = {});

}  // namespace vantage
