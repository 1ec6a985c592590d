#include <memory>
#include <string>

#include "cli/command.h"
#include "cli/open_session.h"
#include "geometry/measures.h"
#include "io/mesh_writer.h"
#include "io/output_file.h"
#include "report/report.h"

namespace vantage {
namespace {

struct ExportArguments {
  std::string session;
  std::string out;
};

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// An open model encloses no volume: it can be looked at and measured, but not be printed as it is.
std::string opennessOf(const MeshMeasures& measures) {
  const std::string pieces = " in " + counted(measures.components, "piece");
  return measures.boundaryLoops == 0 ? "closed" + pieces
                                     : "open: " + counted(measures.boundaryLoops, "opening") + pieces;
}

void run(const ExportArguments& args, CommandContext& context) {
  checkOutput(args.out, OutputKind::Mesh, std::vector{args.session});
  const auto read = readSessionModel(args.session, context);
  exportModel(*read, args.out, context.progress().part(0.5, 1.0, "write model"));
  const auto model = modelJson(read->mesh);
  const MeshMeasures measures = measure(read->mesh);
  context.result(
      {{"file", args.out}, {"model", model}, {"openings", measures.boundaryLoops}, {"pieces", measures.components}},
      args.out + ": " + model["triangles"].dump() + " triangles, " + opennessOf(measures) + "\n");
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
