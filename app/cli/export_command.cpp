#include <memory>
#include <optional>
#include <string>

#include "acquisition/model_colours.h"
#include "cli/command.h"
#include "cli/finishing_arguments.h"
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
  FinishingArguments finishing;
};

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
    text += "the colours of the scans are not in the file; PLY and OBJ have them\n";
    return;
  }
  const std::size_t grey = countColourless(colours);
  json["coloured_vertices"] = colours.size() - grey;
  json["grey_vertices"] = grey;
  text += grey == 0 ? "every vertex has a colour\n"
                    : std::to_string(colours.size() - grey) + " vertices have a colour; at the other " +
                          std::to_string(grey) + " none was measured: they are grey (128, 128, 128)\n";
}

// With what was asked for done to it. @throws InvalidInput when it is to be printed and cannot be
FinishedModel finished(const Model& model, const ExportArguments& args, const Progress& progress) {
  FinishedModel finished = finish(model, args.finishing.options(), progress);
  if (args.finishing.printable()) requirePrintable(finished);
  return finished;
}

void runExport(const ExportArguments& args, CommandContext& context) {
  checkOutput(args.out, OutputKind::Mesh, std::vector{args.session});
  const SessionModel read = readSessionModel(args.session, context);
  const Progress progress = context.progress();
  const bool asItIs = args.finishing.options().nothing();
  std::optional<FinishedModel> made;
  if (!asItIs) made = finished(*read.model, args, progress.part(0.0, 0.3));
  const std::optional<Pose> T_out_object = args.finishing.frame();
  std::optional<Model> moved;
  if (T_out_object) {
    moved = made ? made->model : *read.model;
    moved->mesh = transformed(moved->mesh, *T_out_object);
  }
  const Model& model = moved ? *moved : made ? made->model : *read.model;
  // Axes of the object's own have nothing to do with where the scans were in the world.
  const Vec3 offset = moved ? Vec3(Vec3::Zero()) : read.offset;
  VertexColours colours =
      holdsColours(args.out) ? coloursOf(*read.state, progress.part(0.3, 0.5, "colour model")) : VertexColours{};
  if (made) colours = made->coloursOf(colours);
  const std::vector<std::uint8_t> invented = made ? made->invented() : std::vector<std::uint8_t>{};
  exportModelAs(model, args.out, {offset, colours, invented, args.finishing.unit()},
                progress.part(0.5, 1.0, "write model"));
  const auto modelSaid = modelJson(model.mesh);
  const MeshMeasures measures = measure(model.mesh);
  nlohmann::ordered_json json{{"file", args.out},
                              {"unit", name(args.finishing.unit())},
                              {"model", modelSaid},
                              {"openings", measures.boundaryLoops},
                              {"pieces", measures.components}};
  std::string text = args.out + ": " + modelSaid["triangles"].dump() + " triangles, " + opennessOf(measures) + "\n";
  if (made) {
    json["finishing"] = finishingJson(*made);
    text += finishingLines(*made);
    if (made->inventedArea > 0.0 && !holdsInvented(args.out))
      text += "the file does not tell what is invented; PLY and 3MF do\n";
  }
  if (args.finishing.unit() == LengthUnit::Inch) text += "coordinates are in inches\n";
  if (T_out_object) {
    const Eigen::Matrix4d matrix = T_out_object->matrix();
    for (Eigen::Index row = 0; row < 3; ++row)
      json["T_out_object"].push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
    text += "aligned to three points: the coordinates are not those of the scans\n";
  }
  addOffset(offset, args.out, json, text);
  addColours(*read.state, colours, args.out, json, text);
  context.result(json, text);
}

}  // namespace

void addExportCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Write a session's model as PLY, STL, OBJ or 3MF, by the extension");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--out", args->out, "File to write: .ply, .stl, .obj or .3mf")->required();
  args->finishing.addTo(*command);
  context.addCommonOptions(*command);
  command->callback([args, &context] { runExport(*args, context); });
}

}  // namespace vantage
