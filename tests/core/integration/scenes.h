#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "geometry/mesh.h"
#include "integration/model.h"
#include "scanner/view.h"

namespace vantage::testing {

/// A window of samples on a grid of 1 mm: rows along y, columns along x.
struct Window {
  int rows = 0;
  int columns = 0;
  double x = 0.0;         ///< of the first column [mm]
  double y = 0.0;         ///< of the first row [mm]
  bool mirrored = false;  ///< columns run the other way
};

/// Height of the surface at x, y [mm]; NaN where the scanner sees nothing.
using Height = std::function<double(double, double)>;
/// Where the scanner sees nothing.
inline constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
/// The same height everywhere.
[[nodiscard]] Height flat(double z);

/// A view straight down on a height field with parallel rays, in object coordinates but for the pose.
[[nodiscard]] View lookDown(const Window& window, const Height& height,
                            const Pose& T_object_scanner = Pose::Identity());

/// Views of an object by a depth camera 300 mm away of 90 x 90 rays, about 1.1 mm apart at the object, from directions
/// given as azimuth and elevation [rad] about the origin, with noise along the rays [mm].
struct Direction {
  double azimuth = 0.0;
  double elevation = 0.0;
};
[[nodiscard]] std::vector<View> scanFrom(const Mesh& object, const std::vector<Direction>& directions, double noise);

/// `count` directions evenly around z.
[[nodiscard]] std::vector<Direction> around(int count);

/// A model that is just a mesh: every vertex is a sample of view 0.
[[nodiscard]] Model modelOf(const Mesh& mesh);

/// Vertices minus edges plus triangles.
[[nodiscard]] long eulerCharacteristic(const Mesh& mesh);

/// Vertices with more than one fan of triangles.
[[nodiscard]] std::size_t countBowTies(const Mesh& mesh);

/// Expects one piece with one border and no hole, manifold everywhere.
void expectDisc(const Mesh& mesh);

}  // namespace vantage::testing
