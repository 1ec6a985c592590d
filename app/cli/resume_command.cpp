#include <filesystem>
#include <memory>

#include "acquisition/acquisition.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/import_result.h"
#include "cli/new_session.h"
#include "cli/open_session.h"
#include "cli/session_run.h"
#include "cli/settings_arguments.h"
#include "session/import_note.h"

namespace vantage {
namespace {

struct ResumeArguments {
  std::string session;
  std::string out;
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
  const auto object = std::make_shared<const Mesh>(session.object(context.progress()));
  const std::string beside = std::filesystem::absolute(args.session).parent_path().string();
  const std::string out = args.out.empty() ? beside : args.out;
  AcquisitionResults(out).mustBeReplaceable({session.state()->settings.simulation.object});
  NewFolder folder(out);
  SessionRun(session, out, context).run(object);
  folder.keep();
}

}  // namespace

void addResumeCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<ResumeArguments>();
  CLI::App* command = app.add_subcommand(
      "resume", "Go on with an interrupted import, or with an acquisition before the simulated scanner");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--out", args->out, "Folder for model and report; beside the session when not given");
  args->given.addTo(*command);
  args->given.addShorthand(*command, "--max-views", "max_views");
  args->given.addShorthand(*command, "--tolerance", "planner.tolerance");
  context.addCommonOptions(*command);
  command->callback([args, &context] { run(*args, context); });
}

}  // namespace vantage
