#include "look/theme.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

}  // namespace

double contrast(const QColor& a, const QColor& b) {
  const auto [least, most] = std::minmax({luminance(a), luminance(b)});
  return (most + 0.05) / (least + 0.05);
}

const Theme& lightTheme() {
  static const Theme theme{.dark = false,
                           .backgroundTop = QColor(0xF7, 0xF8, 0xFA),
                           .backgroundBottom = QColor(0xDD, 0xE2, 0xE9),
                           .panel = QColor(0xFF, 0xFF, 0xFF),
                           .text = QColor(0x1B, 0x1F, 0x24),
                           .mutedText = QColor(0x57, 0x60, 0x6A),
                           .grid = QColor(0xB4, 0xBC, 0xC6),
                           .surface = QColor(0xC9, 0xC4, 0xBA),
                           .boundary = QColor(0xC4, 0x43, 0x0A),
                           .table = QColor(0xB9, 0xC2, 0xCC),
                           .current = QColor(0x00, 0x72, 0xB2),
                           .proposed = QColor(0xD5, 0x5E, 0x00),
                           .examined = QColor(0x8A, 0x2B, 0x8F),
                           .threshold = QColor(0xB0, 0x1E, 0x2E),
                           .good = QColor(0x1B, 0x6E, 0x3C)};
  return theme;
}

const Theme& darkTheme() {
  static const Theme theme{.dark = true,
                           .backgroundTop = QColor(0x2B, 0x30, 0x38),
                           .backgroundBottom = QColor(0x16, 0x19, 0x1E),
                           .panel = QColor(0x1F, 0x23, 0x29),
                           .text = QColor(0xE8, 0xEA, 0xED),
                           .mutedText = QColor(0xA3, 0xAB, 0xB5),
                           .grid = QColor(0x56, 0x5E, 0x69),
                           .surface = QColor(0xC4, 0xBF, 0xB6),
                           .boundary = QColor(0xFF, 0x8A, 0x4C),
                           .table = QColor(0x45, 0x4E, 0x59),
                           .current = QColor(0x56, 0xB4, 0xE9),
                           .proposed = QColor(0xFF, 0x9E, 0x3D),
                           .examined = QColor(0xE0, 0x8E, 0xE6),
                           .threshold = QColor(0xFF, 0x7B, 0x86),
                           .good = QColor(0x6F, 0xD0, 0x94)};
  return theme;
}

}  // namespace vantage
