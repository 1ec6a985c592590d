#include "vtk/context_window.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

// The window's last picture, opaque. Its rows run upward.
QImage readPicture(vtkGenericOpenGLRenderWindow& window) {
  const int width = window.GetSize()[0];
  const int height = window.GetSize()[1];
  const auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels.Get(), 0);
  QImage image(width, height, QImage::Format_RGB888);
  const vtkIdType rowBytes = 3 * static_cast<vtkIdType>(width);
  for (vtkIdType y = 0; y < height; ++y)
    std::memcpy(image.scanLine(height - 1 - static_cast<int>(y)), pixels->GetPointer(y * rowBytes),
                static_cast<std::size_t>(rowBytes));
  return image;
}

class ContextWindow final : public OffscreenWindow {
 public:
  explicit ContextWindow(std::unique_ptr<DrawingContext> context)
      : context_(std::move(context)), window_(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()) {
    window_->SetMultiSamples(0);
    window_->SetSupportsOpenGL(1);
    window_->SetIsDirect(1);
    // VTK draws into framebuffers of its own and the picture is read from there: the context's is never seen.
    window_->SetFrameBlitModeToNoBlit();
    window_->SetReadyForRendering(false);
    observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* self, void*) {
      (void)static_cast<ContextWindow*>(self)->context_->makeCurrent();
    });
    observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void* answer) {
      *static_cast<bool*>(answer) = static_cast<ContextWindow*>(self)->context_->isCurrent();
    });
  }

  ~ContextWindow() override { ContextWindow::release(); }
  ContextWindow(const ContextWindow&) = delete;
  ContextWindow& operator=(const ContextWindow&) = delete;

  QImage render(Scene& scene, const Camera& camera, const QSize& pixels, double pixelRatio) override {
    initialise();
    show(&scene.renderer());
    window_->SetSize(pixels.width(), pixels.height());
    scene.prepare(camera, pixelRatio);
    window_->Render();
    QImage image = readPicture(*window_);
    image.setDevicePixelRatio(pixelRatio);
    return image;
  }

  void release() override {
    if (!window_->GetReadyForRendering()) return;
    if (context_->makeCurrent()) window_->Finalize();
    show(nullptr);
    window_->SetReadyForRendering(false);
    context_->release();
  }

 private:
  void initialise() {
    if (!context_->makeCurrent()) throw DeviceError("there is no OpenGL 3.2 on this computer to draw pictures with");
    if (window_->GetReadyForRendering()) return;
    window_->SetReadyForRendering(true);
    window_->SetOwnContext(0);
    window_->SetIsCurrent(true);
    window_->OpenGLInit();
  }

  void show(vtkRenderer* renderer) {
    if (shown_ == renderer) return;
    if (shown_ != nullptr) {
      shown_->ReleaseGraphicsResources(window_);
      window_->RemoveRenderer(shown_);
    }
    shown_ = renderer;
    if (renderer != nullptr) window_->AddRenderer(renderer);
  }

  void observe(unsigned long event, void (*callback)(vtkObject*, unsigned long, void*, void*)) {
    const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
    command->SetClientData(this);
    command->SetCallback(callback);
    window_->AddObserver(event, command);
  }

  std::unique_ptr<DrawingContext> context_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> shown_;
};

}  // namespace

std::unique_ptr<OffscreenWindow> windowIn(std::unique_ptr<DrawingContext> context) {
  return std::make_unique<ContextWindow>(std::move(context));
}

}  // namespace vantage
