#include <memory>
#include <string>

#include "acquisition/model_colours.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/text.h"
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

// What became of the offset of scans that were far from the origin.
void addOffset(const Vec3& offset, const std::string& file, nlohmann::ordered_json& json, std::string& text) {
  if (offset.isZero(0.0)) return;
  const bool held = holdsOffset(file);
  json["offset_mm"] = {offset.x(), offset.y(), offset.z()};
  json["offset_put_back"] = held;
  text += "the offset of the scans, (" + number(offset.x(), 0) + ", " + number(offset.y(), 0) + ", " +
          number(offset.z(), 0) + ") mm, " +
          (held ? "was put back\n" : "is not in the file, whose single precision could not hold it; PLY and OBJ can\n");
}

// Whether the colours that the scans saw are in the file.
void addColours(const AcquisitionState& state, const VertexColours& colours, const std::string& file,
                nlohmann::ordered_json& json, std::string& text) {
  if (!haveColours(viewsOf(state))) return;
  const bool held = holdsColours(file);
  json["colours_written"] = held;
  if (!held) {
    text += "the colours of the scans are not in the file: STL has none; PLY and OBJ do\n";
    return;
  }
  const std::size_t grey = countColourless(colours);
  json["coloured_vertices"] = colours.size() - grey;
  json["grey_vertices"] = grey;
  text += grey == 0 ? "every vertex has a colour\n"
                    : std::to_string(colours.size() - grey) + " vertices have a colour; at the other " +
                          std::to_string(grey) + " none was measured: they are grey (128, 128, 128)\n";
}

void run(const ExportArguments& args, CommandContext& context) {
  checkOutput(args.out, OutputKind::Mesh, std::vector{args.session});
  const SessionModel read = readSessionModel(args.session, context);
  const Progress progress = context.progress();
  const VertexColours colours =
      holdsColours(args.out) ? coloursOf(*read.state, progress.part(0.3, 0.5, "colour model")) : VertexColours{};
  exportModel(*read.model, args.out, progress.part(0.5, 1.0, "write model"), read.offset, colours);
  const auto model = modelJson(read.model->mesh);
  const MeshMeasures measures = measure(read.model->mesh);
  nlohmann::ordered_json json{
      {"file", args.out}, {"model", model}, {"openings", measures.boundaryLoops}, {"pieces", measures.components}};
  std::string text = args.out + ": " + model["triangles"].dump() + " triangles, " + opennessOf(measures) + "\n";
  addOffset(read.offset, args.out, json, text);
  addColours(*read.state, colours, args.out, json, text);
  context.result(json, text);
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
