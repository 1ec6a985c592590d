#include "cli/import_result.h"

#include "acquisition/import_scans.h"
#include "acquisition/step_options.h"
#include "cli/text.h"
#include "report/report.h"
#include "report/warnings.h"
#include "report/wording.h"
#include "session/reading_json.h"
#include "void_space/void_patch_builder.h"

namespace vantage {
namespace {

nlohmann::ordered_json scanJson(const KeptScan& scan, const std::string& label) {
  const RegistrationResult& registration = scan.record.registration;
  nlohmann::ordered_json json{{"file", label},
                              {"verdict", name(registration.verdict)},
                              {"reason", describe(registration.finding)},
                              {"reason_code", name(registration.finding.reason)},
                              {"rms_mm", registration.rms},
                              {"inliers", registration.inlierShare}};
  if (scan.record.everyNth > 1) json["worked_on"] = {{"every_nth_row_and_column", scan.record.everyNth}};
  if (scan.record.reading) json["reading"] = readingJson(*scan.record.reading);
  return json;
}

nlohmann::ordered_json importJson(const ImportNames& names, const AcquisitionState& state, const VoidSurface& voids) {
  nlohmann::ordered_json json{{"session", names.session}, {"scans", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < state.scans.size(); ++i)
    json["scans"].push_back(scanJson(state.scans[i], names.labels[i]));
  if (const auto fault = poseListFault(state)) {
    const Finding finding = findingOf(*fault);
    json["pose_list"] = {{"reason", describe(finding)}, {"reason_code", name(finding.reason)}, {"value", fault->value}};
  }
  json["model"] = modelJson(state.model->mesh);
  double length = 0.0;
  for (const VoidPatch& patch : voids.patches) length += patch.width;
  json["void"] = voidCountsJson(voids);
  json["void"]["length_mm"] = length;
  return json;
}

}  // namespace

void announceImport(const ImportNames& names, const AcquisitionState& state, CommandContext& context,
                    const Progress& progress) {
  const VoidSurface voids = buildVoidPatches(*state.model, viewsOf(state), importOptionsFor(state).voidSpace,
                                             progress.part(0.0, 1.0, "void_patches"));
  const auto json = importJson(names, state, voids);
  std::string text = names.readLines;
  for (const auto& scan : json["scans"])
    text += scan["file"].get<std::string>() + ": " + scan["verdict"].get<std::string>() + ", " +
            number(scan["rms_mm"].get<double>(), 3) + " mm, " + scan["reason"].get<std::string>() + "\n";
  for (const KeptScan& scan : state.scans) {
    if (scan.record.everyNth <= 1) continue;
    text += "worked on: " + thinningText(scan.record.everyNth) +
            " of scans with very many rays; the session has them " +
            "whole (all are worked on with --set triangulation.spacing=0)\n";
    break;
  }
  if (json.contains("pose_list"))
    text += "pose list: " + json["pose_list"]["reason"].get<std::string>() +
            "; correct the list and import again to be sure of every scan\n";
  text += "model: " + json["model"]["triangles"].dump() + " triangles, " + json["model"]["boundary_edges"].dump() +
          " boundary edges, " + json["model"]["non_manifold_edges"].dump() +
          " non-manifold\nstill void: " + std::to_string(voids.patches.size()) + " patches along " +
          number(json["void"]["length_mm"].get<double>(), 0) + " mm of boundary\nwritten: " + names.session + "\n";
  context.result(json, text, warningsOf(state));
}

}  // namespace vantage
