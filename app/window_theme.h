#pragma once

#include <QPalette>
#include <QString>

#include "look/theme.h"

class QApplication;

namespace vantage {

/// The theme of a choice: 0 light, 1 dark, 2 as the desktop was when the program began.
[[nodiscard]] const Theme& themeOf(int choice);
[[nodiscard]] QPalette paletteFor(const Theme& theme);
[[nodiscard]] QString styleSheetFor(const Theme& theme);

/// Gives the whole program the colours of a theme. Buttons with the property "primary" stand out, labels with the
/// property "role" set to "title", "section", "muted", "good", "warning" or "figure" are set in that style, buttons
/// with the properties "layer" and "tool" show by their colour whether they are on.
void applyTheme(QApplication& application, const Theme& theme);

}  // namespace vantage
