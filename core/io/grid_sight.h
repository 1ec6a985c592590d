#pragma once

#include <optional>

#include "io/range_grid_rays.h"

namespace vantage {

/// How the lines of sight of a grid lie, as its samples tell. Column and row are each a ratio of two functions that are
/// linear in the point, c = (a p + a0) / (g p + g0): every c is a plane, and all of them meet in one line, or are
/// parallel. The lines of sight are where the planes of c and r cross. Away from the scanner the planes spread.
struct GridSight {
  /// Along the line of sight in the middle of the samples, unit. Where `spreads`, away from the scanner, else either
  /// way.
  Vec3 direction = -Vec3::UnitZ();
  bool fits = false;               ///< the grid is as told above, and its surface not so flat that every line would do
  bool spreads = false;            ///< the lines of sight spread so much that the scanner's side is certain
  std::optional<double> distance;  ///< from where they meet to the middle of the samples, in units; where they spread
  double error = 0.0;              ///< median distance of the samples from their places in the grid [cells]
};

[[nodiscard]] GridSight findGridSight(const SampleGrid& grid);

/// Median distance between samples of neighbouring cells; 0 without any.
[[nodiscard]] double medianPitch(const SampleGrid& grid);

/// The middle of the samples. @pre grid has one
[[nodiscard]] Vec3 middleOf(const SampleGrid& grid);

/// Whether the grid has its rows and columns the other way round: then neighbours are found with the numbers exchanged.
[[nodiscard]] bool isExchanged(const SampleGrid& grid);

}  // namespace vantage
