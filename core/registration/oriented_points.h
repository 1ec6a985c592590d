#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// Points of a surface with unit normals and confidences (0, 1], all in one frame.
struct OrientedPoints {
  std::vector<Vec3> points;  ///< [mm]
  std::vector<Vec3> normals;
  std::vector<float> confidence;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] const Vec3& pointAt(std::size_t i) const { return points[i]; }
  [[nodiscard]] const Vec3& normalAt(std::size_t i) const { return normals[i]; }
  [[nodiscard]] float confidenceAt(std::size_t i) const { return confidence[i]; }

  /// Adds the points of `other`, moved.
  void append(const OrientedPoints& other, const Pose& T_this_other);
};

/// Some vertices of a mesh as oriented points. Copies share what they are made of.
class OrientedVertices {
 public:
  /// Keeps referring to positions and confidences, one per vertex as the normals.
  OrientedVertices(const std::vector<Vec3>& positions, std::shared_ptr<const std::vector<Vec3>> normals,
                   const std::vector<float>& confidence, std::vector<std::uint32_t> vertices);

  [[nodiscard]] std::size_t size() const { return vertices_->size(); }
  [[nodiscard]] const Vec3& pointAt(std::size_t i) const { return (*positions_)[(*vertices_)[i]]; }
  [[nodiscard]] const Vec3& normalAt(std::size_t i) const { return (*normals_)[(*vertices_)[i]]; }
  [[nodiscard]] float confidenceAt(std::size_t i) const { return (*confidence_)[(*vertices_)[i]]; }

 private:
  const std::vector<Vec3>* positions_;
  std::shared_ptr<const std::vector<Vec3>> normals_;
  const std::vector<float>* confidence_;
  std::shared_ptr<const std::vector<std::uint32_t>> vertices_;
};

/// About `count` of the points, spread evenly; all when there are fewer.
[[nodiscard]] OrientedPoints thinnedPoints(const OrientedPoints& points, std::size_t count);
[[nodiscard]] OrientedPoints thinnedPoints(const OrientedVertices& points, std::size_t count);

/// Indices 0..size-1.
[[nodiscard]] std::vector<std::uint32_t> allIndices(std::size_t size);

/// About `count` of the indices, chosen by a hash of each so that no grid pattern shows; all when there are fewer.
[[nodiscard]] std::vector<std::uint32_t> thinned(std::vector<std::uint32_t> indices, std::size_t count);

}  // namespace vantage
