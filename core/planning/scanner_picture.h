#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "planning/planning_scene.h"

namespace vantage {

/// What a ranging ray would meet, going by what is known so far.
enum class RaySight : std::uint8_t {
  Nothing,          ///< no surface and no void within its range
  Surface,          ///< the model, where the scanner would sample it
  TooSteep,         ///< the model, beyond the breakdown angle
  ReceiverBlocked,  ///< the model, where no receiver would see it
  Void,             ///< a void patch, before any surface
  Back,             ///< the inside of the model's surface: what is there was never seen
};
inline constexpr std::size_t kRaySights = 6;

/// What the scanner would see from a position. One pixel per ranging ray.
struct ScannerPicture {
  int rows = 0;
  int columns = 0;
  bool rowsUp = false;          ///< row 0 is at the bottom of the picture
  bool columnsLeft = false;     ///< column 0 is at its right
  std::vector<RaySight> sight;  ///< row-major
  std::vector<float> cosine;    ///< between the ray and the normal of what it meets, 0 for nothing
  std::vector<float> range;     ///< [mm] to what it meets, 0 for nothing

  [[nodiscard]] std::size_t count(RaySight wanted) const;
};

/// Follows every ranging ray from a position to the scene's surface and void patches.
/// @throws InvalidInput for a position that the workspace does not have; Cancelled
[[nodiscard]] ScannerPicture computeScannerPicture(const PlanningScene& scene, int position, const Progress& progress);

}  // namespace vantage
