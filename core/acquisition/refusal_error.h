#pragma once

#include "acquisition/refusal.h"

namespace vantage {

/// @throws InvalidInput that says why something cannot be done.
[[noreturn]] void throwRefusal(const Refusal& refusal);

}  // namespace vantage
