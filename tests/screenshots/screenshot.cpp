#include "screenshots/screenshot.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <unordered_map>

#include "look/legend.h"
#include "osmesa/osmesa_window.h"

namespace vantage::testing {
namespace {

const QString kBaselines = QStringLiteral(VANTAGE_SOURCE_DIR "/tests/screenshots/baselines/");
const QString kResults = QStringLiteral(VANTAGE_SCREENSHOT_DIR "/");

bool differ(QRgb a, QRgb b, int channel) {
  return std::abs(qRed(a) - qRed(b)) > channel || std::abs(qGreen(a) - qGreen(b)) > channel ||
         std::abs(qBlue(a) - qBlue(b)) > channel;
}

std::size_t pixelCount(const QImage& image) {
  return static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
}

template <typename Test>
double shareOf(const QImage& image, const Test& test) {
  std::size_t count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += test(x, y) ? 1U : 0U;
  return static_cast<double>(count) / static_cast<double>(pixelCount(image));
}

// Where the ink of a text is and where clean paper, relative to the first of the ink.
struct Lettering {
  std::vector<QPoint> ink;
  std::vector<QPoint> paper;
};

Lettering letteringOf(const QString& text, double pixels, bool bold, double ratio) {
  QFont font = pictureFont(pixels, bold);
  const QFontMetricsF metrics(font);
  const QSize size = (QSizeF(metrics.horizontalAdvance(text) + 4.0, metrics.height() + 4.0) * ratio).toSize();
  QImage image(size, QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setFont(font);
  painter.setPen(Qt::black);
  painter.drawText(QPointF(2.0, 2.0 + metrics.ascent()), text);
  painter.end();
  constexpr int kDark = 70;
  constexpr int kClean = 250;
  Lettering lettering;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const int grey = qGray(image.pixel(x, y));
      if (grey < kDark) lettering.ink.emplace_back(x, y);
      if (grey > kClean) lettering.paper.emplace_back(x, y);
    }
  }
  const QPoint first = lettering.ink.front();
  for (QPoint& p : lettering.ink) p -= first;
  for (QPoint& p : lettering.paper) p -= first;
  return lettering;
}

// Whether these lie on pixels of a colour, but for a share.
bool liesOn(const QImage& image, const QPoint& place, const std::vector<QPoint>& points, QRgb colour, double butFor) {
  constexpr int kChannel = 90;
  const auto most = static_cast<int>(butFor * static_cast<double>(points.size()));
  int missing = 0;
  for (const QPoint& offset : points) {
    const QPoint p = place + offset;
    if (!image.rect().contains(p) || differ(image.pixel(p), colour, kChannel)) ++missing;
    if (missing > most) return false;
  }
  return true;
}

// Whether the ink is there, and not the paper as well: a dark spot is no text.
bool isWritten(const QImage& image, const QPoint& place, const Lettering& lettering, QRgb colour) {
  return liesOn(image, place, lettering.ink, colour, 0.125) && !liesOn(image, place, lettering.paper, colour, 0.5);
}

}  // namespace

SurfaceMaker testSurfaces() {
  return imageSurfaces(osmesaWindows());
}

QImage grab(QWidget& widget, const QSize& size) {
  widget.resize(size);
  widget.ensurePolished();
  QApplication::sendPostedEvents();
  return widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

::testing::AssertionResult matchesBaseline(const QImage& image, const std::string& name,
                                           const ScreenshotLimits& limits) {
  const QString file = QString::fromStdString(name) + ".png";
  QDir().mkpath(kResults);
  const QString written = kResults + file;
  if (!image.save(written)) return ::testing::AssertionFailure() << "cannot write " << written.toStdString();
  const QString expected = kBaselines + file;
  if (std::getenv("VANTAGE_UPDATE_BASELINES") != nullptr) image.save(expected);
  const QImage baseline = QImage(expected).convertToFormat(QImage::Format_RGB32);
  if (baseline.isNull())
    return ::testing::AssertionFailure() << "no baseline " << expected.toStdString() << "; the picture is "
                                         << written.toStdString();
  if (baseline.size() != image.size())
    return ::testing::AssertionFailure() << "the picture " << written.toStdString() << " is " << image.width() << " x "
                                         << image.height() << ", the baseline " << expected.toStdString() << " is "
                                         << baseline.width() << " x " << baseline.height();
  const double share =
      shareOf(image, [&](int x, int y) { return differ(image.pixel(x, y), baseline.pixel(x, y), limits.channel); });
  if (share <= limits.share) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "pixels that differ: " << 100.0 * share << " %, allowed "
                                       << 100.0 * limits.share << " %; picture " << written.toStdString()
                                       << ", baseline " << expected.toStdString();
}

::testing::AssertionResult showsColour(const QImage& image, const QColor& colour, double leastShare, int tolerance) {
  const double share =
      shareOf(image, [&](int x, int y) { return !differ(image.pixel(x, y), colour.rgb(), tolerance); });
  if (share >= leastShare) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << colour.name().toStdString() << " covers " << 100.0 * share
                                       << " % of the picture, expected at least " << 100.0 * leastShare << " %";
}

::testing::AssertionResult showsText(const QImage& image, const QString& text, const QColor& colour, double pixels,
                                     bool bold) {
  const Lettering lettering = letteringOf(text, pixels, bold, image.devicePixelRatio());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (isWritten(image, {x, y}, lettering, colour.rgb())) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "\"" << text.toStdString() << "\" is not in the picture";
}

::testing::AssertionResult isNotBlank(const QImage& image, double mostOfOne) {
  std::unordered_map<QRgb, std::size_t> counts;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
  std::size_t most = 0;
  for (const auto& [colour, count] : counts) most = std::max(most, count);
  const double share = static_cast<double>(most) / static_cast<double>(pixelCount(image));
  if (share <= mostOfOne) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << 100.0 * share << " % of the picture have one colour";
}

::testing::AssertionResult isSamePicture(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return ::testing::AssertionFailure() << "the pictures differ in size";
  const double share = shareOf(a, [&](int x, int y) { return a.pixel(x, y) != b.pixel(x, y); });
  if (share == 0.0) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << 100.0 * share << " % of the pixels differ";
}

}  // namespace vantage::testing
