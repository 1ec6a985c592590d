#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// What may be wrong with a whole list of poses.
enum class PoseListFault : std::uint8_t {
  Turns,     ///< every turn is another multiple of what the list says [turned / listed]
  Inverted,  ///< the list has the pose of the object for the scanner
  Unit,      ///< positions are in another unit [mm per unit of the list]
  Frame,     ///< the scanner's axes point elsewhere [1 x, 2 y, 3 z: the axis that is right, the other two are reversed]
  Axis,      ///< the axis lies beside where the list has it [mm]
};

/// One fault and how large it is.
struct PoseListFinding {
  PoseListFault fault = PoseListFault::Turns;
  double value = 0.0;

  friend bool operator==(const PoseListFinding&, const PoseListFinding&) = default;
};

/// A list without its fault.
struct MendedList {
  PoseListFinding finding;
  std::vector<Pose> poses;  ///< T_object_scanner, one per scan
};

/// What a list says if its scans stand about one axis.
struct ListedTurns {
  Vec3 axis = Vec3::UnitZ();
  Vec3 point = Vec3::Zero();   ///< on the axis [mm]
  std::vector<double> angles;  ///< from the first scan, one per scan; those that follow each other differ by at most pi
};

/// Nothing unless there are turns, and all of them within 8 degrees about the same axis.
[[nodiscard]] std::optional<ListedTurns> turnsOf(std::span<const Pose> poses);

/// The list as it would be if every turn were `factor` times as large.
[[nodiscard]] MendedList withTurns(std::span<const Pose> poses, const ListedTurns& turns, double factor);

/// The list without each fault that may be tried one by one: inverted, another unit, other axes of the scanner.
[[nodiscard]] std::vector<MendedList> mendedLists(std::span<const Pose> poses);

/// What the differences of the found poses from those given have in common: turns by another factor, or an axis beside.
/// Nothing where no such fault makes them less than half, or where it moves scans by less than `least` [mm].
/// @param given, found one per scan, of the same scans; the first tells where both lists lie
[[nodiscard]] std::optional<PoseListFinding> commonFault(std::span<const Pose> given, std::span<const Pose> found,
                                                         double least);

}  // namespace vantage
