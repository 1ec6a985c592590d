#pragma once

#include <QPainter>

#include "look/theme.h"
#include "planning/scanner_picture.h"

namespace vantage {

/// What a scanner would see, upright, one pixel per ranging ray: surface in grey as bright as it faces the scanner, the
/// rest in the colour of its class.
[[nodiscard]] QImage toImage(const ScannerPicture& picture, const Theme& theme);

/// The picture with title and key.
void paintScannerPicture(QPainter& painter, const QRectF& area, const ScannerPicture& picture, const QString& title,
                         const Theme& theme);

}  // namespace vantage
