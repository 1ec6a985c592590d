#pragma once

#include <nlohmann/json.hpp>

#include "geometry/region.h"
#include "session/json_fields.h"

namespace vantage {

/// A region of what was erased, with its kind. Numbers come back to the last bit.
[[nodiscard]] nlohmann::json regionJson(const Region& region);

/// @throws InvalidInput naming what is damaged, also for a region that is none
[[nodiscard]] Region regionFrom(const JsonFields& fields);

}  // namespace vantage
