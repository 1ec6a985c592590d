#include "simulated_stands.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "acquisition/acquisition.h"
#include "acquisition/memory_journal.h"
#include "base/errors.h"
#include "base/random.h"
#include "geometry/resting_faces.h"
#include "registration/pose_prior.h"
#include "scanner/simulated_sensor.h"
#include "simulated_bodies.h"
#include "support/sample_objects/polygonize.h"
#include "support/sample_objects/sample_objects.h"

namespace vantage {
namespace {

constexpr double kSpacing = 1.5;  // of the objects' meshes [mm]
const double kFirm = radians(4.0);
constexpr double kLikely = 0.04;  // faces that fewer ways lead to are not stood on

constexpr const char* kProfile = R"({ "name": "Stands", "scanner": { "type": "rotating_stripe",
  "position": [300, 0, 75], "stripe_height_mm": 170, "samples_per_stripe": 136, "stripes": 130, "sweep_deg": 36,
  "receivers": [[60, 0, 0]], "breakdown_angle_deg": 60, "range_mm": [100, 500],
  "noise": { "range_sigma_mm": 0.1, "dropout": 0.0 } },
  "workspace": { "type": "turntable", "steps": 90 }, "viewing_volume": { "radius_mm": 110, "height_mm": 190 },
  "positional_space": { "surface": "cylinder", "rows": 8, "columns": 90 },
  "mechanics": { "angle_sigma_deg": 0.3, "position_sigma_mm": 0.3 } })";

Mesh meshOf(const Body& body, const BoundingBox& box) {
  return testing::polygonize(body, box, kSpacing);
}

double cylinder(const Vec3& p) {
  const double aside = p.head<2>().norm() - 24.0;
  const double along = std::abs(p.z() - 45.0) - 40.0;
  return std::hypot(std::max(aside, 0.0), std::max(along, 0.0)) + std::min(std::max(aside, along), 0.0);
}

StandObject sampleObject(int number) {
  const BoundingBox box{Vec3(-102, -58, -3), Vec3(102, 58, 158)};
  switch (number % 3) {
    case 0:
      return {"mug", Symmetry::None, meshOf(testing::mug, box)};
    case 1:
      return {"handset", Symmetry::None, meshOf(testing::handset, box)};
    default:
      return {"candle holder", Symmetry::None, meshOf(testing::candleHolder, box)};
  }
}

std::vector<PoseTie> tiesOf(const AcquisitionState& state) {
  std::vector<PoseTie> ties;
  const auto scans = scansOf(state, ScanStatus::In);
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const Pose& from = scans[i - 1]->view.image->T_table_scanner;
    const Pose& to = scans[i]->view.image->T_table_scanner;
    const auto moves = static_cast<int>(scans[i]->number - scans[i - 1]->number);
    ties.push_back({i - 1, i, from.inverse() * to, turntablePrior(state.profile->mechanics, moves)});
  }
  return ties;
}

}  // namespace

StandObject standObject(int number) {
  const BoundingBox box{Vec3(-62, -62, -6), Vec3(62, 62, 116)};
  constexpr int kKinds = 7;
  Random random(static_cast<std::uint64_t>(number), 17);
  switch (number % kKinds) {
    case 2:
      return sampleObject(number / kKinds);
    case 3:
      return {"symmetric " + std::to_string(number), Symmetry::Turns, meshOf(bodyOf(BodyKind::Symmetric, random), box)};
    case 6:
      return {"cylinder", Symmetry::Slides, meshOf(cylinder, box)};
    default:
      return {"unique " + std::to_string(number), Symmetry::None, meshOf(bodyOf(BodyKind::Unique, random), box)};
  }
}

std::optional<SimulatedStand> simulatedStand(const StandObject& object, std::size_t face, int turns,
                                             std::uint64_t seed) {
  std::vector<RestingFace> faces = restingFaces(object.mesh.vertices);
  std::erase_if(faces, [](const RestingFace& f) { return f.margin < kFirm || f.share < kLikely; });
  if (face >= faces.size()) return std::nullopt;
  SimulatedStand stand;
  Random random(seed, 5);
  stand.T_table_object =
      Pose(Eigen::AngleAxisd(2.0 * kPi * random.uniform(), Vec3::UnitZ())) * restingPose(faces[face]);

  const auto profile = std::make_shared<const ScannerProfile>(parseProfile({"stands.json", kProfile, {}}));
  MemoryJournal journal(profile, {});
  Acquisition acquisition(journal);
  const auto standing = std::make_shared<const Mesh>(transformed(object.mesh, stand.T_table_object));
  const Rig rig = opened(simulatedRig(standing, profile, {seed, false}));
  for (int k = 0; k < turns; ++k)
    acquisition.addScan(scanFrom(rig, k * static_cast<int>(profile->workspace.size()) / turns, {}));
  const AcquisitionState& state = *journal.state();
  stand.composite = {viewsOf(state), state.model, {TablePlane{}}, tiesOf(state)};
  stand.rejected = static_cast<int>(countScans(state, ScanStatus::Rejected));
  return stand;
}

TrueFit fittedTo(const RayCaster& object, const CompositeModel& composite, const Pose& T_object_composite) {
  TrueFit fit{T_object_composite, 0.0};
  for (const double gate : {3.0, 3.0, 2.0, 1.0, 1.0, 1.0, 1.0, 1.0}) {
    const Vec3 centre = fit.T_object_composite * composite.centroid();
    Mat6 information = Mat6::Zero();
    Vec6 pull = Vec6::Zero();
    double squares = 0.0;
    double count = 0.0;
    for (const std::uint32_t i : composite.points(PointLevel::Fine)) {
      const Vec3 p = fit.T_object_composite * composite.surface().point(i);
      const auto near = object.closestPoint(p, gate);
      if (!near || near->distance < 1e-9) continue;
      const Vec3 normal = (p - near->point) / near->distance;
      Vec6 j;
      j << (p - centre).cross(normal), normal;
      information += j * j.transpose();
      pull -= near->distance * j;
      squares += near->distance * near->distance;
      count += 1.0;
    }
    fit.rms = std::sqrt(squares / std::max(count, 1.0));
    information.diagonal().array() += 1e-6 * information.trace() / 6.0;
    fit.T_object_composite = motionAbout(centre, information.ldlt().solve(pull)) * fit.T_object_composite;
  }
  return fit;
}

}  // namespace vantage
