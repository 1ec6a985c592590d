#include "core/forecast/scanned_sphere.h"

#include <utility>

#include "geometry/mesh_union.h"
#include "scanner/triangulation.h"
#include "support/meshes.h"
#include "support/simulation.h"

namespace vantage::testing {
namespace {

ScannerProfile camera() {
  return parseProfile({"camera.json",
                       R"({
    "name": "camera",
    "scanner": { "type": "pinhole", "position": [250, 0, 60], "look_at": [0, 0, 50], "rows": 80, "columns": 80,
      "horizontal_fov_deg": 32, "vertical_fov_deg": 32, "receivers": [], "breakdown_angle_deg": 60,
      "range_mm": [50, 500], "noise": { "range_sigma_mm": 0, "dropout": 0 } },
    "workspace": { "type": "turntable", "steps": 24 },
    "viewing_volume": { "radius_mm": 90, "height_mm": 120 } })",
                       {}});
}

}  // namespace

Vec3 sphereCentre() {
  return {0, 0, 50};
}

ScannedSphere::ScannedSphere(const std::vector<int>& positions)
    : profile(std::make_shared<const ScannerProfile>(camera())) {
  TriangulationOptions triangulation;
  triangulation.breakdownAngle = profile->breakdownAngle;
  SimulationOptions ideal;
  ideal.ideal = true;
  const Rig rig = simulation(makeSphere(kSphereRadius, 48, sphereCentre()), profile, ideal);
  for (const int position : positions) {
    View view;
    view.image = std::make_shared<const RangeImage>(scanFrom(rig, position, {}));
    view.mesh = std::make_shared<const ViewMesh>(triangulate(*view.image, triangulation));
    view.T_object_scanner = view.image->T_table_scanner;
    const Mesh seen = transformed(view.mesh->mesh, view.T_object_scanner);
    const Mesh before = std::move(model);
    const std::vector<const Mesh*> both{&before, &seen};
    model = together(both);
    spacing = view.mesh->spacing;
    views.push_back(std::move(view));
  }
}

}  // namespace vantage::testing
