#pragma once

#include <cstdint>
#include <vector>

#include "scanner/range_image.h"
#include "scanner/ray_grid.h"

namespace vantage {

/// A grid of samples, as it stands in a range file, without the rays that took them.
struct SampleGrid {
  int rows = 0;
  int columns = 0;
  std::vector<Vec3> points;         ///< [mm]
  std::vector<std::uint32_t> cell;  ///< per cell, row-major: index of its point, or kNoIndex
  std::vector<Colour> colours{};    ///< per point; empty where the file has none
};

/// Lines of sight of a grid: the ray of row r, column c moves by slope(r, c) in x and y while z grows by 1. With
/// u = (c - columns / 2) / columns and v = (r - rows / 2) / rows: slope = constant + column * u + row * v.
struct SightSlopes {
  Vec2 constant = Vec2::Zero();
  Vec2 column = Vec2::Zero();
  Vec2 row = Vec2::Zero();
};

/// Finds the slopes from neighbouring samples: across a step in depth dz they move by the grid's pitch plus slope * dz.
/// Least absolute deviations by reweighting; the pitch may differ between even and odd rows. Parallel rays along z have
/// slope 0, and so does a grid that is too flat to tell.
[[nodiscard]] SightSlopes fitSightSlopes(const SampleGrid& grid);

/// Fills in the places of cells. `positions` has rows x columns entries, row-major; unknown ones are NaN, known ones
/// stay. A cell lies at pitch * (row, column) plus an offset of its row (interlaced rows are shifted) and of its column
/// (warped columns are not equally spaced), found with medians; what is left of neighbouring samples is spread smoothly
/// and fades with distance.
/// @pre at least one entry is known
void fillGridPositions(int rows, int columns, std::vector<Vec2>& positions);

/// The ranging rays of a scanner that looks down along z: all begin at height `top` [mm]; the ray of a sample goes
/// through it, the others lie where the grid would have them. @pre grid has a sample
[[nodiscard]] std::vector<RangingRay> reconstructRays(const SampleGrid& grid, double top);

}  // namespace vantage
