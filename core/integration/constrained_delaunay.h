#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "integration/exact_plane.h"

namespace vantage {

/// The constrained Delaunay triangulation of points in the plane: every constraint is an edge, and no circle through a
/// triangle holds a point that the triangle could see past the constraints. Decided in whole numbers, hence for any
/// input; of four points on one circle either diagonal may be chosen.
///
/// Points by Bowyer-Watson insertion with a point at infinity; constraints by edge flips (Sloan 1993).
class ConstrainedDelaunay {
 public:
  /// Triangulates the convex hull of the points. Of points that coincide the first counts. Points that all lie on one
  /// line give no triangles.
  /// @throws InvalidInput for a coordinate beyond kPlaneLimit.
  explicit ConstrainedDelaunay(std::span<const PlanePoint> points);

  /// Makes the segment between two points an edge; a point on the way splits it.
  /// @return false, and nothing changes, when it would cross an earlier constraint or there are no triangles.
  bool constrain(std::uint32_t a, std::uint32_t b);

  /// Counter-clockwise.
  [[nodiscard]] std::vector<Triangle> triangles() const;

 private:
  // Edge k runs from vertex k to vertex k + 1. One vertex of a face outside of the hull is the point at infinity.
  struct Face {
    std::array<std::uint32_t, 3> vertex;
    std::array<std::uint32_t, 3> neighbour;
    std::array<bool, 3> fixed;
  };
  struct Corner {
    std::uint32_t face;
    int edge;
  };

  [[nodiscard]] std::vector<std::uint32_t> insertionOrder() const;
  [[nodiscard]] bool begin(const std::vector<std::uint32_t>& order, std::array<std::uint32_t, 3>& first);
  void insert(std::uint32_t point);
  [[nodiscard]] std::uint32_t faceInConflict(const PlanePoint& p) const;
  [[nodiscard]] bool conflicts(const Face& face, const PlanePoint& p) const;
  [[nodiscard]] bool infinite(const Face& face) const;
  std::uint32_t addFace(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void link(Corner a, Corner b);

  template <typename Visit>
  void visitAround(std::uint32_t vertex, const Visit& visit) const;
  [[nodiscard]] Corner cornerOf(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] Corner opposite(Corner corner) const;
  [[nodiscard]] Corner firstCrossing(std::uint32_t a, std::uint32_t b, std::uint32_t& through) const;
  [[nodiscard]] bool collectCrossings(std::uint32_t a, std::uint32_t b, std::uint32_t& end,
                                      std::vector<std::array<std::uint32_t, 2>>& edges) const;
  void forceEdge(std::uint32_t a, std::uint32_t b, std::vector<std::array<std::uint32_t, 2>> crossing);
  [[nodiscard]] bool flippable(Corner corner) const;
  void flip(Corner corner);
  void restoreDelaunay(std::vector<std::array<std::uint32_t, 2>> edges);

  std::vector<PlanePoint> points_;
  std::uint32_t infinity_;
  std::vector<std::uint32_t> representative_;  // the first point at the place of each
  std::vector<Face> faces_;
  std::vector<std::uint32_t> freeFaces_;
  std::vector<std::uint32_t> faceOf_;  // some face at every point
  std::uint32_t last_ = 0;             // where the next search begins
  // Of the insertion that runs.
  std::vector<std::uint32_t> mark_;
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> faceFrom_;
};

}  // namespace vantage
