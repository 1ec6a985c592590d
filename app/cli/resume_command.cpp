#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "acquisition/acquisition.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/device_run.h"
#include "cli/import_result.h"
#include "cli/new_session.h"
#include "cli/open_session.h"
#include "cli/reading_arguments.h"
#include "cli/rig_arguments.h"
#include "cli/session_run.h"
#include "cli/settings_arguments.h"
#include "session/import_note.h"

namespace vantage {
namespace {

struct ResumeArguments {
  std::string session;
  std::string out;
  RigArguments rig;
  std::vector<int> positions;
  bool events = false;
  ReadingArguments reading;
  SettingsArguments given;
};

// Goes on with an import whose scans were all kept.
void finishImport(Session& session, const ImportScans& import, CommandContext& context) {
  std::vector<std::string> labels;
  for (const std::int64_t scan : import.scans) labels.push_back("scan " + std::to_string(scan));
  const Progress progress = context.progress();
  Acquisition(session).carryOut(import, progress.part(0.0, 0.9));
  announceImport({session.path(), labels, {}}, *session.state(), context, progress.part(0.9, 1.0));
}

// Goes on with the devices that were named; with the simulated ones that the session was begun with otherwise.
void goOn(Session& session, const ResumeArguments& args, const std::string& out, CommandContext& context) {
  const RigFile file = args.rig.described();
  if (!args.rig.given() && session.state()->settings.simulation.object.empty())
    throw InvalidInput(session.path() +
                       ": was not scanned by the simulated scanner: say with --sensor and --table, or "
                       "--rig, what is there to go on with");
  DeviceRun with{file.rig, nullptr, args.reading.options(), args.events, {}, args.positions};
  if (isSimulated(file.rig)) with.object = std::make_shared<const Mesh>(session.object(context.progress()));
  runDevices(session, with, out, context);
}

void checkPositions(const ResumeArguments& args, const ScannerProfile& profile) {
  const auto count = static_cast<int>(profile.workspace.size());
  for (const int position : args.positions)
    if (position < 0 || position >= count)
      throw InvalidInput("--positions names position " + std::to_string(position) +
                         ", the workspace has positions 0 to " + std::to_string(count - 1));
}

void runResume(const ResumeArguments& args, CommandContext& context) {
  Session session = openSession(args.session, SessionAccess::Write, context);
  const auto import = interruptedImport(session);
  if (import && !args.out.empty())
    throw InvalidInput("--out is for acquisitions: an import writes into its session, export writes the model");
  if (import && !args.positions.empty())
    throw InvalidInput("--positions is for acquisitions: an import was interrupted, and its scans were all taken");
  if (!args.given.empty()) changeSettings(session, args.given.appliedToSession(session.state()->settings), context);
  const AcquisitionState& state = *session.state();
  const std::size_t scans = import ? import->scans.size() - 1 : state.scans.size();
  if (const auto profile = session.profile()) tellMemoryNeeded(profile->rays->size(), state.settings, scans, context);
  if (import) return finishImport(session, *import, context);
  if (!session.profile())
    throw InvalidInput(
        args.session +
        ": has no scanner profile, so nothing can be scanned: it is of recorded scans, or the profile was "
        "lost");
  checkPositions(args, *session.profile());
  const std::string beside = std::filesystem::absolute(args.session).parent_path().string();
  const std::string out = args.out.empty() ? beside : args.out;
  AcquisitionResults(out).mustBeReplaceable({session.state()->settings.simulation.object});
  NewFolder folder(out);
  goOn(session, args, out, context);
  folder.keep();
}

}  // namespace

void addResumeCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<ResumeArguments>();
  CLI::App* command =
      app.add_subcommand("resume", "Go on with an interrupted import, or with an acquisition, with the devices named");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--out", args->out, "Folder for model and report; beside the session when not given");
  command
      ->add_option("--positions", args->positions,
                   "Scan from these positions and no others, in this order, whatever the plan says; also after the end")
      ->delimiter(',');
  args->rig.addDevicesTo(*command);
  command->add_flag("--events", args->events,
                    "Say what goes on as JSON lines on standard output, for a program that turns the table");
  args->reading.addTo(*command);
  args->given.addTo(*command);
  args->given.addShorthand(*command, "--max-views", "max_views");
  args->given.addShorthand(*command, "--tolerance", "planner.tolerance");
  context.addCommonOptions(*command);
  command->callback([args, &context] { runResume(*args, context); });
}

}  // namespace vantage
