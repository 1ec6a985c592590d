#pragma once

#include <QImage>

class vtkGenericOpenGLRenderWindow;

namespace vantage {

/// Sets up a window whose OpenGL context somebody else owns and has made current.
void initialiseForeignWindow(vtkGenericOpenGLRenderWindow& window);

/// The window's last picture, opaque. Its context must be current.
[[nodiscard]] QImage readPicture(vtkGenericOpenGLRenderWindow& window);

}  // namespace vantage
