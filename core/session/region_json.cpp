#include "session/region_json.h"

#include <limits>
#include <string>
#include <utility>

#include "session/value_json.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

template <typename Points>
Json flatList(const Points& points) {
  Json list = Json::array();
  for (const auto& p : points)
    for (const double number : p) list.push_back(number);
  return list;
}

template <typename Point>
std::vector<Point> pointsFrom(const JsonFields& fields, const char* key) {
  const Json& list = fields.list(key);
  constexpr auto kNumbers = static_cast<std::size_t>(Point::RowsAtCompileTime);
  if (list.size() % kNumbers != 0) fields.fail(key);
  std::vector<Point> points(list.size() / kNumbers);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_number()) fields.fail(key);
    points[i / kNumbers][static_cast<Eigen::Index>(i % kNumbers)] = list[i].get<double>();
  }
  return points;
}

Vec3 regionVector(const JsonFields& fields, const char* key) {
  Vec3 vector = Vec3::Zero();
  fields.numbers(key, vector.data(), 3);
  return vector;
}

Json fieldsOfRegion(const BelowPlane& region) {
  return {{"point", numberList(region.point, 3)}, {"normal", numberList(region.normal, 3)}};
}
Json fieldsOfRegion(const OrientedBox& region) {
  return {{"T_region_box", poseJson(region.T_region_box)}, {"size_mm", numberList(region.size, 3)}};
}
Json fieldsOfRegion(const Prism& region) {
  return {{"T_region_eye", poseJson(region.T_region_eye)},
          {"perspective", region.perspective},
          {"corners", flatList(region.corners)},
          {"nearest_mm", jsonNumber(region.nearest)},
          {"farthest_mm", jsonNumber(region.farthest)}};
}
Json fieldsOfRegion(const NearPoints& region) {
  return {{"points", flatList(region.points)}, {"radius_mm", jsonNumber(region.radius)}};
}

Region regionOfKind(const JsonFields& fields) {
  const std::string kind = fields.text("kind");
  if (kind == kindOf(BelowPlane{})) return BelowPlane{regionVector(fields, "point"), regionVector(fields, "normal")};
  if (kind == kindOf(OrientedBox{}))
    return OrientedBox{poseFrom(fields, "T_region_box"), regionVector(fields, "size_mm")};
  if (kind == kindOf(Prism{})) {
    Prism prism;
    prism.T_region_eye = poseFrom(fields, "T_region_eye");
    prism.perspective = fields.flag("perspective");
    prism.corners = pointsFrom<Vec2>(fields, "corners");
    prism.nearest = fields.number("nearest_mm");
    prism.farthest = fields.number("farthest_mm");
    return prism;
  }
  if (kind == kindOf(NearPoints{})) return NearPoints{pointsFrom<Vec3>(fields, "points"), fields.number("radius_mm")};
  fields.fail("kind");
}

}  // namespace

Json regionJson(const Region& region) {
  Json json = std::visit([](const auto& r) { return fieldsOfRegion(r); }, region);
  json["kind"] = kindOf(region);
  return json;
}

Region regionFrom(const JsonFields& fields) {
  Region region = regionOfKind(fields);
  try {
    validate(region);
  } catch (const InvalidInput& e) {
    throw InvalidInput(fields.what() + " is damaged: " + e.what());
  }
  return region;
}

}  // namespace vantage
