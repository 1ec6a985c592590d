#pragma once

#include <memory>

#include "views/render_thread.h"
#include "vtk/render_surface.h"

namespace vantage {

/// Surfaces whose scenes are drawn on a thread. Their widgets show the last picture that is finished, stretched while
/// they are resized; of several updates during a picture only the last is drawn.
[[nodiscard]] SurfaceMaker threadedSurfaces(std::shared_ptr<RenderThread> thread, OffscreenMaker maker);

}  // namespace vantage
