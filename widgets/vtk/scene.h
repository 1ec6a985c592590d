#pragma once

#include <vtkSmartPointer.h>

#include <QSize>
#include <vector>

#include "look/theme.h"
#include "vtk/camera.h"

class vtkActor;
class vtkProp;
class vtkRenderer;

namespace vantage {

/// What there is to draw: actors, light, background and camera. Knows no window; a RenderSurface or an OffscreenWindow
/// draws it.
class Scene {
 public:
  Scene();
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] vtkRenderer& renderer();

  void add(vtkProp& prop);
  /// Adds an actor of lines, `width` device-independent pixels wide.
  void addLines(vtkActor& actor, double width);

  /// While the camera moves pictures are drawn without smoothed edges: in software those take
  /// as long as the rest.
  void setMoving(bool moving);
  void setTheme(const Theme& theme);
  [[nodiscard]] const Camera& camera() const { return camera_; }
  void setCamera(const Camera& camera);

  /// To be called before drawing: device pixels per device-independent pixel, and clipping planes.
  void prepare(double pixelRatio);

 private:
  struct Line {
    vtkSmartPointer<vtkActor> actor;
    double width;
  };

  vtkSmartPointer<vtkRenderer> renderer_;
  std::vector<Line> lines_;
  Camera camera_;
};

}  // namespace vantage
