#include "session/stand_json.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "session/region_json.h"
#include "session/value_json.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

constexpr int kMostErasures = 1'000'000;

Vec3 pointFrom(const JsonFields& fields, const char* key) {
  Vec3 point = Vec3::Zero();
  fields.numbers(key, point.data(), 3);
  if (!point.allFinite()) fields.fail(key);
  return point;
}

Json candidateJson(const StandPose& pose) {
  return {{"T_object_stand", poseJson(pose.T_object_stand)},
          {"overlap", jsonNumber(pose.overlap)},
          {"rms_mm", jsonNumber(pose.rms)},
          {"conflict", jsonNumber(pose.conflict)},
          {"table", jsonNumber(pose.table)},
          {"missing", jsonNumber(pose.missing)},
          {"score", jsonNumber(pose.score)},
          {"possible", pose.possible}};
}

StandPose candidateFrom(const Json& json, const std::string& what) {
  const JsonFields fields(json, what);
  const auto placed = standPoseFrom(fields, json, "T_object_stand");
  if (!placed) fields.fail("T_object_stand");
  return {*placed,
          fields.number("overlap"),
          fields.number("rms_mm"),
          fields.number("conflict"),
          fields.number("table"),
          fields.number("missing"),
          fields.number("score"),
          fields.flag("possible")};
}

Json alignmentJson(const StandAlignment& alignment) {
  Json json{{"verdict", name(alignment.verdict)},
            {"reason", name(alignment.reason)},
            {"candidates", Json::array()},
            {"same_surface", alignment.sameSurface},
            {"picked", alignment.picked}};
  if (alignment.value) json["value"] = jsonNumber(*alignment.value);
  for (const StandPose& pose : alignment.candidates) json["candidates"].push_back(candidateJson(pose));
  if (alignment.used) {
    json["used"] = *alignment.used;
    json["choice"] = name(alignment.choice);
  }
  return json;
}

StandAlignment alignmentFrom(const JsonFields& fields) {
  StandAlignment alignment;
  alignment.verdict = fields.named("verdict", kLastAlignmentVerdict);
  alignment.reason = fields.named("reason", kLastAlignmentReason);
  if (fields.has("value")) alignment.value = fields.number("value");
  for (const Json& candidate : fields.list("candidates"))
    alignment.candidates.push_back(candidateFrom(candidate, fields.what()));
  alignment.sameSurface = fields.flag("same_surface");
  alignment.picked = fields.flag("picked");
  if (fields.has("used")) {
    const auto count = static_cast<std::int64_t>(alignment.candidates.size());
    alignment.used = static_cast<int>(fields.integer("used", 0, count - 1));
    alignment.choice = fields.named("choice", kLastPoseChoice);
  }
  return alignment;
}

}  // namespace

// What no stand of earlier versions had is not there where it is not known.
Json standJson(const Stand& stand) {
  Json json{{"T_object_table", standPoseJson(stand.T_object_table)}};
  if (stand.down) json["down"] = numberList(*stand.down, 3);
  if (stand.reference != 0) json["reference"] = stand.reference;
  if (stand.alignment) json["alignment"] = alignmentJson(*stand.alignment);
  for (const ErasedRegion& erased : stand.erased)
    json["erased"].push_back({{"number", erased.number}, {"region", regionJson(erased.region->region())}});
  return json;
}

Stand standFrom(const Json& json, int index, const std::string& what) {
  const JsonFields fields(json, what);
  Stand stand{standPoseFrom(fields, json, "T_object_table")};
  if (fields.has("down")) stand.down = pointFrom(fields, "down");
  if (fields.has("reference"))
    stand.reference = static_cast<int>(fields.integer("reference", 0, std::max(index - 1, 0)));
  if (fields.has("alignment"))
    stand.alignment = std::make_shared<const StandAlignment>(alignmentFrom(fields.object("alignment")));
  if (fields.has("erased"))
    for (const Json& erased : fields.list("erased")) {
      const JsonFields one(erased, what);
      stand.erased.push_back({static_cast<int>(one.integer("number", 0, kMostErasures)),
                              std::make_shared<const RegionProbe>(regionFrom(one.object("region")))});
    }
  return stand;
}

Json picksJson(const PickedPairs& picks) {
  Json list = Json::array();
  for (const PickedPair& pair : picks)
    list.push_back({{"on_object", numberList(pair.reference, 3)}, {"on_stand", numberList(pair.moved, 3)}});
  return list;
}

PickedPairs picksFrom(const Json& list, const std::string& what) {
  PickedPairs picks;
  for (const Json& pair : list) {
    const JsonFields fields(pair, what);
    picks.push_back({pointFrom(fields, "on_object"), pointFrom(fields, "on_stand")});
  }
  return picks;
}

}  // namespace vantage
