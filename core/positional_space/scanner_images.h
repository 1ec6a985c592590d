#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "positional_space/positional_space_grid.h"
#include "scanner/profile.h"

namespace vantage {

/// What is known of the ranging rays that occupy one cell of positional space: the mean of the rays that leave through
/// the middle of the surface cell, one per position that shares the cell. Slopes are taken in the surface cell's frame:
/// (d.across, d.up) / d.normal.
struct OccupiedCell {
  std::array<float, 2> slope{};    ///< of the ray through the middle
  std::array<float, 4> fan{};      ///< [1/mm] how the slope changes across the surface cell; row-major 2 x 2
  float sourceDistance = 0.0F;     ///< [mm] from the surface cell's middle outward to the ray's origin
  std::uint32_t receiverSide = 0;  ///< 0..3: on which side of the ray its first receiver is; never mixed
};

/// P_c^i for every position i of a workspace: which cells of positional space the scanner's ranging rays occupy
/// (Pito 1999, 5.2, eq. 1).
///
/// A ranging ray is entered where it leaves through the middle of a surface cell: of all rays that cross the cell, the
/// one that is interpolated there. How the others differ from it is kept as `fan`, and an observation ray is entered in
/// every occupied cell whose fan it is part of (see `accumulate`). A surface point that a position sees is thus met in
/// one surface cell per position, and the sums over cells are areas.
///
/// Cells are numbered 0..cellCount()-1 over the union of all positions; no other cell can ever be of use. On a
/// turntable the images repeat every `gcd(steps, columns)`-th of a turn: they are stored for one period and every other
/// position is a shift of the numbers. Immutable.
class ScannerImages {
 public:
  /// What is stored: the union for one period of columns, and the images of the positions within one period.
  struct Data {
    PositionalSpaceShape shape;
    int positions = 0;
    int steps = 0;                            ///< positions per turn; equal to `positions` without a turntable
    int periods = 1;                          ///< per turn
    int receivers = 0;                        ///< per ray
    double minRange = 0.0;                    ///< [mm]
    double maxRange = 0.0;                    ///< [mm]
    std::vector<std::uint32_t> surfaceStart;  ///< per surface cell of the period (row-major), its first occupied cell
    std::vector<OccupiedCell> cells;          ///< by surface cell, then slope[0]
    std::vector<std::array<std::int16_t, 2>> direction;  ///< per cell phi, psi
    std::vector<Vec3> receiverPositions;    ///< per cell `receivers` positions, object coordinates of the period 0
    std::vector<std::uint32_t> imageStart;  ///< per stored image, its first entry
    std::vector<std::uint32_t> imageCells;  ///< numbers of cells, ascending within an image
  };

  /// @throws InvalidInput when the parts do not fit together.
  explicit ScannerImages(Data data);

  [[nodiscard]] const PositionalSpaceGrid& grid() const { return grid_; }
  [[nodiscard]] const Data& data() const { return data_; }
  [[nodiscard]] int positions() const { return data_.positions; }
  [[nodiscard]] std::size_t cellCount() const { return data_.cells.size() * static_cast<std::size_t>(data_.periods); }
  [[nodiscard]] bool triangulates() const { return data_.receivers > 0; }

  /// P_c^i as ascending cell numbers.
  [[nodiscard]] std::vector<std::uint32_t> image(int position) const;

  /// Positions whose image contains the cell, ascending.
  [[nodiscard]] std::vector<int> positionsOf(std::uint32_t cell) const;

  /// Where in positional space a cell number is.
  [[nodiscard]] PositionalCell cell(std::uint32_t number) const;

  /// The mean ranging ray of a cell, as it leaves through the middle of the surface cell.
  [[nodiscard]] OutwardRay ray(std::uint32_t number) const;

  /// Receivers that watch a cell's rays, object coordinates.
  [[nodiscard]] std::vector<Vec3> receivers(std::uint32_t number) const;

  /// The stored image that a position is a shift of, and the shift to add to its numbers, modulo cellCount().
  struct Shift {
    std::size_t image;
    std::size_t offset;
  };
  [[nodiscard]] Shift shiftOf(int position) const;

 private:
  Data data_;
  PositionalSpaceGrid grid_;
  std::vector<std::uint32_t> positionStart_;  // per stored cell, into positions_
  std::vector<std::uint32_t> positions_;      // positions that see the cell in period 0
};

/// Computes the images of every position of the profile's workspace.
/// @throws Cancelled
[[nodiscard]] ScannerImages computeScannerImages(const ScannerProfile& profile, const Progress& progress = {});

}  // namespace vantage
