#include "acquisition/test_turn.h"

#include <cmath>
#include <memory>
#include <string>

#include "acquisition/phase_times.h"
#include "base/errors.h"
#include "registration/pose_prior.h"
#include "registration/registration_target.h"
#include "scanner/scan_use.h"
#include "scanner/table_turn.h"
#include "scanner/triangulation.h"

namespace vantage {
namespace {

double turnAboutZ(const Pose& pose) {
  return std::atan2(pose.linear()(1, 0) - pose.linear()(0, 1), pose.linear()(0, 0) + pose.linear()(1, 1));
}

// What the positioner knows of its errors, else what the profile says of them.
Mechanics mechanicsOf(const Rig& rig, const ScannerProfile& profile) {
  const auto reached = rig.positioner->where();
  return reached && reached->uncertainty ? *reached->uncertainty : profile.mechanics;
}

}  // namespace

bool TestTurn::asExpected() const {
  return std::abs(measured - expected) <= angleLimit() && axisOffset <= offsetLimit();
}

double TestTurn::angleLimit() const {
  return kSigmas * std::hypot(std::sqrt(2.0) * errors.angleSigma, kScanAngle);
}

double TestTurn::offsetLimit() const {
  return kSigmas * std::hypot(std::sqrt(2.0) * errors.positionSigma, kScanOffset);
}

TestTurn testTurn(const Rig& rig, const ScannerProfile& profile, int from, int to, const CutOptions& cut,
                  const Progress& progress) {
  TestTurn result;
  result.expected = -turnBetween(profile.workspace, from, to).angle;
  TriangulationOptions triangulation;
  triangulation.breakdownAngle = profile.breakdownAngle;

  const auto scan = [&](int position, const Progress& scanning) {
    const auto whole = std::make_shared<const RangeImage>(scanFrom(rig, position, scanning.part(0.0, 0.8)));
    return usedImage(whole, {{cutSceneOf(profile), cut}, {}}, nullptr, scanning.part(0.8, 1.0));
  };
  const UsedImage first = scan(from, progress.part(0.0, 0.25, name(Phase::Scan)));
  const UsedImage second = scan(to, progress.part(0.25, 0.5, name(Phase::Scan)));
  const Progress registering = progress.part(0.5, 1.0, name(Phase::Register));
  registering.checkpoint(0.0);
  const ViewMesh a = triangulate(*first.image, triangulation, registering.part(0.0, 0.1));
  if (a.mesh.empty())
    throw InvalidInput("the scan from position " + std::to_string(from) +
                       " has no surface: is the object inside the viewing volume?");
  IcpOptions options;
  result.errors = mechanicsOf(rig, profile);
  options.prior = turntablePrior(result.errors);
  result.samples = first.samples;
  const RegistrationTarget target(transformed(a.mesh, first.image->T_table_scanner), a.confidence);
  const Pose& T_table_scanner = second.image->T_table_scanner;
  const ViewMesh b = triangulate(*second.image, triangulation, registering.part(0.1, 0.2));
  result.registration =
      registerView(b, *second.image->rays, T_table_scanner, target, options, registering.part(0.2, 1.0));
  const Pose error = result.registration.T_object_scanner * T_table_scanner.inverse();
  result.measured = result.expected + turnAboutZ(error);
  result.axisOffset = error.translation().head<2>().norm();
  return result;
}

}  // namespace vantage
