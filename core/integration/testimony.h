#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "integration/model_projection.h"

namespace vantage {

/// What views say about a piece of surface.
struct Testimony {
  double whole = 0.0;    ///< its area [mm^2]
  double seen = 0.0;     ///< of that where a view has measured surface
  double refuted = 0.0;  ///< and where one has looked through it that sees the place better than those who see surface
};

/// The views of a model as witnesses: asked whether they have measured something that is to become surface.
class Witnesses {
 public:
  /// @throws InvalidInput when a view lacks its pieces; Cancelled
  Witnesses(std::span<const View> views, const ZipperOptions& options, const Progress& progress);

  /// About triangles between vertices of a model, asked at their centres, facing the way that was measured at their
  /// corners. A view has measured surface there when its own lies within the tolerance of zippering and does not turn
  /// its back, or when the sample of the nearest ray lies there.
  [[nodiscard]] Testimony ask(const Model& model, std::span<const Triangle> triangles) const;

  /// The normal that was measured at a sample, in object coordinates; zero where its view has no surface.
  [[nodiscard]] Vec3 normal(std::uint32_t view, std::uint32_t sample) const;
  [[nodiscard]] double spacing(std::uint32_t view) const { return views_[view].mesh->spacing; }

 private:
  struct Qualities {
    double seen = 0.0;
    double refuted = 0.0;
  };
  [[nodiscard]] Qualities at(const Vec3& place, const Vec3& normal) const;
  [[nodiscard]] bool hasSample(std::size_t view, const ProjectedVertex& seen, const Vec3& place) const;

  std::span<const View> views_;
  double margin_;
  std::vector<std::optional<GridSurface>> surfaces_;
  std::vector<VertexProjector> projectors_;
};

}  // namespace vantage
