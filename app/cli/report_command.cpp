#include <memory>

#include "acquisition/html_report.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/text.h"
#include "report_pictures.h"

namespace vantage {
namespace {

struct ReportArguments {
  std::string session;
  std::string out;
};

void run(const ReportArguments& args, CommandContext& context) {
  const auto state = readSession(args.session, context);
  HtmlReportOptions options;
  options.version = VANTAGE_VERSION;
  options.viewPictures = scanPictures(*state);
  writeTextFile(args.out, makeHtmlReport(*state, options));
  context.result({{"file", args.out}, {"views", state->views.size()}},
                 args.out + ": report of " + std::to_string(state->views.size()) + " views\n");
}

}  // namespace

void addReportCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand("report", "Write the report of a session as one HTML page with pictures");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--out", args->out, "HTML file to write")->required();
  context.addCommonOptions(*command);
  command->callback([args, &context] { run(*args, context); });
}

}  // namespace vantage
