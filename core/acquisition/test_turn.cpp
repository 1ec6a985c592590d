#include "acquisition/test_turn.h"

#include <cmath>
#include <string>

#include "acquisition/phase_times.h"
#include "base/errors.h"
#include "registration/pose_prior.h"
#include "registration/registration_target.h"
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

TestTurn testTurn(const Rig& rig, const ScannerProfile& profile, int from, int to, const CutOptions& cut,
                  const Progress& progress) {
  TestTurn result;
  result.expected = -turnBetween(profile.workspace, from, to).angle;
  TriangulationOptions triangulation;
  triangulation.breakdownAngle = profile.breakdownAngle;

  const auto scan = [&](int position, const Progress& scanning) {
    const RangeImage whole = scanFrom(rig, position, scanning);
    return cutsNothing(cut) ? whole : withoutCut(whole, cutOf(whole, {cutSceneOf(profile), cut}));
  };
  const RangeImage first = scan(from, progress.part(0.0, 0.25, name(Phase::Scan)));
  const RangeImage second = scan(to, progress.part(0.25, 0.5, name(Phase::Scan)));
  const Progress registering = progress.part(0.5, 1.0, name(Phase::Register));
  registering.checkpoint(0.0);
  const ViewMesh a = triangulate(first, triangulation);
  if (a.mesh.empty())
    throw InvalidInput("the scan from position " + std::to_string(from) +
                       " has no surface: is the object inside the viewing volume?");
  IcpOptions options;
  options.prior = turntablePrior(mechanicsOf(rig, profile));
  result.samples = first.sampleCount();
  const RegistrationTarget target(transformed(a.mesh, first.T_table_scanner), a.confidence);
  result.registration = registerView(triangulate(second, triangulation), *second.rays, second.T_table_scanner, target,
                                     options, registering);
  const Pose error = result.registration.T_object_scanner * second.T_table_scanner.inverse();
  result.measured = result.expected + turnAboutZ(error);
  result.axisOffset = error.translation().head<2>().norm();
  return result;
}

}  // namespace vantage
