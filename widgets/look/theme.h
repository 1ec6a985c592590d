#pragma once

#include <QColor>

#include "look/colour_map.h"

namespace vantage {

/// The colours that everything is drawn with. Colours that carry a value or a class are the same in all themes.
struct Theme {
  bool dark = false;
  QColor backgroundTop;     ///< of a scene, behind everything
  QColor backgroundBottom;  ///< of a scene
  QColor panel;             ///< behind charts and legends
  QColor text;
  QColor mutedText;
  QColor grid;       ///< axes and rulers
  QColor surface;    ///< the model in plain
  QColor boundary;   ///< the model's border
  QColor table;      ///< the turntable
  QColor current;    ///< the view taken last
  QColor proposed;   ///< the view that is proposed
  QColor examined;   ///< the position or patch that is asked about
  QColor threshold;  ///< t and F
  QColor good;       ///< of what is as it should be
};

[[nodiscard]] const Theme& lightTheme();
[[nodiscard]] const Theme& darkTheme();

/// How well one colour is told from another, 1 to 21 (WCAG 2: text needs 4.5, marks 3).
[[nodiscard]] double contrast(const QColor& a, const QColor& b);

[[nodiscard]] inline Rgb toRgb(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

[[nodiscard]] inline QColor toColour(const Rgb& colour) {
  return {colour[0], colour[1], colour[2]};
}

}  // namespace vantage
