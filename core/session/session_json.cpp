#include "session/session_json.h"

#include <utility>

#include "acquisition/settings_json.h"
#include "session/earlier_wording.h"
#include "session/json_fields.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

template <typename Values>
Json numberList(const Values& values, std::size_t count) {
  Json list = Json::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(jsonNumber(values[i]));
  return list;
}

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

// A pose that must be a rigid motion; nothing for null.
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

// Up to schema 2 the motions were words.
WeakMotions motionsFrom(const JsonFields& fields, const char* earlierKey) {
  return fields.has("weak_motions") ? motionsFrom(fields) : weakMotionsFromEarlier(fields.text(earlierKey));
}

Json findingJson(const Finding& finding) {
  Json json{{"code", name(finding.reason)}};
  if (finding.value) json["value"] = jsonNumber(*finding.value);
  if (!finding.motions.empty()) json["weak_motions"] = motionsJson(finding.motions);
  return json;
}

Finding findingFrom(const JsonFields& fields) {
  Finding finding;
  finding.reason = fields.named("code", kLastVerdictReason);
  if (fields.has("value")) finding.value = fields.number("value");
  if (fields.has("weak_motions")) finding.motions = motionsFrom(fields);
  return finding;
}

Json scoreJson(const PositionScore& s) {
  Json json{{"position", s.position},
            {"void_mm2", jsonNumber(s.voidArea)},
            {"overlap_mm2", jsonNumber(s.overlapArea)},
            {"weak_motions", motionsJson(s.weakMotions)},
            {"constraint", name(s.constraint)},
            {"short_by", jsonNumber(s.shortBy)}};
  if (s.tracedVoidArea) json["traced_void_mm2"] = jsonNumber(*s.tracedVoidArea);
  if (s.poseSigma) json["pose_sigma_mm"] = jsonNumber(*s.poseSigma);
  return json;
}

PositionScore scoreFrom(const JsonFields& fields) {
  PositionScore s;
  s.position = fields.integer("position");
  s.voidArea = fields.number("void_mm2");
  s.overlapArea = fields.number("overlap_mm2");
  if (fields.has("traced_void_mm2")) s.tracedVoidArea = fields.number("traced_void_mm2");
  if (fields.has("pose_sigma_mm")) s.poseSigma = fields.number("pose_sigma_mm");
  s.weakMotions = motionsFrom(fields, "worst_direction");
  s.constraint = fields.named("constraint", Constraint::PoseUncertain);
  s.shortBy = fields.number("short_by");
  return s;
}

// With the patches that the position would see.
Json predictionJson(const PositionScore& score) {
  Json json = scoreJson(score);
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

Json stabilityJson(const Stability& s) {
  return {{"centre", numberList(s.centre, 3)},
          {"radius_mm", jsonNumber(s.radius)},
          {"information", numberList(s.information.reshaped(), 36)},
          {"eigenvalues", numberList(s.eigenvalues, 6)},
          {"weak_direction", numberList(s.weakDirection, 6)},
          {"weak_motions", motionsJson(s.weakMotions)},
          {"pose_sigma_mm", jsonNumber(s.poseSigma)}};
}

Stability stabilityFrom(const JsonFields& fields) {
  Stability s;
  fields.numbers("centre", s.centre.data(), 3);
  s.radius = fields.number("radius_mm");
  fields.numbers("information", s.information.data(), 36);
  fields.numbers("eigenvalues", s.eigenvalues.data(), 6);
  fields.numbers("weak_direction", s.weakDirection.data(), 6);
  s.weakMotions = motionsFrom(fields, "weak_name");
  s.poseSigma = fields.number("pose_sigma_mm");
  return s;
}

Json registrationJson(const RegistrationResult& r) {
  return {{"pose", poseJson(r.T_object_scanner)},
          {"verdict", name(r.verdict)},
          {"reason", findingJson(r.finding)},
          {"rms_mm", jsonNumber(r.rms)},
          {"inliers", jsonNumber(r.inlierShare)},
          {"conflicts", jsonNumber(r.conflictShare)},
          {"pairs", r.pairs},
          {"iterations", r.iterations},
          {"pose_sigma_mm", jsonNumber(r.poseSigma)},
          {"stability", stabilityJson(r.stability)}};
}

RegistrationResult registrationFrom(const JsonFields& fields) {
  RegistrationResult r;
  r.T_object_scanner = poseFrom(fields, "pose");
  r.verdict = fields.named("verdict", Verdict::Failed);
  r.finding =
      fields.isText("reason") ? findingFromEarlier(fields.text("reason")) : findingFrom(fields.object("reason"));
  r.rms = fields.number("rms_mm");
  r.inlierShare = fields.number("inliers");
  r.conflictShare = fields.number("conflicts");
  r.pairs = fields.count("pairs");
  r.iterations = fields.integer("iterations");
  r.poseSigma = fields.number("pose_sigma_mm");
  r.stability = stabilityFrom(fields.object("stability"));
  return r;
}

Json json(const ChangeSettings& c) {
  return settingsJson(c.settings);
}
Json json(const AddScan& c) {
  Json json{{"scan", c.scan}};
  if (c.predicted) json["predicted"] = predictionJson(*c.predicted);
  return json;
}
Json json(const ImportScans& c) {
  return {{"scans", c.scans}};
}
// -1 is no position, as in the files of all versions.
Json json(const ChoosePosition& c) {
  return {{"position", c.position.value_or(-1)}};
}
Json json(const LeaveOutView& c) {
  return {{"scan", c.scan}};
}
Json json(const TakeBackView& c) {
  return {{"scan", c.scan}};
}
Json json(const Finish& c) {
  return {{"termination", name(c.termination)}};
}
Json json(const TakeOver& /*c*/) {
  return Json::object();
}
Json json(const TurnObject& c) {
  return {{"T_object_table", standPoseJson(c.T_object_table)}};
}
Json json(const PlaceStand& c) {
  return {{"stand", c.stand}, {"T_object_table", poseJson(c.T_object_table)}};
}
Json json(const ChangeMode& c) {
  return {{"mode", name(c.mode)}};
}

std::int64_t scanOf(const JsonFields& fields) {
  return fields.integer("scan", 0, std::numeric_limits<std::int64_t>::max());
}

AddScan addScanFrom(const JsonFields& fields) {
  AddScan command{scanOf(fields), {}};
  if (fields.has("predicted")) command.predicted = predictionFrom(fields.object("predicted"));
  return command;
}

ChoosePosition choosePositionFrom(const JsonFields& fields) {
  const int position = fields.integer("position");
  return {position < 0 ? std::nullopt : std::optional(position)};
}

PlaceStand placeStandFrom(const JsonFields& fields, const Json& json) {
  const auto pose = standPoseFrom(fields, json, "T_object_table");
  if (!pose) fields.fail("T_object_table");
  return {fields.integer("stand"), *pose};
}

ImportScans importScansFrom(const JsonFields& fields) {
  ImportScans command;
  for (const Json& scan : fields.list("scans")) {
    if (!scan.is_number_unsigned()) fields.fail("scans");
    command.scans.push_back(scan.get<std::int64_t>());
  }
  return command;
}

}  // namespace

std::string settingsText(const AcquisitionSettings& settings) {
  return settingsJson(settings).dump(-1, ' ', false, Json::error_handler_t::replace);
}

AcquisitionSettings settingsFromText(const std::string& text, const std::string& what) {
  return settingsFromJson(jsonObject(text, what), what);
}

std::string commandText(const Command& command) {
  return std::visit([](const auto& c) { return json(c).dump(-1, ' ', false, Json::error_handler_t::replace); },
                    command);
}

Command commandFromText(std::string_view kind, const std::string& text, const std::string& what) {
  const Json json = jsonObject(text, what);
  const JsonFields fields(json, what);
  if (kind == "change_settings") return ChangeSettings{settingsFromJson(json, what)};
  if (kind == "add_scan") return addScanFrom(fields);
  if (kind == "import_scans") return importScansFrom(fields);
  if (kind == "choose_position") return choosePositionFrom(fields);
  if (kind == "leave_out") return LeaveOutView{scanOf(fields)};
  if (kind == "take_back") return TakeBackView{scanOf(fields)};
  if (kind == "finish") return Finish{fields.named("termination", kLastTermination)};
  if (kind == "take_over") return TakeOver{};
  if (kind == "turn_object") return TurnObject{standPoseFrom(fields, json, "T_object_table")};
  if (kind == "place_stand") return placeStandFrom(fields, json);
  if (kind == "change_mode") return ChangeMode{fields.named("mode", kLastMode)};
  throw InvalidInput(what + " is damaged: its kind of command is not known");
}

std::string standsText(const std::vector<Stand>& stands) {
  Json list = Json::array();
  for (const Stand& stand : stands) list.push_back({{"T_object_table", standPoseJson(stand.T_object_table)}});
  return Json{{"stands", std::move(list)}}.dump();
}

std::vector<Stand> standsFromText(const std::string& text, const std::string& what) {
  const Json json = jsonObject(text, what);
  const JsonFields fields(json, what);
  std::vector<Stand> stands;
  for (const Json& stand : fields.list("stands"))
    stands.push_back({standPoseFrom({stand, what}, stand, "T_object_table")});
  if (stands.empty()) fields.fail("stands");
  return stands;
}

std::string recordText(const OutlinedScan& scan) {
  const ScanRecord& r = *scan.record;
  Json json{{"scan", scan.scan},
            {"stand", scan.station.stand},
            {"position", scan.station.position.value_or(-1)},
            {"samples", r.samples},
            {"triangles", r.triangles},
            {"registration", registrationJson(r.registration)},
            {"new_area_mm2", jsonNumber(r.newArea)},
            {"overlap_mm2", jsonNumber(r.overlapArea)},
            {"seconds", Json::object()}};
  for (const auto& [phase, seconds] : r.seconds) json["seconds"][std::string(name(phase))] = seconds;
  if (r.predicted) json["predicted"] = predictionJson(*r.predicted);
  return json.dump();
}

ScanRecord recordFromText(const std::string& text, const std::string& what) {
  const Json json = jsonObject(text, what);
  const JsonFields fields(json, what);
  ScanRecord r;
  r.samples = fields.count("samples");
  r.triangles = fields.count("triangles");
  r.registration = registrationFrom(fields.object("registration"));
  r.newArea = fields.number("new_area_mm2");
  r.overlapArea = fields.number("overlap_mm2");
  if (fields.has("predicted")) r.predicted = predictionFrom(fields.object("predicted"));
  if (!fields.has("seconds") || !json["seconds"].is_object()) fields.fail("seconds");
  for (const auto& [step, seconds] : json["seconds"].items())
    if (const auto phase = phaseFromEarlier(step); phase && seconds.is_number())
      r.seconds[*phase] += seconds.get<double>();
  return r;
}

std::string planText(const Plan& plan) {
  Json json{{"outcome", name(plan.outcome)},
            {"position", plan.position.value_or(-1)},
            {"least_overlap_mm2", jsonNumber(plan.leastOverlap)},
            {"termination_threshold_mm2", jsonNumber(plan.terminationThreshold)},
            {"void_left_mm2", jsonNumber(plan.voidLeft)},
            {"relaxations", plan.relaxations},
            {"angular_error_rad", jsonNumber(plan.angularError)},
            {"scores", Json::array()}};
  for (const PositionScore& score : plan.scores) json["scores"].push_back(scoreJson(score));
  return json.dump();
}

Plan planFromText(const std::string& text, const std::string& what) {
  const Json json = jsonObject(text, what);
  const JsonFields fields(json, what);
  Plan plan;
  plan.outcome = fields.named("outcome", PlanOutcome::NoOverlap);
  plan.leastOverlap = fields.number("least_overlap_mm2");
  plan.terminationThreshold = fields.number("termination_threshold_mm2");
  plan.voidLeft = fields.number("void_left_mm2");
  plan.relaxations = fields.integer("relaxations");
  plan.angularError = fields.number("angular_error_rad");
  for (const Json& score : fields.list("scores")) {
    plan.scores.push_back(scoreFrom({score, what}));
    if (plan.scores.back().position != static_cast<int>(plan.scores.size()) - 1) fields.fail("scores");
  }
  const auto positions = static_cast<std::int64_t>(plan.scores.size());
  const bool found = plan.outcome == PlanOutcome::Found;
  const auto position = fields.integer("position", found ? 0 : -1, found ? positions - 1 : positions);
  if (position >= 0) plan.position = static_cast<int>(position);
  return plan;
}

namespace {

template <typename Enum>
Enum byName(std::string_view text, Enum last, const std::string& what, const char* field) {
  for (int i = 0; i <= static_cast<int>(last); ++i)
    if (name(static_cast<Enum>(i)) == text) return static_cast<Enum>(i);
  throw InvalidInput(what + " is damaged: its " + field + " is not known");
}

}  // namespace

Termination terminationFromName(std::string_view text, const std::string& what) {
  return byName(text, kLastTermination, what, "termination");
}

Mode modeFromName(std::string_view text, const std::string& what) {
  return byName(text, kLastMode, what, "mode");
}

ScanStatus scanStatusFromName(std::string_view text, const std::string& what) {
  return byName(text, kLastScanStatus, what, "status");
}

PoseSource poseSourceFromName(std::string_view text, const std::string& what) {
  return byName(text, PoseSource::ByHand, what, "source of the pose");
}

}  // namespace vantage
