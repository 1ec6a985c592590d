#pragma once

#include <memory>
#include <string>
#include <utility>

#include "acquisition/acquisition.h"
#include "geometry/resting_faces.h"
#include "session/session.h"
#include "support/scenes/small_scene.h"
#include "support/simulation.h"

namespace vantage::testing {

/// Lying on the face that it rests on, turned about the vertical and off the axis: T_table_object.
[[nodiscard]] inline Pose lyingOn(const Mesh& object, std::size_t face) {
  Pose put = Pose::Identity();
  put.translate(Vec3(4.0, -3.0, 0.0));
  put.rotate(Eigen::AngleAxisd(0.7, Vec3::UnitZ()));
  return put * restingPose(restingFaces(object.vertices).at(face));
}

/// Writes a session of an object that was scanned upright and, with nobody who knows how, turned over.
inline void writeTurnedSession(const std::string& path, const Mesh& object, const Pose& T_table_object, int views) {
  AcquisitionSettings settings;
  settings.strategy.kind = Strategy::Kind::Uniform;
  settings.strategy.uniformViews = views;
  settings.maxViews = views;
  Session session = Session::create(path, {smallProfileSource(), settings, &object});
  const auto scan = [&](const Mesh& standing) {
    Acquisition(session, {simulation(standing, session.profile(), {1, true}), nullptr}).runUntilTheEnd();
  };
  scan(object);
  Acquisition(session).carryOut(TurnObject{});
  scan(transformed(object, T_table_object));
}

}  // namespace vantage::testing
