#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// A side on which a body can rest on a table.
struct RestingFace {
  Vec3 normal = Vec3::Zero();  ///< unit, outward: it points down when the body rests
  Vec3 foot = Vec3::Zero();    ///< of the centroid on the face's plane [mm]
  double height = 0.0;         ///< of the centroid above it [mm]
  double margin = 0.0;         ///< least tilt over an edge of the face that makes the body fall [rad]; above 0
  double share = 0.0;          ///< of all ways to put the body down: it rolls onto this face, 0..1
};

struct RestingFaceOptions {
  double mergeAngle = radians(20.0);  ///< faces whose normals are nearer to each other are one [rad]
  double contact = 0.01;              ///< what is no farther from a face touches the table [size of the hull]
  double leastMargin = radians(1.0);  ///< faces with less are left out, unless it would leave none [rad]
  std::size_t atMost = 16;
};

/// The faces of the points' convex hull that a body of even density, filling the hull, rests on: from every facet it
/// rolls over the edge beyond which the foot of the centroid lies, until the foot is inside. Those onto which it rolls
/// from most directions first. Never empty. Deterministic.
/// @throws InvalidInput as convexHull
[[nodiscard]] std::vector<RestingFace> restingFaces(std::span<const Vec3> points,
                                                    const RestingFaceOptions& options = {});

/// T_table_body of a body that rests on a face: the face is in z = 0, the foot of the centroid in the origin.
[[nodiscard]] Pose restingPose(const RestingFace& face);

}  // namespace vantage
