#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "base/errors.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/picture_arguments.h"
#include "cli/text.h"
#include "io/output_file.h"
#include "program/installed_files.h"
#include "program/version.h"
#include "report/html_report.h"

// `render` and `report` of a program without OpenGL: another program draws.
namespace vantage {
namespace {

constexpr const char* kPictures = "vantage-pictures";
constexpr const char* kNotHere =
    "the program that draws pictures, vantage-pictures, is not installed; it comes with the window (package vantage)";

// This process goes on as that program, with the same arguments.
[[noreturn]] void goOnAs(const std::filesystem::path& program, const CommandContext& context) {
  std::string name = program.string();
  std::vector<std::string> arguments = context.arguments();
  std::vector<char*> pointers{name.data()};
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  ::execv(name.c_str(), pointers.data());
  throw IoError(name, std::string("cannot be started: ") + std::strerror(errno));
}

void reportWithoutPictures(const ReportArguments& args, CommandContext& context) {
  checkOutput(args.out, OutputKind::Report, std::vector{args.session});
  const auto state = readObject(args.session, context);
  HtmlReportOptions options;
  options.version = programVersion();
  writeTextFile(args.out, makeHtmlReport(*state, options));
  const std::size_t views = countScans(*state, ScanStatus::In);
  context.result({{"file", args.out}, {"views", views}}, args.out + ": report of " + std::to_string(views) + " views\n",
                 std::vector{Remark{"no_pictures", std::string("the report has no pictures: ") + kNotHere, {}, false}});
}

}  // namespace

void addRenderCommand(CLI::App& app, CommandContext& context) {
  const auto args = std::make_shared<RenderArguments>();
  CLI::App* command = args->addTo(app);
  context.addCommonOptions(*command);
  command->callback([args, &context] {
    const auto program = helperProgram(kPictures);
    if (!program) {
      checkOutput(args->out, OutputKind::Picture, std::vector{args->session});
      throw IoError(args->out, std::string("cannot be drawn: ") + kNotHere);
    }
    goOnAs(*program, context);
  });
}

void addReportCommand(CLI::App& app, CommandContext& context) {
  const auto args = std::make_shared<ReportArguments>();
  CLI::App* command = args->addTo(app);
  context.addCommonOptions(*command);
  command->callback([args, &context] {
    if (const auto program = helperProgram(kPictures)) goOnAs(*program, context);
    reportWithoutPictures(*args, context);
  });
}

}  // namespace vantage
