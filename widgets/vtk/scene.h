#pragma once

#include <vtkSmartPointer.h>

#include <QSize>
#include <functional>
#include <mutex>
#include <vector>

#include "look/theme.h"
#include "vtk/camera.h"

class vtkActor;
class vtkProp;
class vtkRenderer;

namespace vantage {

/// What there is to draw: actors, light, background and camera. Knows no window; a RenderSurface or an OffscreenWindow
/// draws it. What VTK holds of it may be drawn on another thread than the one that the scene is used on: it is touched
/// in changes only.
class Scene {
 public:
  using Change = std::function<void()>;

  Scene();
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] vtkRenderer& renderer();

  /// To be called before anything draws the scene.
  void add(vtkProp& prop);
  /// Adds an actor of lines, `width` device-independent pixels wide.
  void addLines(vtkActor& actor, double width);

  /// Changes actors. Changes are carried out in order: at once, or, while they are deferred, before the next picture on
  /// the thread that draws it. Beside actors they may use only values of their own.
  void change(Change change);
  /// Ending it carries out what waits. @pre nothing draws meanwhile
  void deferChanges(bool defer);

  /// While the camera moves pictures are drawn without smoothed edges: in software those take
  /// as long as the rest.
  void setMoving(bool moving);
  void setTheme(const Theme& theme);
  [[nodiscard]] const Theme& theme() const { return *theme_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  void setCamera(const Camera& camera) { camera_ = camera; }

  /// To be called before drawing, on the thread that draws: carries out the changes that wait, and sets the camera and
  /// device pixels per device-independent pixel.
  void prepare(const Camera& camera, double pixelRatio);

 private:
  struct Line {
    vtkSmartPointer<vtkActor> actor;
    double width;
  };

  void carryOutChanges();

  vtkSmartPointer<vtkRenderer> renderer_;
  std::vector<Line> lines_;
  Camera camera_;
  const Theme* theme_;
  bool deferred_ = false;
  std::mutex mutex_;
  std::vector<Change> waiting_;  // under the mutex
};

}  // namespace vantage
