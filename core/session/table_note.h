#pragma once

#include <optional>

#include "scanner/rig.h"
#include "scanner/table_stand.h"
#include "session/session.h"

namespace vantage {

/// The rig with a positioner that remarks in a session where it stands, before and after every move: a run may end at
/// any moment, also between a move and the scan it was for. @pre the session lives as long as the rig
[[nodiscard]] Rig remarked(Rig rig, Session& session);

/// Where the table of a session was left.
struct TableLeft {
  TableStand stand;               ///< as far as is known
  std::optional<int> underWayTo;  ///< it was left in a move to that position, and stands anywhere
};

/// As was remarked last, and what scans have shown since (see tableStand). Nothing when scans have no positions.
[[nodiscard]] std::optional<TableLeft> tableLeft(const Session& session);

}  // namespace vantage
