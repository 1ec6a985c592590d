#include "views/scene_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTimerEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "scenes/camera_marks.h"

namespace vantage {
namespace {

// After so long without a movement the scene is drawn in full [ms].
constexpr int kRest = 250;
// A press that moves no farther is a click [px].
constexpr double kClick = 3.0;
// What one press of an arrow key drags, as a share of the height.
constexpr double kKeyTurn = 1.0 / 24.0;

}  // namespace

// What is written over the scene. A widget of its own, so that it looks the same over any surface.
class SceneView::OverlayWidget final : public QWidget {
 public:
  explicit OverlayWidget(QWidget* parent) : QWidget(parent), theme_(&lightTheme()) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
  }

  void set(Overlay overlay) {
    overlay_ = std::move(overlay);
    update();
  }
  void setTheme(const Theme& theme) {
    theme_ = &theme;
    update();
  }
  void setCamera(const Camera& camera) {
    camera_ = camera;
    update();
  }
  void writeOn(QImage& picture, const Camera& camera) const {
    if (picture.isNull()) return;
    // Paint blends alike on pictures of any surface.
    picture.convertTo(QImage::Format_RGB32);
    QPainter painter(&picture);
    const QRectF area(QPointF(), picture.deviceIndependentSize());
    paintCameraMarks(painter, area, camera, *theme_);
    paintOverlay(painter, area, overlay_, *theme_);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    paintCameraMarks(painter, rect(), camera_, *theme_);
    paintOverlay(painter, rect(), overlay_, *theme_);
    if (!parentWidget()->hasFocus()) return;
    painter.setPen(QPen(theme_->current, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
  }

 private:
  Overlay overlay_;
  Camera camera_;
  const Theme* theme_;
};

SceneView::SceneView(QWidget* parent) : QWidget(parent), overlay_(new OverlayWidget(this)), theme_(&lightTheme()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
}

SceneView::~SceneView() = default;

void SceneView::attach(Scene& scene, const SurfaceMaker& surfaces) {
  scene_ = &scene;
  surface_ = surfaces(scene, *this);
  surface_->widget().setGeometry(rect());
  overlay_->raise();
}

void SceneView::detach() {
  surface_.reset();
  scene_ = nullptr;
}

void SceneView::setTheme(const Theme& theme) {
  theme_ = &theme;
  overlay_->setTheme(theme);
  redraw();
}

const Camera& SceneView::camera() const {
  return scene_->camera();
}

void SceneView::setCamera(const Camera& camera) {
  Camera set = camera;
  set.parallel = parallel_;
  scene_->setCamera(set);
  overlay_->setCamera(set);
  redraw();
  emit cameraChanged();
}

void SceneView::setParallel(bool parallel) {
  if (parallel == parallel_) return;
  parallel_ = parallel;
  setCamera(camera());
}

double SceneView::aspect() const {
  return width() / std::max(1.0, static_cast<double>(height()));
}

void SceneView::lookFrom(CameraPreset preset) {
  setCamera(cameraFor(preset, aspect()));
}

void SceneView::takePictures(const std::vector<CameraPreset>& presets, const Taken& taken) {
  const auto pictures = std::make_shared<std::vector<QImage>>();
  for (const CameraPreset preset : presets) {
    Camera camera = cameraFor(preset, aspect());
    camera.parallel = parallel_;
    surface_->takePicture(camera, [this, camera, pictures, taken, wanted = presets.size()](QImage picture) {
      overlay_->writeOn(picture, camera);
      pictures->push_back(std::move(picture));
      if (pictures->size() == wanted) taken(*pictures);
    });
  }
}

void SceneView::setOverlay(Overlay overlay) {
  setAccessibleDescription(overlay.notes.join(QStringLiteral(", ")));
  overlay_->set(std::move(overlay));
}

void SceneView::redraw() {
  if (surface_) surface_->update();
}

void SceneView::resizeEvent(QResizeEvent*) {
  if (surface_) surface_->widget().setGeometry(rect());
  overlay_->setGeometry(rect());
}

SightLine SceneView::lineAt(const QPointF& point) const {
  return sightLine(scene_->camera(), point, size());
}

void SceneView::apply(const Camera& camera) {
  beginMoving();
  setCamera(camera);
}

void SceneView::beginMoving() {
  if (restTimer_ != 0) killTimer(restTimer_);
  restTimer_ = startTimer(kRest);
  if (moving_) return;
  moving_ = true;
  movingChanged(true);
}

void SceneView::endMoving() {
  if (restTimer_ != 0) killTimer(restTimer_);
  restTimer_ = 0;
  if (!moving_) return;
  moving_ = false;
  movingChanged(false);
  redraw();
}

void SceneView::timerEvent(QTimerEvent* event) {
  if (event->timerId() != restTimer_) return QWidget::timerEvent(event);
  // A held button may go on to drag.
  if (motion_ == Motion::None) endMoving();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  motion_ = motionFor(navigation_, event->button(), event->modifiers());
  pressed_ = last_ = event->position();
  dragged_ = false;
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  if (scene_ == nullptr) return;
  if (event->buttons() == Qt::NoButton) return hovered(lineAt(event->position()));
  const QPointF offset = event->position() - pressed_;
  dragged_ = dragged_ || std::hypot(offset.x(), offset.y()) > kClick;
  if (!dragged_ || motion_ == Motion::None) return;
  apply(moved(scene_->camera(), motion_, last_, event->position(), size()));
  last_ = event->position();
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  const bool click = !dragged_ && event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
  motion_ = Motion::None;
  endMoving();
  if (click && scene_ != nullptr) picked(lineAt(event->position()));
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (scene_ == nullptr || event->button() != Qt::LeftButton) return;
  Camera camera = scene_->camera();
  const Vec3 centre = centreOf(lineAt(event->position()));
  camera.eye += centre - camera.target;
  camera.target = centre;
  setCamera(camera);
}

void SceneView::wheelEvent(QWheelEvent* event) {
  constexpr double kStep = 120.0;
  if (scene_ != nullptr) apply(zoomed(scene_->camera(), event->angleDelta().y() / kStep));
  event->accept();
}

void SceneView::leaveEvent(QEvent*) {
  hoverLeft();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (scene_ == nullptr) return QWidget::keyPressEvent(event);
  const auto turnBy = [&](double x, double y) {
    const QPointF drag = QPointF(x, y) * (kKeyTurn * height());
    apply(moved(scene_->camera(), Motion::Turntable, {}, drag, size()));
  };
  switch (event->key()) {
    case Qt::Key_1:
      return lookFrom(CameraPreset::Front);
    case Qt::Key_2:
      return lookFrom(CameraPreset::Top);
    case Qt::Key_3:
      return lookFrom(CameraPreset::ScannersEye);
    case Qt::Key_4:
      return lookFrom(CameraPreset::Oblique);
    case Qt::Key_F:
      return lookFrom(event->modifiers() == Qt::ShiftModifier ? CameraPreset::Everything : CameraPreset::Fit);
    case Qt::Key_Home:
      return lookFrom(CameraPreset::Oblique);
    case Qt::Key_Left:
      return turnBy(-1.0, 0.0);
    case Qt::Key_Right:
      return turnBy(1.0, 0.0);
    case Qt::Key_Up:
      return turnBy(0.0, -1.0);
    case Qt::Key_Down:
      return turnBy(0.0, 1.0);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return apply(zoomed(scene_->camera(), 1.0));
    case Qt::Key_Minus:
      return apply(zoomed(scene_->camera(), -1.0));
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace vantage
