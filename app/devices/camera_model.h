#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vectors.h"
#include "scanner/profile.h"

namespace vantage {

/// How a depth camera looks. Its pixel (x, y), counted from the upper left, looks along
/// (2 tan(h / 2) (x / columns - 1/2), 2 tan(v / 2) (1/2 - y / rows), 1) to its right, up and forward: the optical axis
/// goes through x = columns / 2, as OpenNI2 converts depths to points.
struct CameraModel {
  int columns = 0;
  int rows = 0;
  double horizontalFov = 0.0;  ///< h [rad]
  double verticalFov = 0.0;    ///< v [rad]

  bool operator==(const CameraModel&) const = default;
};

/// The direction of a pixel to the right, up and forward, of length 1 along forward.
[[nodiscard]] Vec3 pixelDirection(const CameraModel& camera, int x, int y);

/// "640 x 480 pixels over 58.0 x 45.2 degrees".
[[nodiscard]] std::string describe(const CameraModel& camera);

/// Which pixel of a camera measures along each ray of a scanner, and how depth becomes range.
struct PixelsOfRays {
  std::vector<std::size_t> pixel;  ///< per ray: y columns + x
  std::vector<double> stretch;     ///< per ray: range = stretch * depth
  double worst = 0.0;              ///< how far a ray looks from its pixel, at most [pixels]
};

/// A ray may look so far beside its pixel [pixels].
inline constexpr double kMostPixelError = 0.5;

/// Lays a camera over the rays of a profile, which leave from one point: with as many rows and columns as the camera
/// has pixels, or one less of each, which leaves out the first row and column. The camera is turned to where its pixels
/// fit the rays best.
/// @throws InvalidInput that says what camera and profile are when no ray may look beside its pixel by more than
/// kMostPixelError and one does
[[nodiscard]] PixelsOfRays pixelsOfRays(const CameraModel& camera, const ScannerProfile& profile);

/// Whether a camera's image has the size that pixelsOfRays needs for a profile's rays.
[[nodiscard]] bool sizeFits(int columns, int rows, const RayGrid& rays);

/// Where a camera stands, for a profile of it.
struct CameraPlace {
  Vec3 position{450.0, 0.0, 250.0};  ///< table coordinates [mm]
  Vec3 lookAt{0.0, 0.0, 60.0};       ///< not straight below or above [mm]
  std::optional<Vec3> projector;     ///< of its light: right, up and forward of the camera [mm]; unset: it has none
  int steps = 36;                    ///< positions of its turntable per turn
};

/// A profile whose rays are the pixels of a camera, but for the first row and column: then they lie evenly about its
/// axis, as those of a pinhole do. @param name of the camera
/// @throws InvalidInput for a camera without a field of view or with fewer than 3 x 3 pixels
[[nodiscard]] ProfileSource profileOf(const CameraModel& camera, const std::string& name, const CameraPlace& place);

}  // namespace vantage
