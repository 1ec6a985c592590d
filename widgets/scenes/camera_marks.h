#pragma once

#include <QPainter>

#include "look/theme.h"
#include "vtk/camera.h"

namespace vantage {

/// A length that is told on a bar of at most so many pixels: 1, 2 or 5 times a power of ten [mm].
/// @param perPixel millimetres that a pixel shows
[[nodiscard]] double scaleBarLength(double perPixel, double mostPixels);

/// Which way the axes lie and how long something is at the distance of what is looked at, in the lower left corner.
/// @param area of the picture, in device-independent pixels
void paintCameraMarks(QPainter& painter, const QRectF& area, const Camera& camera, const Theme& theme);

}  // namespace vantage
