#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>
#include <QPointer>

#include "vtk/render_surface.h"
#include "vtk/vtk_picture.h"

namespace vantage {
namespace {

QSurfaceFormat glFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(0);
  return format;
}

// A window of VTK inside of an OpenGL widget. VTK draws into framebuffers of its own; the last one is copied to the
// widget's.
class GlWidget final : public QOpenGLWidget {
 public:
  GlWidget(Scene& scene, QWidget& parent)
      : QOpenGLWidget(&parent), scene_(scene), window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()) {
    setFormat(glFormat());
    setAttribute(Qt::WA_TransparentForMouseEvents);
    window_->SetMultiSamples(0);
    window_->SetFrameBlitModeToNoBlit();
    window_->SetSupportsOpenGL(1);
    window_->SetIsDirect(1);
    window_->AddRenderer(&scene.renderer());
    observe(vtkCommand::WindowMakeCurrentEvent,
            [](vtkObject*, unsigned long, void* self, void*) { static_cast<GlWidget*>(self)->becomeCurrent(); });
    observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void* answer) {
      *static_cast<bool*>(answer) = static_cast<GlWidget*>(self)->isCurrent();
    });
  }

  ~GlWidget() override {
    // The base class destroys the context, when there is nothing left here to be released.
    if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
    release();
    window_->RemoveRenderer(&scene_.renderer());
  }
  GlWidget(const GlWidget&) = delete;
  GlWidget& operator=(const GlWidget&) = delete;

 protected:
  void initializeGL() override {
    // The context is made anew when the widget moves to another window.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
    initialiseForeignWindow(*window_);
  }

  void paintGL() override {
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    window_->SetSize(pixels.width(), pixels.height());
    scene_.prepare(devicePixelRatioF());
    window_->SetIsCurrent(true);
    vtkOpenGLState& state = *window_->GetState();
    state.Reset();
    state.ResetFramebufferBindings();
    state.Push();
    state.vtkglDepthFunc(GL_LEQUAL);
    window_->Render();
    state.Pop();
    copyPicture(pixels);
  }

 private:
  void observe(unsigned long event, void (*callback)(vtkObject*, unsigned long, void*, void*)) {
    const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
    command->SetClientData(this);
    command->SetCallback(callback);
    window_->AddObserver(event, command);
  }

  [[nodiscard]] bool isCurrent() const { return QOpenGLContext::currentContext() == context(); }

  // makeCurrent() binds the widget's framebuffer: in the middle of a pass VTK would go on drawing into that.
  void becomeCurrent() {
    if (context() != nullptr && !isCurrent()) makeCurrent();
  }

  void copyPicture(const QSize& pixels) {
    QOpenGLExtraFunctions& gl = *context()->extraFunctions();
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, window_->GetDisplayFramebuffer()->GetFBOIndex());
    gl.glReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glBlitFramebuffer(0, 0, pixels.width(), pixels.height(), 0, 0, pixels.width(), pixels.height(),
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    // Qt blends the widget with what is below it: it must be opaque.
    gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl.glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    gl.glClear(GL_COLOR_BUFFER_BIT);
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }

  void release() {
    if (context() == nullptr || !window_->GetReadyForRendering()) return;
    becomeCurrent();
    window_->Finalize();
    window_->SetReadyForRendering(false);
  }

  Scene& scene_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
};

class GlSurface final : public RenderSurface {
 public:
  GlSurface(Scene& scene, QWidget& parent) : widget_(new GlWidget(scene, parent)) {}
  ~GlSurface() override { delete widget_; }
  GlSurface(const GlSurface&) = delete;
  GlSurface& operator=(const GlSurface&) = delete;

  QWidget& widget() override { return *widget_; }
  void update() override { widget_->update(); }

 private:
  GlWidget* widget_;
};

}  // namespace

SurfaceMaker glSurfaces() {
  return [](Scene& scene, QWidget& parent) -> std::unique_ptr<RenderSurface> {
    return std::make_unique<GlSurface>(scene, parent);
  };
}

}  // namespace vantage
