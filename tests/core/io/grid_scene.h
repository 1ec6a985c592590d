#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/vectors.h"
#include "io/range_grid_rays.h"
#include "scanner/ray_grid.h"

namespace vantage::testing {

/// What a scanner saw, per cell, row by row: nothing where its ray met nothing.
struct SeenGrid {
  int rows = 0;
  int columns = 0;
  std::vector<std::optional<Vec3>> cells;
};

/// A lump of three balls about (0, 0, 0), 50 mm in size, that looks different from everywhere.
inline std::optional<double> distanceToLump(const RangingRay& ray) {
  struct Ball {
    Vec3 centre;
    double radius;
  };
  const std::vector<Ball> balls{{{0, 0, 0}, 18.0}, {{14, 3, 6}, 9.0}, {{-5, 15, -4}, 10.0}};
  std::optional<double> nearest;
  for (const Ball& ball : balls) {
    const Vec3 to = ball.centre - ray.origin;
    const double along = to.dot(ray.direction);
    const double aside2 = to.squaredNorm() - along * along;
    if (aside2 >= ball.radius * ball.radius) continue;
    const double t = along - std::sqrt(ball.radius * ball.radius - aside2);
    if (t > 0.0 && (!nearest || t < *nearest)) nearest = t;
  }
  return nearest;
}

/// The lump, seen along rays in scanner coordinates from where `T_object_scanner` puts the scanner.
inline SeenGrid seeLump(int rows, int columns, const std::function<RangingRay(double, double)>& rayAt,
                        const Pose& T_object_scanner) {
  SeenGrid grid{rows, columns, {}};
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const RangingRay ray = rayAt(r - 0.5 * (rows - 1), c - 0.5 * (columns - 1));
      const auto t = distanceToLump({T_object_scanner * ray.origin, T_object_scanner.linear() * ray.direction});
      grid.cells.push_back(t ? std::optional(Vec3(ray.origin + *t * ray.direction)) : std::nullopt);
    }
  }
  return grid;
}

/// Rays of a pinhole at the origin: x right, and forward +z with y down, or forward -z with y up.
inline std::function<RangingRay(double, double)> pinholeRays(double forward) {
  return [forward](double v, double u) {
    return RangingRay{Vec3::Zero(), Vec3(u / 200.0, forward * v / 200.0, forward).normalized()};
  };
}

/// Parallel rays, 1 mm apart, along +z or -z.
inline std::function<RangingRay(double, double)> parallelRays(double forward) {
  return [forward](double v, double u) { return RangingRay{Vec3(u, v, -100.0 * forward), Vec3(0.0, 0.0, forward)}; };
}

/// Where a scanner stands that looks at the lump from `azimuth` [deg] about y: `distance` from its middle.
inline Pose poseAround(double azimuth, double forward, double distance) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(radians(azimuth), Vec3::UnitY()).toRotationMatrix();
  pose.translation() = pose.linear() * Vec3(0.0, 0.0, -forward * distance);
  return pose;
}

struct PlyStyle {
  double unit = 1.0;              ///< units per millimetre
  Vec3 offset = Vec3::Zero();     ///< added, in units
  std::optional<Vec3> missing{};  ///< a vertex for every cell, this one where nothing was seen
  bool lists = true;              ///< with range_grid
  bool exchanged = false;         ///< says rows for columns
  std::string info{};             ///< further lines of the header
};

/// A PLY range file.
inline std::string plyOf(const SeenGrid& grid, const PlyStyle& style = {}) {
  std::ostringstream points;
  std::ostringstream lists;
  points.precision(17);
  std::size_t count = 0;
  for (const auto& cell : grid.cells) {
    if (!cell && !style.missing) {
      lists << "0\n";
      continue;
    }
    const Vec3 p = cell ? Vec3(style.unit * *cell + style.offset) : *style.missing;
    points << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    lists << "1 " << count++ << '\n';
  }
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nobj_info num_cols " << (style.exchanged ? grid.rows : grid.columns)
       << "\nobj_info num_rows " << (style.exchanged ? grid.columns : grid.rows) << '\n'
       << style.info << "element vertex " << count << "\nproperty double x\nproperty double y\nproperty double z\n";
  if (style.lists) text << "element range_grid " << grid.cells.size() << "\nproperty list uchar int vertex_indices\n";
  text << "end_header\n" << points.str() << (style.lists ? lists.str() : "");
  return text.str();
}

}  // namespace vantage::testing
