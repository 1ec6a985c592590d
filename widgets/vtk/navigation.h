#pragma once

#include <QPointF>
#include <QSizeF>
#include <Qt>
#include <cstdint>

#include "vtk/camera.h"

namespace vantage {

/// Whose mouse buttons move the camera; Upright: the left one turns it about z, which stays up.
enum class NavigationScheme : std::uint8_t { MeshLab, CloudCompare, Blender, ParaView, Upright };
inline constexpr int kNavigationSchemes = 5;

enum class Motion : std::uint8_t { None, Trackball, Turntable, Pan, Zoom, Roll };

/// What dragging with a button does; None leaves it to picking.
[[nodiscard]] Motion motionFor(NavigationScheme scheme, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

/// The camera after a drag.
/// @param from, to points of the picture; y runs down.
[[nodiscard]] Camera moved(const Camera& camera, Motion motion, const QPointF& from, const QPointF& to,
                           const QSizeF& size);

/// The camera after a turn of the wheel; positive steps go nearer.
[[nodiscard]] Camera zoomed(const Camera& camera, double steps);

}  // namespace vantage
