#pragma once

#include <cstdint>
#include <string_view>

namespace vantage {

/// Why a boundary edge is left (the certificate of termination).
enum class EdgeReason : std::uint8_t {
  OutOfReach,       ///< no ranging ray of any position reaches it
  TooSteep,         ///< reached, but always beyond the breakdown angle
  LightBlocked,     ///< the model blocks the light from everywhere else
  ReceiverBlocked,  ///< light reaches it, but no receiver would see it
  BelowThreshold,   ///< could be seen, but all that one view would add is below F
  Answered,         ///< views looked at it and found no surface
  Erased,           ///< what lies beyond is not the object: the operator erased it
};
inline constexpr int kEdgeReasons = 7;
[[nodiscard]] std::string_view name(EdgeReason reason);

/// The state of one void patch for the planner.
struct PatchOutlook {
  std::uint8_t looks = 0;                          ///< views taken so far that should have sampled a surface there
  bool answered = false;                           ///< enough looks, or erased: it attracts no more views
  EdgeReason reason = EdgeReason::BelowThreshold;  ///< what keeps it void; meaningful once nothing is left to scan
  double promise = 0.0;  ///< most that any one position would show of it; known like the reason [mm^2]
};

}  // namespace vantage
