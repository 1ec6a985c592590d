#include "scenes.h"

#include "support/meshes.h"
#include "support/simulation.h"

namespace vantage::testing {

std::shared_ptr<const ScannerProfile> parallelScanner(const std::string& receiver) {
  const std::string text = R"({
    "name": "Parallel rays",
    "scanner": {
      "type": "linear_stripe", "position": [300, 0, 50], "stripe_height_mm": 60, "samples_per_stripe": 61,
      "stripes": 61, "travel_mm": 60, "receivers": [)" +
                           receiver + R"(], "breakdown_angle_deg": 60,
      "range_mm": [10, 1000], "noise": { "range_sigma_mm": 0, "dropout": 0 }
    },
    "workspace": { "type": "turntable", "steps": 36 },
    "viewing_volume": { "radius_mm": 100, "height_mm": 100 },
    "positional_space": { "surface": "cylinder", "rows": 20, "columns": 36 },
    "mechanics": { "angle_sigma_deg": 0, "position_sigma_mm": 0 }
  })";
  return std::make_shared<const ScannerProfile>(parseProfile({"parallel.json", text, {}}));
}

Mesh makePlate(double x, double yMin, double yMax) {
  Mesh plate;
  plate.vertices = {{x, yMin, 0}, {x, yMax, 0}, {x, yMax, 100}, {x, yMin, 100}};
  plate.triangles = {{0, 1, 2}, {0, 2, 3}};
  return plate;
}

Mesh makeStep() {
  return joined(makePlate(20, -24.5, 0.001), makePlate(-20, -24.5, 24.5));
}

View scanView(const Mesh& object, const std::shared_ptr<const ScannerProfile>& profile, int position) {
  SimulationOptions ideal;
  ideal.ideal = true;
  const Rig rig = simulation(object, profile, ideal);
  View view;
  view.image = std::make_shared<const RangeImage>(scanFrom(rig, position, {}));
  view.mesh = std::make_shared<const ViewMesh>(triangulate(*view.image, {}));
  view.T_object_scanner = view.image->T_table_scanner;
  return view;
}

View without(const View& view, const std::function<bool(const Vec3&)>& lost) {
  RangeImage image = *view.image;
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i) && lost(view.T_object_scanner * image.point(i))) image.range[i] = kNoSample;
  View result = view;
  result.image = std::make_shared<const RangeImage>(image);
  result.mesh = std::make_shared<const ViewMesh>(triangulate(image, {}));
  return result;
}

Model modelOf(const View& view) {
  Model model;
  model.mesh = transformed(view.mesh->mesh, view.T_object_scanner);
  model.confidence = view.mesh->confidence;
  model.vertexView.assign(model.mesh.vertices.size(), 0);
  model.vertexSample = view.mesh->sample;
  model.triangleView.assign(model.mesh.triangles.size(), 0);
  return model;
}

}  // namespace vantage::testing
