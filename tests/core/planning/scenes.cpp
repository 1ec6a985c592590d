#include "core/planning/scenes.h"

#include <utility>

#include "integration/zipper.h"
#include "support/meshes.h"
#include "support/simulation.h"

namespace vantage::testing {
namespace {

View viewFrom(const Pose& T_object_scanner) {
  auto mesh = std::make_shared<ViewMesh>();
  mesh->spacing = kSceneSpacing;
  View view;
  view.mesh = std::move(mesh);
  view.T_object_scanner = T_object_scanner;
  return view;
}

ScannerProfile coarseScanner() {
  return parseProfile({"coarse.json",
                       R"({
    "name": "coarse",
    "scanner": { "type": "rotating_stripe", "position": [250, 0, 60], "stripe_height_mm": 120, "samples_per_stripe": 61,
      "stripes": 81, "sweep_deg": 50, "receivers": [[50, 0, 0]], "breakdown_angle_deg": 65, "range_mm": [100, 400],
      "noise": { "range_sigma_mm": 0.05, "dropout": 0.0 } },
    "workspace": { "type": "turntable", "steps": 24 },
    "viewing_volume": { "radius_mm": 90, "height_mm": 120 },
    "positional_space": { "surface": "cylinder", "rows": 10, "columns": 48 },
    "mechanics": { "angle_sigma_deg": 0, "position_sigma_mm": 0 } })",
                       {}});
}

Mesh threeSpheres() {
  return joined(joined(makeSphere(32, 24, {5, -8, 40}), makeSphere(20, 20, {-30, 12, 55})),
                makeSphere(14, 16, {30, 25, 30}));
}

}  // namespace

ScannerProfile flatScanner() {
  ProfileSource source{"profile.json",
                       R"({
    "name": "test",
    "scanner": { "type": "linear_stripe", "position": [300, 0, 100], "stripe_height_mm": 200, "samples_per_stripe": 101,
      "stripes": 101, "travel_mm": 200, "receivers": [[60, 0, 0]], "breakdown_angle_deg": 60, "range_mm": [100, 400] },
    "workspace": { "type": "turntable", "steps": 4 } })",
                       {}};
  return parseProfile(source);
}

std::unique_ptr<const PlanningScene> sceneOf(const ScannerProfile& profile, const Mesh& obstacles,
                                             const std::vector<VoidPatch>& patches, const std::vector<Pose>& taken,
                                             const PlannerOptions& options) {
  PlanInput input;
  input.profile = std::make_shared<const ScannerProfile>(profile);
  input.model = std::make_shared<const Model>(Model{obstacles, {}, {}, {}, {}});
  for (const Pose& pose : taken) input.views.push_back(viewFrom(pose));
  if (taken.empty()) input.views.push_back(viewFrom(Pose(Eigen::Translation3d(0, 0, 1e5))));
  auto voids = std::make_shared<VoidSurface>();
  voids->patches = patches;
  // Views without images have carved nothing that a forecast could begin with.
  PlannerOptions byPatches = options;
  byPatches.forecast = false;
  return std::make_unique<const PlanningScene>(std::move(input), std::move(voids), byPatches, Progress());
}

ScannedObject::ScannedObject(const std::vector<int>& positions)
    : profile(std::make_shared<const ScannerProfile>(coarseScanner())) {
  TriangulationOptions triangulation;
  triangulation.breakdownAngle = profile->breakdownAngle;
  for (const int position : positions) {
    // No two views are level with each other: where rows of samples lie in one plane, which ray comes first about an
    // edge hangs on the last bit.
    const auto k = static_cast<double>(views.size());
    const Pose tilt = smallMotion((Vec6() << 0.011 * k, -0.007 * k, 0.0, 0.0, 0.0, 0.3 * k).finished());
    const Rig rig = testing::simulation(transformed(threeSpheres(), tilt), profile, {1, false}, static_cast<int>(k));
    View view;
    view.image = std::make_shared<const RangeImage>(scanFrom(rig, position, {}));
    view.mesh = std::make_shared<const ViewMesh>(triangulate(*view.image, triangulation));
    view.T_object_scanner = tilt.inverse() * profile->workspace.poses[static_cast<std::size_t>(position)];
    views.push_back(std::move(view));
  }
  ZipperOptions zippering;
  zippering.breakdownAngle = profile->breakdownAngle;
  model = std::make_shared<const Model>(zipper(views, zippering).model);
}

PlanInput ScannedObject::input() const {
  PlanInput input;
  input.profile = profile;
  input.model = model;
  input.views = views;
  for (const View& view : views) input.taken.push_back(view.image->station.position.value());
  if (!input.taken.empty()) input.current = input.taken.back();
  return input;
}

}  // namespace vantage::testing
