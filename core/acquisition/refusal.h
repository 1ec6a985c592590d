#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace vantage {

/// Why something cannot be done now.
enum class RefusalReason : std::uint8_t {
  NoProfile,       ///< without a scanner profile there are no positions
  NoSuchPosition,  ///< number: the position
  NoSuchStand,     ///< number: the stand
  StandKnown,      ///< number: the stand, whose pose is known already
  NotAView,        ///< number: the scan, which is no view of the model
  OnlyView,        ///< number: the scan, which is the only view of the model
  NotLeftOut,      ///< number: the scan, which was not left out
  ScanUsed,        ///< number: the scan, which the session has already made something of
  ScansBefore,     ///< recorded scans are imported into an empty session only
  NoScans,         ///< an import of nothing
  AlreadyEnded,    ///< the acquisition has ended already
  NotEnded,        ///< the acquisition has not ended, so it cannot be opened again
  NothingLeft,     ///< no position would show more than is worth a scan
  LimitReached,    ///< the greatest number of views was taken: raise it to go on
  NothingScanned,  ///< there is no scan yet
  MeshesMade,      ///< the object and how scans become meshes cannot be changed once there are scans
  Contradiction,   ///< settings contradict each other
  NotReplayable,   ///< what an earlier version did cannot be done again
  NothingToUndo,
  NothingToRedo,
  NothingToScanWith,  ///< the session has no devices: no scanner, or nothing that it could look at
  FitsNoOtherTurn,    ///< number: the scan, of which it is not known that it fits that turn of the table
  NothingToAlign,     ///< number: the stand, which has no view yet
  NotAligned,         ///< number: the stand, of which no alignment was tried yet
  NoSuchPose,         ///< number: the pose, which is none of those that were found
  PoseContradicted,   ///< number: the pose, which something speaks against
  StandsTogether,     ///< several stands make the object already
  OtherStand,         ///< number: the scan, whose stand is not the one that is worked on
  StandNotInWork,     ///< number: the stand, which is not aligned with the one that is worked on
  NotErased,          ///< number: the erasure, which was not made or was taken back
};
inline constexpr RefusalReason kLastRefusalReason = RefusalReason::NotErased;
/// A code: "no_profile", "no_such_position", ...
[[nodiscard]] std::string_view name(RefusalReason reason);

struct Refusal {
  RefusalReason reason = RefusalReason::NoProfile;
  std::optional<std::int64_t> number;  ///< of the position, scan or stand that it is about
};

}  // namespace vantage
