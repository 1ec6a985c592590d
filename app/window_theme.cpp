#include "window_theme.h"

#include <QApplication>
#include <QStyleFactory>

namespace vantage {
namespace {

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto part = [share](int x, int y) { return static_cast<int>(x + (y - x) * share); };
  return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

}  // namespace

const Theme& themeOf(int choice) {
  // Before the first theme is applied the palette is that of the desktop.
  static const bool desktopIsDark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
  return choice == 1 || (choice == 2 && desktopIsDark) ? darkTheme() : lightTheme();
}

QPalette paletteFor(const Theme& theme) {
  const QColor window = mixed(theme.panel, theme.text, theme.dark ? 0.05 : 0.045);
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::Base, theme.panel);
  palette.setColor(QPalette::AlternateBase, mixed(theme.panel, theme.text, 0.03));
  palette.setColor(QPalette::Button, mixed(window, theme.text, 0.05));
  // The edges of frames, tabs and rules, which would be white in every theme.
  palette.setColor(QPalette::Light, mixed(window, theme.text, 0.15));
  palette.setColor(QPalette::Midlight, mixed(window, theme.text, 0.1));
  palette.setColor(QPalette::Mid, mixed(window, theme.text, 0.25));
  palette.setColor(QPalette::Dark, mixed(window, theme.text, 0.3));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    palette.setColor(role, theme.text);
  palette.setColor(QPalette::ToolTipBase, theme.panel);
  palette.setColor(QPalette::PlaceholderText, theme.mutedText);
  const QColor accent = theme.dark ? theme.current.darker(175) : theme.current;
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, theme.current);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, mixed(theme.text, window, 0.42));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, theme.grid);
  return palette;
}

QString styleSheetFor(const Theme& theme) {
  const QPalette palette = paletteFor(theme);
  const QString accent = palette.color(QPalette::Highlight).name();
  const QString quiet = mixed(theme.text, theme.grid, 0.25).name();
  return QStringLiteral(
             "QLabel[role=\"title\"] { font-size: 15pt; font-weight: 600; }"
             "QLabel[role=\"section\"] { font-weight: 600; }"
             "QLabel[role=\"muted\"] { color: %1; }"
             "QLabel[role=\"figure\"] { font-size: 17pt; font-weight: 600; }"
             "QLabel[role=\"warning\"] { color: %2; }"
             "QLabel[role=\"good\"] { font-weight: 600; color: %8; }"
             "QPushButton { padding: 5px 12px; }"
             "QPushButton[primary=\"true\"] { background: %3; color: white; border: 1px solid %3; border-radius: 3px;"
             " font-weight: 600; padding: 6px 14px; }"
             "QPushButton[primary=\"true\"]:disabled { background: %4; border-color: %4; color: %7; }"
             "QPushButton[primary=\"true\"]:focus { border: 2px solid %6; padding: 5px 13px; }"
             "QToolButton[layer=\"true\"] { padding: 3px 8px; border: 1px solid %4; border-radius: 3px; }"
             "QToolButton[layer=\"true\"]:checked { background: %9; border-color: %9; color: %10; }"
             "QToolButton[layer=\"true\"]:focus { border: 2px solid %6; padding: 2px 7px; }"
             "QToolButton[tool=\"true\"] { padding: 3px; border: 1px solid transparent; border-radius: 3px; }"
             "QToolButton[tool=\"true\"]:hover { border-color: %4; }"
             "QToolButton[tool=\"true\"]:checked { background: %4; border-color: %9; }"
             "QToolButton[tool=\"true\"]:focus { border: 2px solid %6; padding: 2px; }"
             "QDockWidget { font-weight: 600; }"
             "QDockWidget > QWidget { font-weight: 400; }"
             "QToolTip { color: %6; background: %5; border: 1px solid %4; }")
      .arg(theme.mutedText.name(), theme.threshold.name(), accent, theme.grid.name(), theme.panel.name(),
           theme.text.name(), quiet, theme.good.name(), theme.current.name(),
           (theme.dark ? theme.panel : QColor(Qt::white)).name());
}

void applyTheme(QApplication& application, const Theme& theme) {
  application.setStyle(QStyleFactory::create("Fusion"));
  application.setPalette(paletteFor(theme));
  application.setStyleSheet(styleSheetFor(theme));
}

}  // namespace vantage
