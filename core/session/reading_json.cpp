#include "session/reading_json.h"

#include <cmath>

#include "session/value_json.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

double positive(const JsonFields& fields, const char* key) {
  const double value = fields.number(key);
  if (!(value > 0.0 && std::isfinite(value))) fields.fail(key);
  return value;
}

Vec3 vectorFrom(const JsonFields& fields, const char* key) {
  Vec3 vector;
  fields.numbers(key, vector.data(), 3);
  if (!vector.allFinite()) fields.fail(key);
  return vector;
}

}  // namespace

Json readingJson(const ScanReading& reading) {
  Json json{{"mm_per_unit", reading.unit},
            {"unit_known_by", name(reading.unitKnownBy)},
            {"rays", name(reading.sightKind)},
            {"looks_along", numberList(reading.sight, 3)},
            {"looks_known_by", name(reading.sightKnownBy)},
            {"no_sample", name(reading.noSample)},
            {"no_sample_cells", reading.dropped},
            {"rows_and_columns_exchanged", reading.exchanged},
            {"in_object_coordinates", reading.placed},
            {"offset_mm", numberList(reading.offset, 3)},
            {"mm_per_unit_of_poses", reading.poseUnit},
            {"unit_of_poses_known_by", name(reading.poseUnitKnownBy)},
            {"up", name(reading.up)}};
  if (reading.turnsAbout) json["poses_turn_about"] = name(*reading.turnsAbout);
  return json;
}

ScanReading readingFrom(const JsonFields& fields) {
  ScanReading reading;
  reading.unit = positive(fields, "mm_per_unit");
  reading.unitKnownBy = fields.named("unit_known_by", kLastKnownBy);
  reading.sightKind = fields.named("rays", kLastSightKind);
  reading.sight = vectorFrom(fields, "looks_along");
  reading.sightKnownBy = fields.named("looks_known_by", kLastKnownBy);
  reading.noSample = fields.named("no_sample", kLastNoSampleMark);
  reading.dropped = fields.count("no_sample_cells");
  reading.exchanged = fields.flag("rows_and_columns_exchanged");
  reading.placed = fields.flag("in_object_coordinates");
  reading.offset = vectorFrom(fields, "offset_mm");
  reading.poseUnit = positive(fields, "mm_per_unit_of_poses");
  reading.poseUnitKnownBy = fields.named("unit_of_poses_known_by", kLastKnownBy);
  reading.up = fields.named("up", kLastAxis);
  if (fields.has("poses_turn_about")) reading.turnsAbout = fields.named("poses_turn_about", kLastAxis);
  return reading;
}

Json readingsJson(const std::vector<ScanReading>& readings) {
  Json list = Json::array();
  for (const ScanReading& reading : readings) list.push_back(readingJson(reading));
  return list;
}

std::vector<ScanReading> readingsFrom(const Json& list, const std::string& what) {
  std::vector<ScanReading> readings;
  for (const Json& item : list) readings.push_back(readingFrom({item, what}));
  return readings;
}

}  // namespace vantage
