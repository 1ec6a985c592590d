#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "integration/model_editor.h"
#include "integration/model_projection.h"

namespace vantage {

/// Removes surface of the model that a view has seen better (Turk & Levoy 1994, 3.1): triangles that lie on the view's
/// surface, or that the view has seen through, and whose mean quality is lower than the view's there by more than the
/// margin, one by one from the model's border inwards. A vertex's quality is the confidence of its own sample, halved
/// on its view's border. Small remainders that the view covers altogether go, too.
/// @param views by the model's provenance.
/// @return how many triangles went. @throws Cancelled
std::size_t removeRedundantTriangles(ModelEditor& editor, std::span<const ProjectedVertex> projected,
                                     std::span<const View> views, const ZipperOptions& options,
                                     const Progress& progress = {});

/// The triangles of a model that lie in a view's grid at the depth of its surface, by cell.
class OverlapIndex {
 public:
  /// @throws Cancelled
  OverlapIndex(const ModelEditor& editor, std::span<const ProjectedVertex> projected, const GridSurface& surface,
               const Progress& progress = {});

  [[nodiscard]] std::span<const std::array<PlanePoint, 3>> triangles() const { return triangles_; }

  /// Whether a triangle of the plane has inner points in common with one of them.
  [[nodiscard]] bool overlaps(const PlanePoint (&t)[3]) const;

 private:
  const GridSurface& surface_;
  std::vector<std::array<PlanePoint, 3>> triangles_;  // counter-clockwise
  std::vector<std::uint32_t> start_;                  // per cell
  std::vector<std::uint32_t> entries_;
};

/// What is left of a view's mesh when the surface that the model already has is taken away.
struct ViewCut {
  std::vector<std::uint8_t> vertexKept;    ///< per vertex: not covered by the model, nor too near its border
  std::vector<std::uint8_t> triangleKept;  ///< per triangle: corners kept, no overlap with the model
};

/// Removes the view's triangles that overlap the model, and its vertices within `clearance` of the model's border.
/// @throws Cancelled
[[nodiscard]] ViewCut cutView(const ModelEditor& editor, std::span<const ProjectedVertex> projected,
                              const GridSurface& surface, const OverlapIndex& overlap, const ZipperOptions& options,
                              const Progress& progress = {});

}  // namespace vantage
