#pragma once

#include <QPointF>
#include <QSizeF>
#include <array>
#include <cstdint>
#include <optional>

#include "geometry/measures.h"
#include "geometry/vectors.h"

namespace vantage {

enum class CameraPreset : std::uint8_t {
  Fit,          ///< what is looked at in sight, direction kept, upright
  Front,        ///< along -x: from where the scanner of position 0 stands
  Top,          ///< from above, x to the right
  ScannersEye,  ///< from where the scanner stands
  Oblique,      ///< from above the front right; the first sight of a scene
  Everything,   ///< as Fit, with all that stands around
};

/// Where a scene is looked at from. z is up where that is possible.
struct Camera {
  Vec3 eye{400.0, 0.0, 200.0};
  Vec3 target = Vec3::Zero();
  Vec3 up = Vec3::UnitZ();
  double viewAngle = radians(30.0);  ///< over the height of the picture [rad]
  /// What is far is as large as what is near; at the target all is as large as in perspective.
  bool parallel = false;

  [[nodiscard]] Vec3 forward() const { return (target - eye).normalized(); }
  [[nodiscard]] Vec3 right() const { return forward().cross(up).normalized(); }
  [[nodiscard]] double distance() const { return (target - eye).norm(); }
};

/// A line into the scene.
struct SightLine {
  Vec3 origin;
  Vec3 direction;  ///< unit
};

/// How far before the target lines of a parallel camera begin: before everything that there is to see [mm].
[[nodiscard]] double parallelStart(const Camera& camera);

/// The line under a point of a picture; y runs down from the top edge.
[[nodiscard]] SightLine sightLine(const Camera& camera, const QPointF& point, const QSizeF& size);

/// How far along a line a flat convex quad is met, from either side; nothing when it is missed.
[[nodiscard]] std::optional<double> distanceTo(const std::array<Vec3, 4>& quad, const SightLine& line);

/// A camera that has a box in sight from a direction, for pictures of that shape (width / height).
/// @param forward from the eye into the scene, need not be unit.
[[nodiscard]] Camera cameraToward(const Vec3& forward, const BoundingBox& box, double aspect);

}  // namespace vantage
