#pragma once

#include "vtk/render_surface.h"

namespace vantage {

/// Windows drawn by OSMesa. Only for programs that link the object library vantage_osmesa and never open a window of an
/// X server: in them every call of OpenGL goes to OSMesa.
/// @throws DeviceError from the maker when there is no OpenGL 3.2.
[[nodiscard]] OffscreenMaker osmesaWindows();

}  // namespace vantage
