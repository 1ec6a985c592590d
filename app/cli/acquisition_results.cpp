#include "cli/acquisition_results.h"

#include <array>
#include <filesystem>

#include "acquisition/model_colours.h"
#include "base/errors.h"
#include "cli/text.h"
#include "io/mesh_writer.h"
#include "io/output_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReport = "report.json";
constexpr std::array<const char*, 2> kModels{"model.ply", "model.stl"};

}  // namespace

std::string AcquisitionResults::file(const char* name) const {
  return (fs::path(folder_) / name).string();
}

void AcquisitionResults::mustBeNew() const {
  for (const char* name : {kReport, kModels[0], kModels[1]})
    if (fs::exists(fs::symlink_status(file(name))))
      throw InvalidInput(file(name) +
                         ": is there already and stays as it is: choose another folder (--out), or say "
                         "--replace");
}

void AcquisitionResults::mustBeReplaceable(const std::vector<std::string>& inputs) const {
  checkOutput(file(kReport), OutputKind::Json, inputs);
  for (const char* name : kModels) checkOutput(file(name), OutputKind::Mesh, inputs);
}

void AcquisitionResults::write(const AcquisitionState& state, const nlohmann::ordered_json& report,
                               const Progress& progress) const {
  writeTextFile(file(kReport), report.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (!state.model) return;
  const VertexColours colours = coloursOf(state, progress.part(0.0, 0.5));
  exportModel(*state.model, file(kModels[0]), progress.part(0.5, 0.75), Vec3::Zero(), colours);
  exportModel(*state.model, file(kModels[1]), progress.part(0.75, 1.0), Vec3::Zero(), colours);
}

}  // namespace vantage
