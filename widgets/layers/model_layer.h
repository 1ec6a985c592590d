#pragma once

#include <memory>
#include <vector>

#include "geometry/vectors.h"
#include "layers/model_geometry.h"
#include "vtk/scene.h"

namespace vantage {

/// The model's surface and its boundary in a scene.
class ModelLayer {
 public:
  explicit ModelLayer(Scene& scene);

  /// @param geometry null for no model
  /// @param stands of the model's views, one for each, for colours by age and stand
  void set(std::shared_ptr<const ModelGeometry> geometry, ModelColouring colouring, std::vector<int> stands);
  /// Where the model is drawn, from its own coordinates to those of the scene.
  void setPose(const Pose& T_scene_model);
  void setVisible(bool surface, bool boundary);
  /// @param backFaces the inside of the surface is drawn in a colour of its own, whatever the outside is coloured by
  void setStyle(SurfaceStyle style, bool backFaces);
  /// Takes away what is before a plane, in the model's coordinates; nothing takes nothing away.
  void setSection(const std::optional<Section>& section);
  void setMoving(bool moving);
  void setTheme(const Theme& theme);

 private:
  void update();

  Scene& scene_;
  std::shared_ptr<const ModelGeometry> geometry_;
  vtkSmartPointer<vtkActor> surface_;
  vtkSmartPointer<vtkActor> coarse_;
  vtkSmartPointer<vtkActor> inside_;  ///< the back faces in their colour
  vtkSmartPointer<vtkActor> boundary_;
  ModelColouring colouring_ = ModelColouring::Plain;
  std::vector<int> stands_;
  bool surfaceVisible_ = true;
  bool boundaryVisible_ = true;
  bool moving_ = false;
  bool backFaces_ = false;
};

}  // namespace vantage
