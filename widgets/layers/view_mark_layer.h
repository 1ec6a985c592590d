#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "layers/model_geometry.h"
#include "vtk/scene.h"

namespace vantage {

/// What one view brought to the model, or another part of it, lit up on its surface.
class ViewMarkLayer {
 public:
  explicit ViewMarkLayer(Scene& scene);

  /// @param view of the model, as it counts them; nothing marks nothing
  void set(const std::shared_ptr<const ModelGeometry>& geometry, std::optional<std::uint32_t> view);
  /// @param part of the model's surface; null marks nothing
  void setPart(const std::shared_ptr<const Mesh>& part);
  void setTheme(const Theme& theme);
  /// From now on, whatever the theme.
  void setColour(const Rgb& colour);

 private:
  void show(const Mesh& marked);

  Scene& scene_;
  vtkSmartPointer<vtkActor> surface_;
};

/// The triangles that a view added.
[[nodiscard]] Mesh surfaceOfView(const Model& model, std::uint32_t view);

}  // namespace vantage
