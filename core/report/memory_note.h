#pragma once

#include <cstddef>
#include <optional>

#include "base/phrase.h"
#include "scanner/thinning.h"

namespace vantage {

/// How much memory work with a scanner of so many rays is going to take, before any of it begins; nothing where that is
/// little. See `raysSaidBy` for a profile of which no ray is made yet.
/// @param scans that the session has already
[[nodiscard]] std::optional<Phrase> memoryNote(std::size_t rays, const ThinningOptions& thinning,
                                               std::size_t scans = 0);

}  // namespace vantage
