#include <filesystem>
#include <memory>

#include "acquisition/acquisition.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/import_result.h"
#include "cli/new_session.h"
#include "cli/open_session.h"
#include "cli/person_at_table.h"
#include "cli/reading_arguments.h"
#include "cli/rig_arguments.h"
#include "cli/session_run.h"
#include "cli/settings_arguments.h"
#include "session/import_note.h"
#include "session/table_note.h"

namespace vantage {
namespace {

struct ResumeArguments {
  std::string session;
  std::string out;
  RigArguments rig;
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
void runDevices(Session& session, const ResumeArguments& args, const std::string& out, CommandContext& context) {
  const RigFile file = args.rig.described();
  const AcquisitionSettings& settings = session.state()->settings;
  if (!args.rig.given() && settings.simulation.object.empty())
    throw InvalidInput(session.path() +
                       ": was not scanned by the simulated scanner: say with --sensor and --table, or "
                       "--rig, what is there to go on with");
  const bool simulated = isSimulated(file.rig);
  const bool byHand = std::holds_alternative<HandTableDevice>(file.rig.table);
  const TableLeft table = tableLeft(session).value_or(TableLeft{});
  PersonAtTable person(session.profile(), table.stand.position, args.events, context);
  HandTable::AskPerson ask;
  if (byHand) ask = [&](int position, const Progress& progress) { person.ask(position, progress); };
  DeviceSetUp devices = RealDevices{file.rig, session.profile(), ask, args.reading.options(), table.stand};
  if (simulated) {
    const auto object = std::make_shared<const Mesh>(session.object(context.progress()));
    devices = Simulated{object, session.profile(), {settings.simulation.seed, settings.simulation.ideal}, ask};
  }
  if (table.underWayTo && std::holds_alternative<SerialTableDevice>(file.rig.table))
    context.note("the table was left in a move from position " + std::to_string(table.stand.position) +
                 " to position " + std::to_string(*table.underWayTo) +
                 ", so it is taken to stand at the first; where it really stands, the next scan that fits will tell");
  SessionRun(session, out, context).run(devices, byHand || args.events ? &person : nullptr);
}

void run(const ResumeArguments& args, CommandContext& context) {
  Session session = openSession(args.session, SessionAccess::Write, context);
  const auto import = interruptedImport(session);
  if (import && !args.out.empty())
    throw InvalidInput("--out is for acquisitions: an import writes into its session, export writes the model");
  if (!args.given.empty()) changeSettings(session, args.given.appliedToSession(session.state()->settings), context);
  if (import) return finishImport(session, *import, context);
  if (!session.profile())
    throw InvalidInput(
        args.session +
        ": has no scanner profile, so nothing can be scanned: it is of recorded scans, or the profile was "
        "lost");
  const std::string beside = std::filesystem::absolute(args.session).parent_path().string();
  const std::string out = args.out.empty() ? beside : args.out;
  AcquisitionResults(out).mustBeReplaceable({session.state()->settings.simulation.object});
  NewFolder folder(out);
  runDevices(session, args, out, context);
  folder.keep();
}

}  // namespace

void addResumeCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<ResumeArguments>();
  CLI::App* command =
      app.add_subcommand("resume", "Go on with an interrupted import, or with an acquisition, with the devices named");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--out", args->out, "Folder for model and report; beside the session when not given");
  args->rig.addDevicesTo(*command);
  command->add_flag("--events", args->events,
                    "Say what goes on as JSON lines on standard output, for a program that turns the table");
  args->reading.addTo(*command);
  args->given.addTo(*command);
  args->given.addShorthand(*command, "--max-views", "max_views");
  args->given.addShorthand(*command, "--tolerance", "planner.tolerance");
  context.addCommonOptions(*command);
  command->callback([args, &context] { run(*args, context); });
}

}  // namespace vantage
