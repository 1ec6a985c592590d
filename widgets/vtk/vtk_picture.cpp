#include "vtk/vtk_picture.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>

namespace vantage {

void initialiseForeignWindow(vtkGenericOpenGLRenderWindow& window) {
  window.SetReadyForRendering(true);
  window.SetOwnContext(0);
  window.SetIsCurrent(true);
  window.OpenGLInit();
}

QImage readPicture(vtkGenericOpenGLRenderWindow& window) {
  const int width = window.GetSize()[0];
  const int height = window.GetSize()[1];
  const auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels.Get(), 0);
  QImage image(width, height, QImage::Format_RGB888);
  const auto rowBytes = static_cast<std::size_t>(width) * 3;
  for (int y = 0; y < height; ++y)
    std::memcpy(image.scanLine(height - 1 - y), pixels->GetPointer(static_cast<vtkIdType>(y * rowBytes)), rowBytes);
  return image;
}

}  // namespace vantage
