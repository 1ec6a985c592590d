#include "window/tool_bar.h"

#include <QAction>
#include <QToolButton>

#include "window/stroke_icon.h"
#include "window_theme.h"

namespace vantage {
namespace {

constexpr int kToolIcon = 22;  // [px]

// Of a menu "&Undo\tCtrl+Z": the letter is underlined there, the key stands behind.
struct ActionText {
  explicit ActionText(const QAction& action) {
    const QStringList parts = action.text().split(QLatin1Char('\t'));
    name = QString(parts[0]).remove(QLatin1Char('&')).remove(QStringLiteral("…")).trimmed();
    key = parts.size() > 1 ? parts[1] : action.shortcut().toString(QKeySequence::NativeText);
  }
  QString name;
  QString key;
};

// Where an action can be had Qt makes its tooltip of its text.
QString whyNotOf(const QAction& action) {
  return action.isEnabled() ? QString() : action.statusTip();
}

}  // namespace

QString toolName(const QAction& action) {
  const ActionText text(action);
  return text.key.isEmpty() ? text.name : QStringLiteral("%1 (%2)").arg(text.name, text.key);
}

ToolBar::ToolBar(QWidget* parent) : QToolBar(tr("Tools"), parent), theme_(&lightTheme()) {
  setObjectName(QStringLiteral("tools"));
  setAccessibleName(tr("Tools"));
  setIconSize({kToolIcon, kToolIcon});
  setMovable(false);
  setFloatable(false);
  // It cannot be hidden: what stops a run is in it.
  toggleViewAction()->setEnabled(false);
  toggleViewAction()->setVisible(false);
}

void ToolBar::addTools(const QList<Tool>& tools) {
  if (!shown_.isEmpty()) addSeparator();
  for (const Tool& tool : tools) {
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("tool_") + tool.icon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setCheckable(tool.action->isCheckable());
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setProperty("tool", true);
    addWidget(button);
    const Shown shown{tool, button};
    shown_ << shown;
    draw(tool);
    follow(shown);
    connect(tool.action, &QAction::changed, this, [this, shown] { follow(shown); });
    // The button shows what became of it: the one that is chosen of several stays so when it is clicked again.
    connect(button, &QToolButton::clicked, this, [this, shown] {
      shown.tool.action->trigger();
      follow(shown);
    });
  }
}

void ToolBar::follow(const Shown& shown) {
  const QAction& action = *shown.tool.action;
  const QString name = toolName(action);
  const QString whyNot = whyNotOf(action);
  QToolButton& button = *shown.button;
  button.setIcon(action.icon());
  button.setEnabled(action.isEnabled());
  button.setChecked(action.isChecked());
  button.setAccessibleName(ActionText(action).name);
  button.setProperty("help", name);
  button.setToolTip(whyNot.isEmpty() ? name : name + QLatin1Char('\n') + whyNot);
  button.setAccessibleDescription(button.toolTip());
}

void ToolBar::draw(const Tool& tool) {
  const QColor normal = tool.tint == ToolTint::Go     ? theme_->good
                        : tool.tint == ToolTint::Halt ? theme_->threshold
                                                      : theme_->text;
  tool.action->setIcon(
      strokeIcon(tool.icon, normal, paletteFor(*theme_).color(QPalette::Disabled, QPalette::ButtonText)));
}

void ToolBar::setTheme(const Theme& theme) {
  theme_ = &theme;
  for (const Shown& shown : shown_) draw(shown.tool);
}

QToolButton* ToolBar::button(const QAction& action) const {
  for (const Shown& shown : shown_)
    if (shown.tool.action == &action) return shown.button;
  return nullptr;
}

}  // namespace vantage
