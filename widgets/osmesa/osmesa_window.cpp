#include "osmesa/osmesa_window.h"

#include <GL/osmesa.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <array>

#include "base/errors.h"
#include "vtk/vtk_picture.h"

namespace vantage {
namespace {

// An OpenGL context of its own. VTK draws into its own framebuffers, so that the context's buffer is never seen.
class Context {
 public:
  Context() {
    constexpr std::array kAttributes{OSMESA_FORMAT,
                                     static_cast<int>(OSMESA_RGBA),
                                     OSMESA_DEPTH_BITS,
                                     24,
                                     OSMESA_STENCIL_BITS,
                                     8,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     2,
                                     0};
    context_ = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
    if (context_ == nullptr) throw DeviceError("OSMesa gives no OpenGL 3.2 context to draw pictures with");
  }
  ~Context() { OSMesaDestroyContext(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void makeCurrent() {
    if (OSMesaGetCurrentContext() == context_) return;
    if (OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_FALSE)
      throw DeviceError("OSMesa cannot make its context current");
  }
  [[nodiscard]] bool isCurrent() const { return OSMesaGetCurrentContext() == context_; }

 private:
  static constexpr int kSide = 16;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4UL * kSide * kSide> buffer_{};
};

class OsmesaWindow final : public OffscreenWindow {
 public:
  OsmesaWindow() : window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()) {
    window_->SetMultiSamples(0);
    window_->SetSupportsOpenGL(1);
    window_->SetIsDirect(1);
    observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* self, void*) {
      static_cast<OsmesaWindow*>(self)->context_.makeCurrent();
    });
    observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void* answer) {
      *static_cast<bool*>(answer) = static_cast<OsmesaWindow*>(self)->context_.isCurrent();
    });
    context_.makeCurrent();
    initialiseForeignWindow(*window_);
  }

  ~OsmesaWindow() override {
    context_.makeCurrent();
    window_->Finalize();
  }
  OsmesaWindow(const OsmesaWindow&) = delete;
  OsmesaWindow& operator=(const OsmesaWindow&) = delete;

  QImage render(Scene& scene, const QSize& pixels, double pixelRatio) override {
    context_.makeCurrent();
    show(scene.renderer());
    window_->SetSize(pixels.width(), pixels.height());
    scene.prepare(pixelRatio);
    window_->Render();
    QImage image = readPicture(*window_);
    image.setDevicePixelRatio(pixelRatio);
    return image;
  }

 private:
  void show(vtkRenderer& renderer) {
    if (shown_ == &renderer) return;
    if (shown_ != nullptr) {
      shown_->ReleaseGraphicsResources(window_);
      window_->RemoveRenderer(shown_);
    }
    shown_ = &renderer;
    window_->AddRenderer(&renderer);
  }

  void observe(unsigned long event, void (*callback)(vtkObject*, unsigned long, void*, void*)) {
    const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
    command->SetClientData(this);
    command->SetCallback(callback);
    window_->AddObserver(event, command);
  }

  Context context_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> shown_;
};

}  // namespace

OffscreenMaker osmesaWindows() {
  return [] { return std::make_unique<OsmesaWindow>(); };
}

}  // namespace vantage
