#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace vantage {

/// Where a scan was taken: how the object stood on the table, and from which position of the workspace.
struct Station {
  int stand = 0;                ///< index of the stand of the object, see Stand
  std::optional<int> position;  ///< index into the workspace; nothing for recorded scans of no position
};
[[nodiscard]] bool operator==(const Station& a, const Station& b);

/// How the pose of a scan relative to the table is known.
enum class PoseSource : std::uint8_t {
  Unknown,    ///< nobody said
  Commanded,  ///< where the positioner was told to go
  Reported,   ///< what a device or a list of poses says
  ByHand,     ///< a person turned the table and confirmed it
};
/// "unknown", "commanded", "reported", "hand".
[[nodiscard]] std::string_view name(PoseSource source);

}  // namespace vantage
