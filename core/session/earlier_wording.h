#pragma once

#include <optional>
#include <string_view>

#include "acquisition/phase_times.h"
#include "registration/verdict.h"

namespace vantage {

/// Session files up to schema 2 hold sentences where codes are now. These readers know every sentence that was ever
/// written; the numbers in them come back as they were rounded.

/// A sentence that nobody knows becomes EarlierVersion, an empty one NotRegistered.
[[nodiscard]] Finding findingFromEarlier(std::string_view sentence);

/// "slides along z and turns about z". Empty when any part of it is not known.
[[nodiscard]] WeakMotions weakMotionsFromEarlier(std::string_view sentence);

/// The phase that a step of an earlier version belongs to: "Registering" is part of Register. None when not known.
[[nodiscard]] std::optional<Phase> phaseFromEarlier(std::string_view step);

}  // namespace vantage
