#pragma once

#include <QList>
#include <QString>
#include <QToolBar>
#include <cstdint>

#include "look/theme.h"

class QToolButton;

namespace vantage {

/// What the icon of a tool is coloured by: most as text, what begins and what ends a run stand out.
enum class ToolTint : std::uint8_t { Plain, Go, Halt };

/// An action of a menu that is in the tool bar, too.
struct Tool {
  QAction* action;
  QString icon;  ///< of strokeIconNames()
  ToolTint tint = ToolTint::Plain;
};

/// The bar of tools below the menus: always there, whatever page and docks are shown, and reached by the tab key. A
/// button does what its action in a menu does, is called as that in its tooltip, with the key, and says there why it
/// cannot be had now.
class ToolBar final : public QToolBar {
  Q_OBJECT

 public:
  explicit ToolBar(QWidget* parent = nullptr);

  /// Adds tools that belong together behind those that are there. An action keeps its icon in its menu.
  void addTools(const QList<Tool>& tools);
  void setTheme(const Theme& theme);
  /// The button of an action; null where it has none.
  [[nodiscard]] QToolButton* button(const QAction& action) const;

 private:
  struct Shown {
    Tool tool;
    QToolButton* button;
  };
  void follow(const Shown& shown);
  void draw(const Tool& tool);

  QList<Shown> shown_;
  const Theme* theme_;
};

/// What an action is called, without the letter that it is reached by, and its key in brackets.
[[nodiscard]] QString toolName(const QAction& action);

}  // namespace vantage
