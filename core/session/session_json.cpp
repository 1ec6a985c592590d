#include "session/session_json.h"

#include <limits>
#include <utility>

#include "acquisition/settings_json.h"
#include "session/earlier_wording.h"
#include "session/json_fields.h"
#include "session/reading_json.h"
#include "session/stand_json.h"
#include "session/value_json.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

Json findingJson(const Finding& finding) {
  Json json{{"code", name(finding.reason)}};
  if (finding.value) json["value"] = jsonNumber(*finding.value);
  if (!finding.motions.empty()) json["weak_motions"] = motionsJson(finding.motions);
  for (const double rival : finding.rivals) json["rivals"].push_back(jsonNumber(rival));
  return json;
}

Finding findingFrom(const JsonFields& fields) {
  Finding finding;
  finding.reason = fields.named("code", kLastVerdictReason);
  if (fields.has("value")) finding.value = fields.number("value");
  if (fields.has("weak_motions")) finding.motions = motionsFrom(fields);
  if (fields.has("rivals")) {
    for (const Json& rival : fields.list("rivals")) {
      if (!rival.is_number()) fields.fail("rivals");
      finding.rivals.push_back(rival.get<double>());
    }
  }
  return finding;
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

}  // namespace

std::string settingsText(const AcquisitionSettings& settings) {
  return settingsJson(settings).dump(-1, ' ', false, Json::error_handler_t::replace);
}

AcquisitionSettings settingsFromText(const std::string& text, const std::string& what) {
  return settingsFromJson(jsonObject(text, what), what);
}

std::string standsText(const std::vector<Stand>& stands, const std::vector<OutlinedModel>& aside) {
  Json list = Json::array();
  for (const Stand& stand : stands) list.push_back(standJson(stand));
  Json json{{"stands", std::move(list)}};
  for (const OutlinedModel& model : aside)
    json["aside"].push_back({{"composite", model.composite}, {"model", model.step}});
  return json.dump();
}

std::vector<Stand> standsFromText(const std::string& text, const std::string& what) {
  const Json json = jsonObject(text, what);
  const JsonFields fields(json, what);
  std::vector<Stand> stands;
  for (const Json& stand : fields.list("stands"))
    stands.push_back(standFrom(stand, static_cast<int>(stands.size()), what));
  if (stands.empty()) fields.fail("stands");
  return stands;
}

std::vector<OutlinedModel> asideFromText(const std::string& text, const std::string& what) {
  const Json json = jsonObject(text, what);
  const JsonFields fields(json, what);
  std::vector<OutlinedModel> aside;
  if (!fields.has("aside")) return aside;
  const auto last = static_cast<std::int64_t>(fields.list("stands").size()) - 1;
  for (const Json& model : fields.list("aside")) {
    const JsonFields one(model, what);
    aside.push_back({static_cast<int>(one.integer("composite", 0, last)),
                     one.integer("model", 1, std::numeric_limits<std::int64_t>::max())});
    if (aside.size() > 1 && aside.end()[-2].composite >= aside.back().composite) fields.fail("aside");
  }
  return aside;
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
  if (r.reading) json["reading"] = readingJson(*r.reading);
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
  if (fields.has("reading")) r.reading = readingFrom(fields.object("reading"));
  if (!fields.has("seconds") || !json["seconds"].is_object()) fields.fail("seconds");
  for (const auto& [step, seconds] : json["seconds"].items())
    if (const auto phase = phaseFromEarlier(step); phase && seconds.is_number())
      r.seconds[*phase] += seconds.get<double>();
  return r;
}

namespace {

Json forecastJson(const PlanForecast& forecast) {
  Json json{{"factor", jsonNumber(forecast.trust.factor)},
            {"spread", jsonNumber(forecast.trust.spread)},
            {"probing", forecast.probing}};
  if (forecast.left)
    json["left"] = {{"area_mm2", jsonNumber(forecast.left->area)},
                    {"least_mm2", jsonNumber(forecast.left->least)},
                    {"most_mm2", jsonNumber(forecast.left->most)}};
  return json;
}

PlanForecast forecastFrom(const JsonFields& fields) {
  PlanForecast forecast{{fields.number("factor"), fields.number("spread")}, {}, fields.flag("probing")};
  if (!fields.has("left")) return forecast;
  const JsonFields left = fields.object("left");
  forecast.left = SurfaceLeft{left.number("area_mm2"), left.number("least_mm2"), left.number("most_mm2")};
  return forecast;
}

}  // namespace

std::string planText(const Plan& plan) {
  Json json{{"outcome", name(plan.outcome)},
            {"position", plan.position.value_or(-1)},
            {"least_overlap_mm2", jsonNumber(plan.leastOverlap)},
            {"termination_threshold_mm2", jsonNumber(plan.terminationThreshold)},
            {"void_left_mm2", jsonNumber(plan.voidLeft)},
            {"relaxations", plan.relaxations},
            {"table_alone", plan.tableAlone},
            {"angular_error_rad", jsonNumber(plan.angularError)},
            {"scores", Json::array()}};
  if (plan.forecast) json["forecast"] = forecastJson(*plan.forecast);
  for (const PositionScore& score : plan.scores) json["scores"].push_back(storedScoreJson(score));
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
  plan.tableAlone = fields.has("table_alone") && fields.flag("table_alone");
  plan.angularError = fields.number("angular_error_rad");
  if (fields.has("forecast")) plan.forecast = forecastFrom(fields.object("forecast"));
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
