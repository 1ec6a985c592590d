#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <QWidget>
#include <string>

#include "vtk/render_surface.h"

namespace vantage::testing {

/// Surfaces for views in screenshot tests: OSMesa, no X server.
[[nodiscard]] SurfaceMaker testSurfaces();

/// The widget as it is at a size in device-independent pixels, laid out and painted.
[[nodiscard]] QImage grab(QWidget& widget, const QSize& size);

/// How far a picture may be from its baseline. Rasterising depends a little on the vector unit of the processor.
struct ScreenshotLimits {
  int channel = 40;      ///< a pixel differs when a channel differs by more
  double share = 0.005;  ///< so many pixels may differ
};

/// Compares with tests/screenshots/baselines/NAME.png. The picture is always written to the build folder; without a
/// baseline, or with too large a difference, the test fails and says how much, how much is allowed, and where both are.
[[nodiscard]] ::testing::AssertionResult matchesBaseline(const QImage& image, const std::string& name,
                                                         const ScreenshotLimits& limits = {});

/// At least that share of the pixels has about that colour.
[[nodiscard]] ::testing::AssertionResult showsColour(const QImage& image, const QColor& colour, double leastShare,
                                                     int tolerance = 24);

/// The text is written somewhere, whole, in the font of pictures.
[[nodiscard]] ::testing::AssertionResult showsText(const QImage& image, const QString& text, const QColor& colour,
                                                   double pixels = 12.0, bool bold = false);

/// No more than `mostOfOne` of all pixels are alike.
[[nodiscard]] ::testing::AssertionResult isNotBlank(const QImage& image, double mostOfOne = 0.95);

/// Same pixels.
[[nodiscard]] ::testing::AssertionResult isSamePicture(const QImage& a, const QImage& b);

}  // namespace vantage::testing
