#include <memory>
#include <optional>

#include "acquisition/acquisition.h"
#include "acquisition/import_scans.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/new_session.h"
#include "cli/settings_arguments.h"
#include "cli/text.h"
#include "io/range_files.h"
#include "io/scan_poses.h"
#include "report/report.h"
#include "report/wording.h"
#include "session/session_place.h"

namespace vantage {
namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string poses;
  std::string scanner = "generic";
  std::string session;
  bool replace = false;
  SettingsArguments given;
};

// The scans with the poses that the list gives them.
std::vector<RangeImage> readScans(const ImportArguments& args, const ScannerProfile* profile,
                                  const Progress& progress) {
  std::vector<RangeImage> scans;
  std::vector<ScanPose> poses;
  for (const std::string& file : args.files) {
    progress.checkpoint(static_cast<double>(scans.size()) / static_cast<double>(args.files.size()));
    if (!args.poses.empty() && poses.empty()) poses = readScanPoses(args.poses, readRangeGrid(file).scale);
    RangeImage scan = profile != nullptr ? readRangeFile(file, profile->rays) : readRangeFile(file);
    if (!args.poses.empty()) {
      const auto pose = findPose(poses, file);
      if (!pose) throw InvalidInput(args.poses + ": has no pose for " + file);
      scan.T_table_scanner = *pose;
      scan.poseKnownBy = PoseSource::Reported;
    }
    scans.push_back(std::move(scan));
  }
  return scans;
}

nlohmann::ordered_json importJson(const ImportArguments& args, const AcquisitionState& state,
                                  const VoidSurface& voids) {
  nlohmann::ordered_json json{{"session", args.session}, {"scans", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < args.files.size(); ++i) {
    const RegistrationResult& registration = state.scans[i].record.registration;
    json["scans"].push_back({{"file", args.files[i]},
                             {"verdict", name(registration.verdict)},
                             {"reason", describe(registration.finding)},
                             {"reason_code", name(registration.finding.reason)},
                             {"rms_mm", registration.rms},
                             {"inliers", registration.inlierShare}});
  }
  json["model"] = modelJson(state.model->mesh);
  double length = 0.0;
  for (const VoidPatch& patch : voids.patches) length += patch.width;
  json["void"] = voidCountsJson(voids);
  json["void"]["length_mm"] = length;
  return json;
}

void run(const ImportArguments& args, CommandContext& context) {
  checkSessionPlace(args.session, args.replace);
  std::optional<ProfileSource> source;
  std::shared_ptr<const ScannerProfile> profile;
  if (args.scanner != "generic") {
    source = readProfileSource(args.scanner);
    profile = std::make_shared<const ScannerProfile>(parseProfile(*source));
  }
  const Progress progress = context.progress();
  std::vector<RangeImage> images = readScans(args, profile.get(), progress.part(0.0, 0.1, "read scans"));
  std::shared_ptr<const AcquisitionState> state;
  workOnNewSession({args.session, args.replace, false, {source, args.given.applied({}), nullptr, profile}}, context,
                   [&](Session& session) {
                     Acquisition(session).importScans(std::move(images), progress.part(0.1, 0.9));
                     state = session.state();
                   });
  const VoidSurface voids = buildVoidPatches(*state->model, viewsOf(*state), importOptionsFor(*state).voidSpace,
                                             progress.part(0.9, 1.0, "void_patches"));

  const auto json = importJson(args, *state, voids);
  std::string text;
  for (const auto& scan : json["scans"])
    text += scan["file"].get<std::string>() + ": " + scan["verdict"].get<std::string>() + ", " +
            number(scan["rms_mm"].get<double>(), 3) + " mm, " + scan["reason"].get<std::string>() + "\n";
  text += "model: " + json["model"]["triangles"].dump() + " triangles, " + json["model"]["boundary_edges"].dump() +
          " boundary edges, " + json["model"]["non_manifold_edges"].dump() +
          " non-manifold\nstill void: " + std::to_string(voids.patches.size()) + " patches along " +
          number(json["void"]["length_mm"].get<double>(), 0) + " mm of boundary\nwritten: " + args.session + "\n";
  context.result(json, text, warningsOf(*state));
}

}  // namespace

void addImportCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<ImportArguments>();
  CLI::App* command = app.add_subcommand("import", "Register and integrate recorded scans and say what is still void");
  command->add_option("range", args->files, "PLY range files")->required();
  command->add_option("--poses", args->poses, "Stanford .conf with a rough pose for every scan");
  command->add_option("--scanner", args->scanner, "Scanner profile (JSON), or generic for parallel rays along -z")
      ->capture_default_str();
  command->add_option("--session", args->session, "Session file to write")->required();
  command->add_flag("--replace", args->replace,
                    "Replace a session of that name; it is kept aside until the new one is whole");
  args->given.addTo(*command);
  context.addCommonOptions(*command);
  command->callback([args, &context] { run(*args, context); });
}

}  // namespace vantage
