#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "geometry/vectors.h"
#include "planning/plan.h"
#include "registration/weak_direction.h"
#include "session/json_fields.h"

namespace vantage {

/// JSON of values that commands, records and plans have in common. Readers take nothing on trust: @throws InvalidInput.

/// A list of the first `count` numbers; what is infinite is null.
template <typename Values>
[[nodiscard]] nlohmann::json numberList(const Values& values, std::size_t count) {
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(jsonNumber(values[i]));
  return list;
}

/// The upper 3x4 part of a pose, row by row.
[[nodiscard]] nlohmann::json poseJson(const Pose& pose);
[[nodiscard]] Pose poseFrom(const JsonFields& fields, const char* key);

/// A pose that must be a rigid motion; null, or no such field, for nothing.
[[nodiscard]] nlohmann::json standPoseJson(const std::optional<Pose>& pose);
[[nodiscard]] std::optional<Pose> standPoseFrom(const JsonFields& fields, const nlohmann::json& json, const char* key);

/// Up to schema 2 the motions were words, under a key of their own.
[[nodiscard]] nlohmann::json motionsJson(const WeakMotions& motions);
[[nodiscard]] WeakMotions motionsFrom(const JsonFields& fields);
[[nodiscard]] WeakMotions motionsFrom(const JsonFields& fields, const char* earlierKey);

/// A position's score without its patches.
[[nodiscard]] nlohmann::json storedScoreJson(const PositionScore& score);
[[nodiscard]] PositionScore scoreFrom(const JsonFields& fields);

/// With the patches that the position would see.
[[nodiscard]] nlohmann::json predictionJson(const PositionScore& score);
[[nodiscard]] PositionScore predictionFrom(const JsonFields& fields);

}  // namespace vantage
