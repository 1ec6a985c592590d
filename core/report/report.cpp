#include "report/report.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "acquisition/stand_composites.h"
#include "geometry/measures.h"
#include "report/completeness.h"
#include "report/edges_left.h"
#include "report/stands_report.h"
#include "report/wording.h"
#include "session/reading_json.h"

namespace vantage {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: what nothing holds is null.
Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

// The phases of Table 2, 0 where one did not run.
Json secondsJson(const PhaseTimes& seconds) {
  Json json;
  for (int i = 0; i < kPhases; ++i) {
    const auto it = seconds.find(static_cast<Phase>(i));
    json[std::string(name(static_cast<Phase>(i)))] = it == seconds.end() ? 0.0 : it->second;
  }
  return json;
}

Json predictedJson(const PositionScore& score) {
  Json json{{"void_mm2", score.tracedVoidArea.value_or(score.voidArea)},
            {"overlap_mm2", score.overlapArea},
            {"worst_direction", describe(score.weakMotions)},
            {"pose_sigma_mm", score.poseSigma ? finite(*score.poseSigma) : Json(nullptr)}};
  if (score.uncorrected) json["uncorrected_mm2"] = *score.uncorrected;
  return json;
}

Json objectiveJson(const Plan& plan) {
  Json list = Json::array();
  for (const PositionScore& s : plan.scores)
    list.push_back({{"position", s.position}, {"void_mm2", s.voidArea}, {"overlap_mm2", s.overlapArea}});
  return list;
}

// -1 for scans of no position, as the contract has it.
int positionOf(const KeptScan& scan) {
  return scan.station().position.value_or(-1);
}

// Of a recorded scan: as what its file was read.
void addReading(Json& json, const ScanRecord& record) {
  if (record.reading) json["reading"] = readingJson(*record.reading);
}

// How many samples were left out, by reason.
void addCut(Json& json, const ScanRecord& record) {
  if (cutSamples(record.cut) == 0) return;
  for (std::size_t i = 0; i < kCutReasons; ++i) {
    const auto reason = static_cast<CutReason>(i);
    if (reason != CutReason::Kept && reason != CutReason::NoSample && record.cut[i] > 0)
      json["cut"][std::string(name(reason))] = record.cut[i];
  }
}

// What of the samples is worked on, where it is not all.
void addThinning(Json& json, const ScanRecord& record) {
  if (record.everyNth > 1) json["worked_on"] = {{"every_nth_row_and_column", record.everyNth}};
}

Json viewJson(const KeptScan& scan, std::size_t index) {
  const ScanRecord& record = scan.record;
  Json json{{"index", index},
            {"scan", scan.number},
            {"stand", scan.station().stand},
            {"position", positionOf(scan)},
            {"pose_known_by", name(scan.view.image->poseKnownBy)},
            {"samples", record.samples},
            {"triangles", record.triangles},
            {"predicted", record.predicted ? predictedJson(*record.predicted) : Json(nullptr)},
            {"achieved", {{"new_area_mm2", record.newArea}, {"overlap_mm2", record.overlapArea}}},
            {"registration", registrationJson(record.registration)}};
  addCut(json, record);
  addThinning(json, record);
  addReading(json, record);
  if (record.planAfter) {
    json["objective"] = objectiveJson(*record.planAfter);
    json["void_patches"] = voidJson(*record.planAfter);
    json["plan"] = {{"least_overlap_mm2", record.planAfter->leastOverlap},
                    {"termination_threshold_mm2", record.planAfter->terminationThreshold},
                    {"relaxations", record.planAfter->relaxations},
                    {"table_alone", record.planAfter->tableAlone},
                    {"angular_error_deg", degrees(record.planAfter->angularError)}};
    if (record.planAfter->forecast) json["plan"]["forecast"] = forecastJson(*record.planAfter->forecast);
  }
  json["seconds"] = secondsJson(record.seconds);
  return json;
}

Json otherScanJson(const KeptScan& scan) {
  Json json{{"scan", scan.number},
            {"stand", scan.station().stand},
            {"position", positionOf(scan)},
            {"registration", registrationJson(scan.record.registration)}};
  addCut(json, scan.record);
  addThinning(json, scan.record);
  addReading(json, scan.record);
  return json;
}

Json completenessJson(const AcquisitionState& state) {
  const Completeness c = completenessOf(state);
  Json json{{"scannable_covered", c.scannableCovered},
            {"whole_covered", c.wholeCovered},
            {"holes", c.holes},
            {"pieces", c.pieces},
            {"closed", c.closed}};
  if (c.erasedHoles > 0) json["erased_holes"] = c.erasedHoles;
  return json;
}

}  // namespace

nlohmann::ordered_json registrationJson(const RegistrationResult& registration) {
  return {{"verdict", name(registration.verdict)},
          {"reason", describe(registration.finding)},
          {"reason_code", name(registration.finding.reason)},
          {"rms_mm", registration.rms},
          {"inliers", registration.inlierShare},
          {"iterations", registration.iterations},
          {"pairs", registration.pairs},
          {"worst_direction", describe(registration.stability.weakMotions)},
          {"pose_sigma_mm", finite(registration.poseSigma)}};
}

nlohmann::ordered_json voidCountsJson(const VoidSurface& voids) {
  Json json;
  for (std::size_t i = 0; i < kEdgeClasses; ++i) json[std::string(name(static_cast<EdgeClass>(i)))] = voids.counts[i];
  return json;
}

nlohmann::ordered_json voidJson(const Plan& plan) {
  Json json = voidCountsJson(*plan.voids);
  json["answered"] =
      std::count_if(plan.outlook.begin(), plan.outlook.end(), [](const PatchOutlook& o) { return o.answered; });
  return json;
}

nlohmann::ordered_json forecastJson(const PlanForecast& forecast) {
  Json json{{"factor", forecast.trust.factor}, {"spread", forecast.trust.spread}, {"probing", forecast.probing}};
  if (forecast.left)
    json["left"] = {
        {"area_mm2", forecast.left->area}, {"least_mm2", forecast.left->least}, {"most_mm2", forecast.left->most}};
  return json;
}

nlohmann::ordered_json remainingJson(const Plan& plan) {
  Json list = Json::array();
  for (const EdgesLeft& left : edgesLeft(plan))
    list.push_back({{"reason", name(left.reason)}, {"edges", left.edges}, {"length_mm", left.length}});
  return list;
}

nlohmann::ordered_json scoreJson(const PositionScore& score) {
  Json json{{"position", score.position}, {"void_mm2", score.voidArea}, {"overlap_mm2", score.overlapArea}};
  if (score.tracedVoidArea) json["traced_void_mm2"] = *score.tracedVoidArea;
  if (score.poseSigma) json["pose_sigma_mm"] = finite(*score.poseSigma);
  if (!score.weakMotions.empty()) json["worst_direction"] = describe(score.weakMotions);
  json["constraint"] = name(score.constraint);
  json["short_by"] = score.shortBy;
  json["patches"] = score.patches.size();
  return json;
}

nlohmann::ordered_json modelJson(const Mesh& mesh) {
  const MeshMeasures m = measure(mesh);
  return {{"vertices", m.vertices},
          {"triangles", m.triangles},
          {"boundary_edges", m.boundaryEdges},
          {"non_manifold_edges", m.nonManifoldEdges},
          {"area_mm2", m.area}};
}

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

nlohmann::ordered_json makeReport(const AcquisitionState& given, const std::string& version) {
  const AcquisitionState state = withObject(given);
  const AcquisitionSettings& settings = state.settings;
  Json report{{"version", version},
              {"object", settings.simulation.object},
              {"placement", name(settings.simulation.placement)},
              {"profile", state.profile ? state.profile->name : ""},
              {"seed", settings.simulation.seed},
              {"strategy", name(settings.strategy)},
              {"views", Json::array()}};
  for (const KeptScan* scan : scansOf(state, ScanStatus::In))
    report["views"].push_back(viewJson(*scan, report["views"].size()));
  report["stands"] = standsJson(state);
  for (const ScanStatus status : {ScanStatus::Rejected, ScanStatus::LeftOut, ScanStatus::Waiting, ScanStatus::Aside}) {
    Json& list = report[std::string(name(status))] = Json::array();
    for (const KeptScan* scan : scansOf(state, status)) list.push_back(otherScanJson(*scan));
  }
  report["mode"] = name(state.mode);
  report["terminated_by"] = name(state.termination);
  report["remaining"] = state.plan ? remainingJson(*state.plan) : Json::array();
  report["model"] = modelJson(state.model ? state.model->mesh : Mesh{});
  report["completeness"] = completenessJson(state);
  report["peak_memory_mb"] = peakMemory();
  return report;
}

}  // namespace vantage
