#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "integration/exact_plane.h"
#include "scanner/view.h"

namespace vantage {

/// Where a place in a view's grid falls on its mesh.
struct GridContact {
  std::uint32_t triangle = kNoIndex;
  std::array<double, 3> weights{};  ///< barycentric, of the triangle's vertices
};

/// A view's mesh as a function over its ray grid, where it is a flat arrangement of triangles: what lies at a place,
/// and how good it is there. Refers to the view's pieces, which it shares.
class GridSurface {
 public:
  /// @throws InvalidInput when the view has no image or no mesh, or the grid is too large to be handled exactly.
  explicit GridSurface(const View& view);

  [[nodiscard]] const RayGrid& rays() const { return *image_->rays; }
  [[nodiscard]] const ViewMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const Pose& T_object_scanner() const { return T_object_scanner_; }
  [[nodiscard]] const Pose& T_scanner_object() const { return T_scanner_object_; }

  /// Whether a surface with this normal (scanner coordinates, unit) can lie within the angle that `least` was asked for
  /// of any ray; false spares locating it.
  [[nodiscard]] bool mayFace(const Vec3& normal, double least) const { return -normal.dot(meanRay_) >= least; }
  /// For an angle with the given cosine.
  [[nodiscard]] double leastFacing(double minCosine) const {
    return std::cos(std::min(std::acos(minCosine) + rayCone_, kPi));
  }

  /// The triangle of the mesh at a place of the grid; the lower one on an edge.
  [[nodiscard]] std::optional<GridContact> at(const GridPosition& position) const;

  /// The triangles of the mesh in a cell of the grid, kNoIndex for none. @pre the cell is inside
  [[nodiscard]] const std::array<std::uint32_t, 2>& cell(int row, int column) const {
    return cells_[rays().index(row, column)];
  }

  /// The cells that a box of the exact plane touches, ends included, clamped to the grid.
  struct CellRange {
    int firstRow, lastRow, firstColumn, lastColumn;
  };
  [[nodiscard]] CellRange cellsUnder(const PlanePoint& low, const PlanePoint& high) const;

  /// A vertex's confidence, less near the border of the view, where samples are worse: it falls towards a small
  /// fraction over the last few samples. In (0, 1].
  [[nodiscard]] double quality(std::uint32_t vertex) const { return quality_[vertex]; }
  [[nodiscard]] double quality(const GridContact& contact) const;
  [[nodiscard]] double confidence(const GridContact& contact) const;

  /// Interpolated unit normal in scanner coordinates.
  [[nodiscard]] Vec3 normal(const GridContact& contact) const;

  /// A place in the grid in whole numbers, kPlaneCell to a cell, such that what faces the scanner turns
  /// counter-clockwise.
  [[nodiscard]] PlanePoint planePoint(const GridPosition& position) const;
  [[nodiscard]] PlanePoint planePoint(std::uint32_t sample) const;
  /// The place in the grid of the mean of three points of the plane.
  [[nodiscard]] GridPosition centreOf(const PlanePoint (&t)[3]) const;

 private:
  void fillCells();
  void rateVertices();
  void boundRays();

  std::shared_ptr<const RangeImage> image_;
  std::shared_ptr<const ViewMesh> mesh_;
  Pose T_object_scanner_;
  Pose T_scanner_object_;
  std::vector<std::array<std::uint32_t, 2>> cells_;  // by the sample at the cell's lower corner
  std::vector<float> quality_;
  std::int32_t columnSign_ = 1;
  Vec3 meanRay_ = Vec3::Zero();
  double rayCone_ = kPi;  // every ray is within this angle of the mean one
};

/// Steps of the exact plane per grid cell. Coarser than what locating a point leaves undecided, so that samples that
/// meet in the grid meet exactly.
inline constexpr std::int32_t kPlaneCell = 1024;

}  // namespace vantage
