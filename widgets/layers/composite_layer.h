#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "composites/ray_witness.h"
#include "layers/model_geometry.h"
#include "vtk/scene.h"

namespace vantage {

/// The colour of surface of a composite by what it is to another one; nothing where that has no say.
[[nodiscard]] std::optional<Rgb> placeColour(PlaceWord word);

/// The surface of a composite in a scene, anywhere, painted by what it is to another composite.
class CompositeLayer {
 public:
  explicit CompositeLayer(Scene& scene);

  /// @param geometry null for none
  /// @param words per vertex of the model; empty: all in the layer's colour
  void set(std::shared_ptr<const ModelGeometry> geometry, std::vector<PlaceWord> words);
  void setPose(const Pose& T_scene_composite);
  void setColour(const Rgb& colour);
  void setMoving(bool moving);

  [[nodiscard]] const ModelGeometry* geometry() const { return geometry_.get(); }
  [[nodiscard]] BoundingBox box() const;  ///< in the scene @pre it has a geometry
  [[nodiscard]] Vec3 toScene(const Vec3& p) const { return T_scene_composite_ * p; }
  /// Where a line of the scene meets it first, in coordinates of the composite.
  [[nodiscard]] std::optional<Vec3> meets(const Vec3& origin, const Vec3& direction) const;

 private:
  void paint();
  void update();

  Scene& scene_;
  std::shared_ptr<const ModelGeometry> geometry_;
  std::vector<PlaceWord> words_;
  Pose T_scene_composite_ = Pose::Identity();
  Rgb colour_{};
  vtkSmartPointer<vtkActor> surface_;
  vtkSmartPointer<vtkActor> coarse_;
  bool moving_ = false;
};

}  // namespace vantage
