#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "acquisition/stand.h"
#include "acquisition/stand_aligner.h"
#include "session/json_fields.h"

namespace vantage {

/// JSON of what is known of a stand. Readers take nothing on trust: @throws InvalidInput.
[[nodiscard]] nlohmann::json standJson(const Stand& stand);
/// @param index of the stand
[[nodiscard]] Stand standFrom(const nlohmann::json& json, int index, const std::string& what);

[[nodiscard]] nlohmann::json picksJson(const PickedPairs& picks);
[[nodiscard]] PickedPairs picksFrom(const nlohmann::json& list, const std::string& what);

}  // namespace vantage
