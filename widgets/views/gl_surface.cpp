#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "views/threaded_surface.h"
#include "vtk/context_window.h"

namespace vantage {
namespace {

constexpr int kMajor = 3;
constexpr int kMinor = 2;

QSurfaceFormat glFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(kMajor, kMinor);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(0);
  return format;
}

// A context of the desktop's OpenGL. Its surface belongs to the UI thread, on which it is made and destroyed; the
// context to the thread that draws.
class DesktopContext final : public DrawingContext {
 public:
  DesktopContext() {
    surface_.setFormat(glFormat());
    surface_.create();
  }

  bool makeCurrent() override {
    if (isCurrent()) return true;
    if (!context_) context_ = made();
    return context_ && context_->makeCurrent(&surface_);
  }
  bool isCurrent() const override { return context_ && QOpenGLContext::currentContext() == context_.get(); }
  void release() override { context_.reset(); }

 private:
  static std::unique_ptr<QOpenGLContext> made() {
    auto context = std::make_unique<QOpenGLContext>();
    context->setFormat(glFormat());
    const bool enough = context->create() && context->format().version() >= std::pair(kMajor, kMinor);
    return enough ? std::move(context) : nullptr;
  }

  QOffscreenSurface surface_;
  std::unique_ptr<QOpenGLContext> context_;
};

}  // namespace

SurfaceMaker glSurfaces() {
  return threadedSurfaces(std::make_shared<RenderThread>(QOpenGLContext::supportsThreadedOpenGL()),
                          [] { return windowIn(std::make_unique<DesktopContext>()); });
}

}  // namespace vantage
