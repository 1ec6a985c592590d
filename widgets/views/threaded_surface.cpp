#include "views/threaded_surface.h"

#include <QLinearGradient>
#include <QPainter>
#include <QWidget>
#include <exception>
#include <mutex>
#include <utility>

namespace vantage {
namespace {

// What a picture is to show.
struct Shot {
  Camera camera;
  QSize pixels;  // empty: nobody looks, no picture
  double pixelRatio = 1.0;
};

class ThreadedWidget final : public QWidget {
 public:
  ThreadedWidget(Scene& scene, QWidget& parent, std::shared_ptr<RenderThread> thread,
                 std::unique_ptr<OffscreenWindow> window)
      : QWidget(&parent), scene_(scene), thread_(std::move(thread)), window_(std::move(window)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    scene_.deferChanges(true);
  }

  ~ThreadedWidget() override {
    {
      const std::lock_guard lock(mutex_);
      wanted_.pixels = QSize();
    }
    thread_->finish([this] { window_->release(); });
    scene_.deferChanges(false);
  }
  ThreadedWidget(const ThreadedWidget&) = delete;
  ThreadedWidget& operator=(const ThreadedWidget&) = delete;

  // Wants a picture of the scene as it is. What is wanted already is only brought up to date.
  void request() {
    {
      const std::lock_guard lock(mutex_);
      wanted_ = shotFrom(scene_.camera());
      if (!isVisible()) wanted_.pixels = QSize();
      if (std::exchange(queued_, true)) return;
    }
    thread_->post([this] { draw(); });
  }

  void take(const Camera& camera, const RenderSurface::Taken& taken) {
    thread_->post([this, shot = shotFrom(camera), taken] {
      const Drawn drawn = drawnFrom(shot);
      QMetaObject::invokeMethod(
          this, [drawn, taken] { taken(drawn.picture); }, Qt::QueuedConnection);
    });
  }

 protected:
  // Also when it becomes larger, or finer on another screen.
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const Shot now = shotFrom(scene_.camera());
    const bool fits = picture_.size() == now.pixels && picture_.devicePixelRatio() == now.pixelRatio;
    if (!failure_.isEmpty()) return paintFailure(painter);
    if (picture_.isNull())
      paintBackground(painter);
    else if (fits)
      painter.drawImage(QPointF(), picture_);
    else
      paintStretched(painter);
    if (!fits) request();
  }

  // While it was hidden nothing was drawn.
  void showEvent(QShowEvent*) override { request(); }

 private:
  struct Drawn {
    QImage picture;
    QString failure;
  };

  [[nodiscard]] Shot shotFrom(const Camera& camera) const {
    return {camera, (QSizeF(size()) * devicePixelRatioF()).toSize(), devicePixelRatioF()};
  }

  // On the render thread.
  void draw() {
    Shot shot;
    {
      const std::lock_guard lock(mutex_);
      shot = wanted_;
      queued_ = false;
    }
    const Drawn drawn = drawnFrom(shot);
    if (!shot.pixels.isEmpty())
      QMetaObject::invokeMethod(
          this, [this, drawn] { show(drawn); }, Qt::QueuedConnection);
  }

  // On the render thread. The picture is made as the screen takes it, so that painting it is a copy.
  [[nodiscard]] Drawn drawnFrom(const Shot& shot) {
    try {
      if (!shot.pixels.isEmpty())
        return {
            window_->render(scene_, shot.camera, shot.pixels, shot.pixelRatio).convertToFormat(QImage::Format_RGB32),
            {}};
      scene_.prepare(shot.camera, shot.pixelRatio);
      return {};
    } catch (const std::exception& e) {
      return {{}, QString::fromUtf8(e.what())};
    }
  }

  void show(const Drawn& drawn) {
    picture_ = drawn.picture;
    failure_ = drawn.failure;
    update();
  }

  void paintBackground(QPainter& painter) const {
    QLinearGradient gradient(rect().topLeft(), rect().bottomLeft());
    gradient.setColorAt(0.0, scene_.theme().backgroundTop);
    gradient.setColorAt(1.0, scene_.theme().backgroundBottom);
    painter.fillRect(rect(), gradient);
  }

  // A picture shows as much as its height has room for: it keeps its shape, and beside it is its background.
  void paintStretched(QPainter& painter) const {
    paintBackground(painter);
    const double width = static_cast<double>(height()) * picture_.width() / picture_.height();
    painter.drawImage(QRectF(0.5 * (this->width() - width), 0.0, width, height()), picture_);
  }

  void paintFailure(QPainter& painter) const {
    paintBackground(painter);
    painter.setPen(scene_.theme().text);
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, failure_);
  }

  Scene& scene_;
  std::shared_ptr<RenderThread> thread_;
  std::unique_ptr<OffscreenWindow> window_;  // of the render thread
  std::mutex mutex_;
  Shot wanted_;          // under the mutex
  bool queued_ = false;  // under the mutex: wanted_ has not been taken yet
  QImage picture_;
  QString failure_;
};

class ThreadedSurface final : public RenderSurface {
 public:
  explicit ThreadedSurface(std::unique_ptr<ThreadedWidget> widget) : widget_(std::move(widget)) {}

  QWidget& widget() override { return *widget_; }
  void update() override { widget_->request(); }
  void takePicture(const Camera& camera, const Taken& taken) override { widget_->take(camera, taken); }

 private:
  std::unique_ptr<ThreadedWidget> widget_;
};

}  // namespace

SurfaceMaker threadedSurfaces(std::shared_ptr<RenderThread> thread, OffscreenMaker maker) {
  return [thread = std::move(thread), maker = std::move(maker)](Scene& scene,
                                                                QWidget& parent) -> std::unique_ptr<RenderSurface> {
    return std::make_unique<ThreadedSurface>(std::make_unique<ThreadedWidget>(scene, parent, thread, maker()));
  };
}

}  // namespace vantage
