#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// Where a ray meets the mesh first.
struct RayHit {
  double distance = 0.0;  ///< [mm] along the unit direction
  std::uint32_t triangle = kNoIndex;
  Vec3 normal = Vec3::Zero();  ///< unit, of the triangle's front side
};

/// The point of the mesh nearest to a query point.
struct SurfacePoint {
  Vec3 point = Vec3::Zero();
  double distance = 0.0;  ///< [mm]
  std::uint32_t triangle = kNoIndex;
  Vec3 barycentric = Vec3::Zero();  ///< weights of the triangle's vertices, sum 1
};

/// One segment of a stream of occlusion queries. After the query `far` is minus infinity where the mesh blocks it.
struct OcclusionRay {
  float originX, originY, originZ;
  float near;  ///< [mm] where the segment begins along the direction
  float directionX, directionY, directionZ;
  float time;  ///< 0
  float far;   ///< [mm] where it ends
  std::uint32_t mask = 0xffffffffU;
  std::uint32_t id = 0;
  std::uint32_t flags = 0;

  [[nodiscard]] bool blocked() const { return far < 0.0F; }
};

/// Ray and nearest-point queries against a fixed mesh. Queries are const and may run on any number of threads.
class RayCaster {
 public:
  enum class Precision {
    Fast,    ///< rays that graze an edge may pass: for counting many rays
    Robust,  ///< watertight: for simulating a scanner
  };

  /// Copies the geometry. Degenerate triangles are never hit.
  /// @throws InvalidInput for an index out of range or more than 2^31 corners; Cancelled
  explicit RayCaster(const Mesh& mesh, Precision precision = Precision::Fast, const Progress& progress = {});
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// First hit of the ray between two distances [mm]. @pre direction is a unit vector
  [[nodiscard]] std::optional<RayHit> intersect(const Vec3& origin, const Vec3& direction, double near = 0.0,
                                                double far = std::numeric_limits<double>::infinity()) const;

  /// Whether something lies between two points, leaving out `margin` [mm] at either end.
  [[nodiscard]] bool occluded(const Vec3& from, const Vec3& to, double margin = 0.0) const;

  /// Answers a stream of queries at once; fastest with 256 rays that leave from the same place.
  void occluded(std::span<OcclusionRay> rays) const;

  /// Nearest point of the mesh within `radius` [mm] of p; the lowest triangle wins a tie.
  [[nodiscard]] std::optional<SurfacePoint> closestPoint(const Vec3& p, double radius) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace vantage
