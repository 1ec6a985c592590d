#pragma once

#include <span>

#include "geometry/mesh.h"
#include "registration/oriented_points.h"
#include "scanner/view.h"

namespace vantage {

/// Surface to register against: oriented points in object coordinates, away from every border, where the end of the
/// measured surface would pull the pose to one side. Built once, used by any number of registrations.
class RegistrationTarget {
 public:
  /// @param confidence one per vertex (a model's), or empty for 1 each.
  /// @throws InvalidInput when the counts differ.
  explicit RegistrationTarget(const Mesh& model, std::span<const float> confidence = {});

  /// The union of registered views, without merging them.
  explicit RegistrationTarget(std::span<const View> views);

  /// Any points in object coordinates.
  explicit RegistrationTarget(OrientedPoints points);

  [[nodiscard]] const OrientedPoints& surface() const { return surface_; }
  [[nodiscard]] std::size_t size() const { return surface_.size(); }

 private:
  OrientedPoints surface_;
};

/// The vertices of a mesh away from its border that have a normal, ascending; one normal and one flag per vertex.
[[nodiscard]] std::vector<std::uint32_t> verticesInside(std::span<const Vec3> normals,
                                                        std::span<const std::uint8_t> onBorder);

/// The vertices of a mesh away from its border, with normals evened out over two rings of neighbours.
/// @param onBorder one per vertex
/// @param confidence one per vertex, or empty for 1 each
[[nodiscard]] OrientedPoints pointsInside(const Mesh& mesh, std::span<const Vec3> normals,
                                          std::span<const std::uint8_t> onBorder, std::span<const float> confidence);

/// Unit normal per vertex, evened out over two rings of neighbours: less noise, and only registration wants that.
[[nodiscard]] std::vector<Vec3> smoothedNormals(const Mesh& mesh);

}  // namespace vantage
