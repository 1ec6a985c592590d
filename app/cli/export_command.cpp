#include <memory>

#include "acquisition/report.h"
#include "acquisition/session_file.h"
#include "base/errors.h"
#include "cli/command.h"
#include "io/mesh_writer.h"

namespace vantage {
namespace {

struct ExportArguments {
  std::string session;
  std::string out;
};

void run(const ExportArguments& args, CommandContext& context) {
  const Session session = SessionFile::open(args.session).load(context.progress().part(0.0, 0.5, "read session"));
  if (!session.state.model) throw InvalidInput(args.session + ": has no model yet, expected at least one view");
  exportModel(*session.state.model, args.out, context.progress().part(0.5, 1.0, "write model"));
  const auto model = modelJson(session.state.model->mesh);
  context.result({{"file", args.out}, {"model", model}}, args.out + ": " + model["triangles"].dump() + " triangles\n");
}

}  // namespace

void addExportCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Write a session's model as PLY, STL or OBJ, by the extension");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--out", args->out, "File to write: .ply, .stl or .obj")->required();
  context.addCommonOptions(*command);
  command->callback([args, &context] { run(*args, context); });
}

}  // namespace vantage
