#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/grid_file.h"
#include "io/grid_sight.h"
#include "io/turn_grid.h"

namespace vantage {

/// A range file with what its own numbers say.
struct RawScan {
  std::string path;
  GridFile file;
  Vec3 shift = Vec3::Zero();             ///< what was taken off its points, which were far from the origin [units]
  std::optional<Pose> T_object_scanner;  ///< in units of the file, of the points without the shift
  bool poseOfList = false;
  GridSight sight;
  std::optional<TurnSight> turn;
  ScanReading reading;
};

/// Far from the origin single precision does not tell neighbouring samples apart: more than 10^5 pitches.
[[nodiscard]] bool isFar(const Vec3& place, double pitch);

/// Longest side of the box about the samples [units].
[[nodiscard]] double sizeOf(const SampleGrid& grid);

/// Whether the scans are in the coordinates of the object already: their lines of sight are where the list of poses
/// would take them.
[[nodiscard]] bool areAlreadyPlaced(const std::vector<RawScan>& scans);

/// Whether scans without poses look in such different directions that their points must be in one common frame.
[[nodiscard]] bool lookDifferentWays(const std::vector<RawScan>& scans);

/// Whether scanners look along the directions of their sights (1) or against them (-1), from where their surface lies
/// about the middle of all: a solid is seen from outside. Nothing where that is not clear. All have poses.
/// @pre the directions agree in sign, in the axes of the files
[[nodiscard]] std::optional<int> commonSide(const std::vector<RawScan>& scans);

/// The same for one of the scans alone.
[[nodiscard]] std::optional<int> sideOf(const RawScan& scan, const std::vector<RawScan>& scans);

/// The axis of the object that the poses turn about; nothing for fewer than two, or for other turns.
[[nodiscard]] std::optional<Axis> axisOfTurns(const std::vector<RawScan>& scans);

}  // namespace vantage
