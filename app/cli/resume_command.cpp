#include <filesystem>
#include <memory>

#include "cli/command.h"
#include "cli/new_session.h"
#include "cli/open_session.h"
#include "cli/session_run.h"
#include "cli/settings_arguments.h"

namespace vantage {
namespace {

struct ResumeArguments {
  std::string session;
  std::string out;
  SettingsArguments given;
};

void run(const ResumeArguments& args, CommandContext& context) {
  Session session = openSession(args.session, SessionAccess::Write, context);
  if (!args.given.empty()) changeSettings(session, args.given.appliedToSession(session.state()->settings), context);
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
  CLI::App* command =
      app.add_subcommand("resume", "Go on with an interrupted acquisition before the simulated scanner");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--out", args->out, "Folder for model and report; beside the session when not given");
  args->given.addTo(*command);
  args->given.addShorthand(*command, "--max-views", "max_views");
  args->given.addShorthand(*command, "--tolerance", "planner.tolerance");
  context.addCommonOptions(*command);
  command->callback([args, &context] { run(*args, context); });
}

}  // namespace vantage
