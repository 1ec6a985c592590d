#pragma once

#include <memory>

#include "vtk/render_surface.h"

namespace vantage {

/// An OpenGL context of somebody's, used from one thread. It is made when it is first asked for, on that thread.
class DrawingContext {
 public:
  DrawingContext() = default;
  virtual ~DrawingContext() = default;
  DrawingContext(const DrawingContext&) = delete;
  DrawingContext& operator=(const DrawingContext&) = delete;

  /// Whether it is the thread's context now; false when there is no OpenGL 3.2.
  [[nodiscard]] virtual bool makeCurrent() = 0;
  [[nodiscard]] virtual bool isCurrent() const = 0;
  virtual void release() = 0;
};

/// A window of VTK that draws into memory in a context.
[[nodiscard]] std::unique_ptr<OffscreenWindow> windowIn(std::unique_ptr<DrawingContext> context);

}  // namespace vantage
