#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "look/legend.h"
#include "look/theme.h"
#include "vtk/navigation.h"
#include "vtk/render_surface.h"

namespace vantage {

/// A widget that shows a scene and lets the mouse and keyboard move about in it: 1 front, 2 top, 3 scanner's eye, F
/// fit, with shift everything, Home the first sight, arrows turn, plus and minus zoom. A click that moves nothing is a
/// pick.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  void setNavigation(NavigationScheme scheme) { navigation_ = scheme; }
  [[nodiscard]] NavigationScheme navigation() const { return navigation_; }
  virtual void setTheme(const Theme& theme);
  void lookFrom(CameraPreset preset);
  [[nodiscard]] const Camera& camera() const;
  void setCamera(const Camera& camera);
  /// Projects in parallel from now on, whatever the camera is set to, or in perspective again.
  void setParallel(bool parallel);

  using Taken = std::function<void(const std::vector<QImage>& pictures)>;
  /// Takes pictures from some sides with what is written over them; the camera stays where it is. They are handed over
  /// when all are there, at once or later, but not when the view is gone by then. One that cannot be drawn is null.
  void takePictures(const std::vector<CameraPreset>& presets, const Taken& taken);

  [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

 signals:
  void cameraChanged();

 protected:
  /// The line under a point of the widget.
  [[nodiscard]] SightLine lineAt(const QPointF& point) const;
  /// To be called once, when the scene is there. @param scene must outlive the surface.
  void attach(Scene& scene, const SurfaceMaker& surfaces);
  void detach();  ///< before the scene goes
  void setOverlay(Overlay overlay);
  void redraw();
  [[nodiscard]] const Theme& theme() const { return *theme_; }

  [[nodiscard]] virtual Camera cameraFor(CameraPreset preset, double aspect) const = 0;
  virtual void picked(const SightLine& line) = 0;
  virtual void hovered(const SightLine& line) = 0;
  virtual void hoverLeft() = 0;
  virtual void movingChanged(bool moving) = 0;                           ///< the camera begins or ends to move
  [[nodiscard]] virtual Vec3 centreOf(const SightLine& line) const = 0;  ///< what a double click turns about

  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void timerEvent(QTimerEvent* event) override;

 private:
  class OverlayWidget;

  [[nodiscard]] double aspect() const;
  void beginMoving();
  void endMoving();
  void apply(const Camera& camera);

  Scene* scene_ = nullptr;
  std::unique_ptr<RenderSurface> surface_;
  OverlayWidget* overlay_;
  const Theme* theme_;
  NavigationScheme navigation_ = NavigationScheme::Upright;
  Motion motion_ = Motion::None;
  QPointF pressed_;
  QPointF last_;
  bool dragged_ = false;
  bool moving_ = false;
  bool parallel_ = false;
  int restTimer_ = 0;
};

}  // namespace vantage
