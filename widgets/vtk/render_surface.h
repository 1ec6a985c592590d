#pragma once

#include <QImage>
#include <functional>
#include <memory>

#include "vtk/scene.h"

class QWidget;

namespace vantage {

/// Draws scenes into memory, without a display. To be used from one thread.
class OffscreenWindow {
 public:
  OffscreenWindow() = default;
  virtual ~OffscreenWindow() = default;
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  /// The scene as a picture of that many device pixels. The same scene gives the same bytes.
  /// @throws DeviceError when there is no OpenGL 3.2.
  [[nodiscard]] virtual QImage render(Scene& scene, const Camera& camera, const QSize& pixels, double pixelRatio) = 0;
  /// Gives back what it holds of the graphics card. To be called on the thread that drew, before another destroys it.
  virtual void release() = 0;
};
using OffscreenMaker = std::function<std::unique_ptr<OffscreenWindow>()>;

/// Where a view shows its scene. Lives on the UI thread.
class RenderSurface {
 public:
  /// Gets a picture, null when it could not be drawn.
  using Taken = std::function<void(const QImage& picture)>;

  RenderSurface() = default;
  virtual ~RenderSurface() = default;
  RenderSurface(const RenderSurface&) = delete;
  RenderSurface& operator=(const RenderSurface&) = delete;

  /// The widget that shows it, a child of the parent it was made for; it leaves the mouse to the parent.
  [[nodiscard]] virtual QWidget& widget() = 0;
  /// Draws again soon.
  virtual void update() = 0;
  /// Draws a picture of the widget's size from another camera, and hands it over on the UI thread: at once or later,
  /// but not when the surface is gone by then.
  virtual void takePicture(const Camera& camera, const Taken& taken) = 0;
};

/// Makes a surface for a scene, which must outlive it.
using SurfaceMaker = std::function<std::unique_ptr<RenderSurface>(Scene& scene, QWidget& parent)>;

/// Surfaces of the desktop: drawn with OpenGL on a thread that they share, so that the UI thread never waits for a
/// picture. Where OpenGL cannot leave the UI thread they are drawn there. To be called when there is an application.
[[nodiscard]] SurfaceMaker glSurfaces();

/// Surfaces that paint an image drawn without a display, on the UI thread and when it is painted.
[[nodiscard]] SurfaceMaker imageSurfaces(OffscreenMaker maker);

}  // namespace vantage
