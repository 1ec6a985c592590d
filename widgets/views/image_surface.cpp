#include <QPainter>
#include <QWidget>

#include "vtk/render_surface.h"

namespace vantage {
namespace {

// Paints the image of an offscreen window. Draws only when something has changed since the last painting.
class ImageWidget final : public QWidget {
 public:
  ImageWidget(Scene& scene, std::unique_ptr<OffscreenWindow> window, QWidget& parent)
      : QWidget(&parent), scene_(scene), window_(std::move(window)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
  }

  void draw() {
    image_ = QImage();
    update();
  }
  [[nodiscard]] QImage picture(const Camera& camera) {
    return pixels().isEmpty() ? QImage() : window_->render(scene_, camera, pixels(), devicePixelRatioF());
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    if (pixels().isEmpty()) return;
    if (image_.size() != pixels() || image_.devicePixelRatio() != devicePixelRatioF())
      image_ = picture(scene_.camera());
    QPainter(this).drawImage(QPointF(), image_);
  }

 private:
  [[nodiscard]] QSize pixels() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }

  Scene& scene_;
  std::unique_ptr<OffscreenWindow> window_;
  QImage image_;
};

class ImageSurface final : public RenderSurface {
 public:
  ImageSurface(Scene& scene, std::unique_ptr<OffscreenWindow> window, QWidget& parent)
      : widget_(new ImageWidget(scene, std::move(window), parent)) {}
  ~ImageSurface() override { delete widget_; }
  ImageSurface(const ImageSurface&) = delete;
  ImageSurface& operator=(const ImageSurface&) = delete;

  QWidget& widget() override { return *widget_; }
  void update() override { widget_->draw(); }
  void takePicture(const Camera& camera, const Taken& taken) override { taken(widget_->picture(camera)); }

 private:
  ImageWidget* widget_;
};

}  // namespace

SurfaceMaker imageSurfaces(OffscreenMaker maker) {
  return [maker = std::move(maker)](Scene& scene, QWidget& parent) -> std::unique_ptr<RenderSurface> {
    return std::make_unique<ImageSurface>(scene, maker(), parent);
  };
}

}  // namespace vantage
