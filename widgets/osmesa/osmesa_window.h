#pragma once

#include "vtk/render_surface.h"

namespace vantage {

/// Windows drawn by OSMesa. Only for programs that link the object library vantage_osmesa and never open a window of an
/// X server: in them every call of OpenGL goes to OSMesa.
[[nodiscard]] OffscreenMaker osmesaWindows();

}  // namespace vantage
