#include "scenes.h"

#include <cmath>

#include "geometry/resting_faces.h"
#include "integration/consensus.h"
#include "integration/zipper.h"
#include "scanner/ray_patterns.h"
#include "support/meshes.h"
#include "support/simulation.h"

namespace vantage::testing {

std::shared_ptr<const ScannerProfile> standProfile() {
  auto profile = std::make_shared<ScannerProfile>();
  profile->rays = std::make_shared<RayGrid>(
      makeRays(RotatingStripe{Vec3(250, 0, 60), 120.0, 49, 71, radians(30.0)}, ReceiverOffsets{Vec3(50, 0, 0)}));
  profile->noise.rangeSigma = 0.1;
  profile->minRange = 100.0;
  profile->maxRange = 400.0;
  profile->workspace = turntable(24);
  profile->mechanics = {radians(0.2), 0.2};
  return profile;
}

Mesh makeOddBody() {
  return joined(joined(makeBox(Vec3(-30, -20, 0), Vec3(30, 20, 36), 6), makeSphere(20, 20, {-14, 6, 44})),
                joined(makeSphere(14, 16, {26, 16, 26}), makeSphere(11, 14, {8, -22, 14})));
}

Mesh makeRoundBar() {
  constexpr int kSides = 64;
  constexpr double kRadius = 24.0;
  constexpr double kHeight = 70.0;
  Mesh mesh;
  for (int i = 0; i < kSides; ++i)
    for (const double z : {0.0, kHeight})
      mesh.vertices.emplace_back(kRadius * std::cos(2.0 * kPi * i / kSides), kRadius * std::sin(2.0 * kPi * i / kSides),
                                 z);
  const auto below = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0, 0, 0);
  mesh.vertices.emplace_back(0, 0, kHeight);
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * ((i + 1) % kSides);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
    mesh.triangles.push_back({below, b, a});
    mesh.triangles.push_back({below + 1, a + 1, b + 1});
  }
  return mesh;
}

Pose standOn(const Mesh& body, std::size_t face, double turn) {
  const auto faces = restingFaces(body.vertices);
  return Pose(Eigen::AngleAxisd(turn, Vec3::UnitZ())) * restingPose(faces.at(face));
}

Composite acquireStand(const Mesh& body, const Pose& T_table_body, int views, unsigned seed) {
  const auto profile = standProfile();
  SimulationOptions options;
  options.seed = seed;
  const auto ideal = std::make_shared<ScannerProfile>(*profile);
  ideal->mechanics = {};
  const Rig rig = simulation(transformed(body, T_table_body), ideal, options);
  Composite composite;
  for (int k = 0; k < views; ++k) {
    RangeImage image = scanFrom(rig, k * static_cast<int>(profile->workspace.size()) / views, {});
    View view;
    view.mesh = std::make_shared<const ViewMesh>(triangulate(image, {}));
    view.T_object_scanner = image.T_table_scanner;
    view.image = std::make_shared<const RangeImage>(std::move(image));
    composite.views.push_back(std::move(view));
    if (k == 0) continue;
    const auto at = static_cast<std::size_t>(k);
    composite.ties.push_back(
        {at - 1, at,
         composite.views[at - 1].image->T_table_scanner.inverse() * composite.views[at].image->T_table_scanner,
         turntablePrior(profile->mechanics)});
  }
  composite.model =
      std::make_shared<const Model>(applyConsensus(zipper(composite.views, {}).model, composite.views, {}));
  composite.tables = {TablePlane{}};
  return composite;
}

const TwoStands& oddBodyInTwoStands() {
  static const TwoStands stands = [] {
    const Mesh body = makeOddBody();
    const Pose a = standOn(body, 0, 0.4);
    const Pose b = standOn(body, 1, 2.1);
    return TwoStands{a * b.inverse(), CompositeModel(acquireStand(body, a, 8, 1)),
                     CompositeModel(acquireStand(body, b, 8, 2))};
  }();
  return stands;
}

double poseError(const CompositeModel& composite, const Pose& a, const Pose& b) {
  double squares = 0.0;
  for (const Vec3& p : composite.surface().points()) squares += (a * p - b * p).squaredNorm();
  return std::sqrt(squares / static_cast<double>(composite.surface().size()));
}

}  // namespace vantage::testing
