#include "session/value_json.h"

#include "session/earlier_wording.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

}  // namespace

Json poseJson(const Pose& pose) {
  Json list = Json::array();
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 4; ++c) list.push_back(pose.matrix()(r, c));
  return list;
}

Pose poseFrom(const JsonFields& fields, const char* key) {
  double values[12];
  fields.numbers(key, values, 12);
  Pose pose = Pose::Identity();
  for (Eigen::Index i = 0; i < 12; ++i) pose.matrix()(i / 4, i % 4) = values[i];
  if (!pose.matrix().allFinite()) fields.fail(key);
  return pose;
}

std::optional<Pose> standPoseFrom(const JsonFields& fields, const Json& json, const char* key) {
  if (!fields.has(key) || json[key].is_null()) return std::nullopt;
  const Pose pose = poseFrom(fields, key);
  const Eigen::Matrix3d r = pose.linear();
  if (!(r * r.transpose()).isIdentity(1e-6) || r.determinant() < 0.0) fields.fail(key);
  return pose;
}

Json standPoseJson(const std::optional<Pose>& pose) {
  return pose ? poseJson(*pose) : Json(nullptr);
}

Json motionsJson(const WeakMotions& motions) {
  Json list = Json::array();
  for (const WeakMotion& motion : motions)
    list.push_back({{"kind", name(motion.kind)}, {"axis", numberList(motion.axis, 3)}});
  return list;
}

WeakMotions motionsFrom(const JsonFields& fields) {
  WeakMotions motions;
  for (const Json& item : fields.list("weak_motions")) {
    const JsonFields motion(item, fields.what());
    motions.push_back({motion.named("kind", WeakMotion::Kind::Free), Vec3::Zero()});
    motion.numbers("axis", motions.back().axis.data(), 3);
  }
  return motions;
}

WeakMotions motionsFrom(const JsonFields& fields, const char* earlierKey) {
  return fields.has("weak_motions") ? motionsFrom(fields) : weakMotionsFromEarlier(fields.text(earlierKey));
}

Json storedScoreJson(const PositionScore& s) {
  Json json{{"position", s.position},
            {"void_mm2", jsonNumber(s.voidArea)},
            {"overlap_mm2", jsonNumber(s.overlapArea)},
            {"weak_motions", motionsJson(s.weakMotions)},
            {"constraint", name(s.constraint)},
            {"short_by", jsonNumber(s.shortBy)}};
  if (s.tracedVoidArea) json["traced_void_mm2"] = jsonNumber(*s.tracedVoidArea);
  if (s.poseSigma) json["pose_sigma_mm"] = jsonNumber(*s.poseSigma);
  if (s.uncorrected) json["uncorrected_mm2"] = jsonNumber(*s.uncorrected);
  return json;
}

PositionScore scoreFrom(const JsonFields& fields) {
  PositionScore s;
  s.position = fields.integer("position");
  s.voidArea = fields.number("void_mm2");
  s.overlapArea = fields.number("overlap_mm2");
  if (fields.has("traced_void_mm2")) s.tracedVoidArea = fields.number("traced_void_mm2");
  if (fields.has("pose_sigma_mm")) s.poseSigma = fields.number("pose_sigma_mm");
  if (fields.has("uncorrected_mm2")) s.uncorrected = fields.number("uncorrected_mm2");
  s.weakMotions = motionsFrom(fields, "worst_direction");
  s.constraint = fields.named("constraint", Constraint::PoseUncertain);
  s.shortBy = fields.number("short_by");
  return s;
}

Json predictionJson(const PositionScore& score) {
  Json json = storedScoreJson(score);
  json["patches"] = score.patches;
  return json;
}

PositionScore predictionFrom(const JsonFields& fields) {
  PositionScore score = scoreFrom(fields);
  for (const Json& patch : fields.list("patches")) {
    if (!patch.is_number_unsigned()) fields.fail("patches");
    score.patches.push_back(patch.get<std::uint32_t>());
  }
  return score;
}

}  // namespace vantage
