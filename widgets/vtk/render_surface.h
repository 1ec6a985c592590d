#pragma once

#include <QImage>
#include <functional>
#include <memory>

#include "vtk/scene.h"

class QWidget;

namespace vantage {

/// Draws scenes into memory, without a display.
class OffscreenWindow {
 public:
  OffscreenWindow() = default;
  virtual ~OffscreenWindow() = default;
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  /// The scene as a picture of that many device pixels. The same scene gives the same bytes.
  [[nodiscard]] virtual QImage render(Scene& scene, const QSize& pixels, double pixelRatio) = 0;
};
using OffscreenMaker = std::function<std::unique_ptr<OffscreenWindow>()>;

/// Where a view shows its scene.
class RenderSurface {
 public:
  RenderSurface() = default;
  virtual ~RenderSurface() = default;
  RenderSurface(const RenderSurface&) = delete;
  RenderSurface& operator=(const RenderSurface&) = delete;

  /// The widget that shows it, a child of the parent it was made for; it leaves the mouse to the parent.
  [[nodiscard]] virtual QWidget& widget() = 0;
  /// Draws again soon.
  virtual void update() = 0;
};

/// Makes a surface for a scene, which must outlive it.
using SurfaceMaker = std::function<std::unique_ptr<RenderSurface>(Scene& scene, QWidget& parent)>;

/// Surfaces of the desktop: OpenGL widgets.
[[nodiscard]] SurfaceMaker glSurfaces();

/// Surfaces that paint an image drawn without a display.
[[nodiscard]] SurfaceMaker imageSurfaces(OffscreenMaker maker);

}  // namespace vantage
