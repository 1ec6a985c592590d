#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "acquisition/history.h"

namespace vantage {

/// One moment of a session: what led to it, and what there was.
struct Moment {
  QString text;
  int views = 0;
  std::optional<std::int64_t> scan;  ///< that led to it; nothing for other commands
  std::optional<int> position;       ///< of the scan that led to it; nothing for other commands
  double newArea = 0.0;              ///< that the scan brought [mm^2]
  bool rejected = false;             ///< the scan did not find its place
  int stand = 0;                     ///< that the object was in
  /// The outline after it; shared with the history.
  std::shared_ptr<const StateOutline> outline = nullptr;
  bool undone = false;  ///< it is behind the cursor and can be redone
};

[[nodiscard]] std::vector<Moment> momentsOf(const History& history);

}  // namespace vantage
