#include <memory>
#include <optional>
#include <string>

#include "base/errors.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/text.h"
#include "io/file_kind.h"
#include "io/mesh_reader.h"
#include "io/placement.h"
#include "report/evaluation.h"
#include "report/report.h"

namespace vantage {
namespace {

struct EvaluateArguments {
  std::string model;
  std::string object;
  std::string scanner;
  std::optional<std::string> placement;  // unset: as the session says, as-is for a mesh
};

struct AcquiredModel {
  Mesh mesh;
  PlacementOptions placement = {};  // of the object it was scanned from
};

AcquiredModel loadModel(const std::string& path, CommandContext& context) {
  if (detectFileKind(path) != FileKind::Session)
    return {loadMesh(path, {}, context.progress().part(0.0, 0.1, "read model")).mesh};
  const auto state = readObject(path, context);
  if (!state->model) throw InvalidInput(path + ": has no model yet, expected at least one view");
  return {state->model->mesh, {state->settings.simulation.placement, state->settings.simulation.unit}};
}

void runEvaluate(const EvaluateArguments& args, CommandContext& context) {
  const ScannerProfile profile = loadProfile(args.scanner);
  const AcquiredModel model = loadModel(args.model, context);
  PlacementOptions placement = model.placement;
  if (args.placement) placement.placement = parsePlacement(*args.placement);
  const Mesh object =
      loadPlacedMesh(args.object, placement, profile.viewingVolume, context.progress().part(0.1, 0.2, "read object"))
          .mesh;
  const Evaluation e = evaluate(model.mesh, object, profile, {}, context.progress().part(0.2, 1.0));
  const auto counts = modelJson(model.mesh);
  context.result({{"scannable_share", e.scannableShare},
                  {"coverage_of_scannable", e.coverage},
                  {"coverage_of_whole", e.wholeCoverage},
                  {"rms_mm", e.rms},
                  {"p99_mm", e.percentile99},
                  {"false_surface", e.falseSurface},
                  {"model", counts}},
                 "scannable: " + number(100.0 * e.scannableShare, 2) + " % of the surface\ncovered:   " +
                     number(100.0 * e.coverage, 2) + " % of that, " + number(100.0 * e.wholeCoverage, 2) +
                     " % of the whole surface\nRMS:       " + number(e.rms, 4) + " mm, 99 % within " +
                     number(e.percentile99, 3) + " mm\nfalse:     " + number(100.0 * e.falseSurface, 3) +
                     " %\nedges:     " + counts["boundary_edges"].dump() + " boundary, " +
                     counts["non_manifold_edges"].dump() + " non-manifold\n");
}

}  // namespace

void addEvaluateCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<EvaluateArguments>();
  CLI::App* command = app.add_subcommand("evaluate", "Measure a model against the object it was scanned from");
  command->add_option("model", args->model, "Session or mesh file")->required();
  command->add_option("--object", args->object, "Mesh of the object")->required();
  command->add_option("--scanner", args->scanner, "Scanner profile (JSON)")->required();
  command->add_option("--place", args->placement, "How the object was placed; unset: as the session says")
      ->check(CLI::IsMember({"as-is", "fit"}));
  context.addCommonOptions(*command);
  command->callback([args, &context] { runEvaluate(*args, context); });
}

}  // namespace vantage
