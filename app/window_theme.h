#pragma once

#include <QPalette>
#include <QString>

#include "look/theme.h"

class QApplication;

namespace vantage {

[[nodiscard]] QPalette paletteFor(const Theme& theme);
[[nodiscard]] QString styleSheetFor(const Theme& theme);

/// Gives the whole program the colours of a theme. Buttons with the property "primary" stand out, labels with the
/// property "role" set to "title", "section", "muted", "warning" or "figure" are set in that style.
void applyTheme(QApplication& application, const Theme& theme);

}  // namespace vantage
