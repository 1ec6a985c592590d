#include <memory>

#include "acquisition/acquisition.h"
#include "acquisition/other_turn.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/reading_arguments.h"
#include "cli/session_run.h"
#include "cli/settings_arguments.h"
#include "cli/text.h"
#include "io/recorded_scans.h"
#include "positional_space/scanner_images_cache.h"
#include "program/user_folders.h"
#include "report/report.h"
#include "session/reading_json.h"

namespace vantage {
namespace {

struct StepArguments {
  std::string session;
  std::string range;
  int position = 0;
  ReadingArguments reading;
  SettingsArguments given;
};

// The scan as the session's scanner takes it at that position.
ReadScan readScan(const StepArguments& args, const Session& session, const Progress& progress) {
  const auto profile = session.profile();
  if (!profile) throw InvalidInput(args.session + ": has no scanner profile, so no positions to scan from");
  if (args.position >= static_cast<int>(profile->workspace.size()))
    throw InvalidInput("--position is " + std::to_string(args.position) + ", the workspace has positions 0 to " +
                       std::to_string(profile->workspace.size() - 1));
  return readScanAt(args.range, *profile, args.position, args.reading.options(), progress);
}

nlohmann::ordered_json stepJson(const AcquisitionState& state) {
  const KeptScan& scan = state.scans.back();
  return {{"added", scan.status == ScanStatus::In},
          {"status", name(scan.status)},
          {"views", countScans(state, ScanStatus::In)},
          {"registration", registrationJson(scan.record.registration)},
          {"scan", scan.number},
          {"fits_at_deg", turnsThatFit(state, scan)},
          {"next_position", nextPosition(state).value_or(-1)},
          {"state", name(state.termination)},
          {"model", modelJson(state.model ? state.model->mesh : Mesh{})}};
}

// How a scan that fits elsewhere is taken from there.
std::string wayOn(const std::string& session, const AcquisitionState& state) {
  const KeptScan& scan = state.scans.back();
  std::string text;
  for (const double turn : turnsThatFit(state, scan))
    text += "if the table stood at " + number(turn, 1) + " degrees: vantage-cli take " + session + " --scan " +
            std::to_string(scan.number) + " --table-deg " + number(turn, 1) + "\n";
  return text;
}

void runStep(const StepArguments& args, CommandContext& context) {
  Session session = openSession(args.session, SessionAccess::Write, context);
  if (!args.given.empty()) changeSettings(session, args.given.appliedToSession(session.state()->settings), context);
  const Progress progress = context.progress();
  ReadScan scan = readScan(args, session, progress.part(0.0, 0.1, "read scan"));
  requireSaidUnit({args.range}, {scan});
  const auto images = std::make_shared<const ScannerImages>(loadScannerImages(
      *session.profile(), cacheDirectory(), progress.part(0.1, 0.2, "positional space of the scanner")));
  Acquisition acquisition(session, {{}, images});
  acquisition.addScan(std::move(scan.image), progress.part(0.2, 1.0));

  const auto after = session.state();
  const std::optional<int> next = nextPosition(*after);
  const std::string then = next ? "next best view: position " + std::to_string(*next)
                                : "nothing is left to scan: " + std::string(name(after->termination));
  auto json = stepJson(*after);
  json["reading"] = readingJson(scan.reading);
  context.result(
      json,
      readingLines({args.range}, {scan}) + lastScanLine(*after) + "\n" + wayOn(args.session, *after) + then + "\n",
      warningsOf(*after, after->scans.size() - 1));
}

}  // namespace

void addStepCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<StepArguments>();
  CLI::App* command = app.add_subcommand("step", "Add one scan of the session's scanner: register, integrate, plan");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--range", args->range, "Range file with the rays of the session's scanner")->required();
  command->add_option("--position", args->position, "Position of the workspace that it was taken from")
      ->required()
      ->check(CLI::NonNegativeNumber);
  args->reading.addTo(*command);
  args->given.addTo(*command);
  context.addCommonOptions(*command);
  command->callback([args, &context] { runStep(*args, context); });
}

}  // namespace vantage
