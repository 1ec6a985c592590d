#include "app/window_checks.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QKeySequence>
#include <QLabel>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>

#include "screenshots/painted_text.h"

namespace vantage::testing {

QStringList clipped(const QWidget& window) {
  QStringList names;
  for (const auto* label : window.findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty()) continue;
    const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
    if (label->height() < needed || (!label->wordWrap() && label->width() < label->sizeHint().width()))
      names << label->text();
  }
  for (const auto* button : window.findChildren<QAbstractButton*>()) {
    const bool named = button->isVisible() && !button->text().isEmpty();
    if (named && button->width() < QFontMetrics(button->font()).size(Qt::TextShowMnemonic, button->text()).width())
      names << button->text();
  }
  return names;
}

QStringList nameless(const QWidget& window) {
  QStringList names;
  for (const auto* button : window.findChildren<QAbstractButton*>())
    if (button->isVisible() && button->focusPolicy() != Qt::NoFocus && button->accessibleName().isEmpty() &&
        button->text().isEmpty())
      names << button->objectName() + QLatin1Char(' ') + button->metaObject()->className();
  return names;
}

QStringList unexplained(const QWidget& window) {
  QStringList names;
  for (const auto* widget : window.findChildren<QWidget*>()) {
    const bool control = qobject_cast<const QAbstractButton*>(widget) != nullptr ||
                         qobject_cast<const QComboBox*>(widget) != nullptr ||
                         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
    if (!control || !widget->isVisible() || widget->isEnabled()) continue;
    if (widget->toolTip().isEmpty() || widget->toolTip() == widget->property("help").toString())
      names << widget->objectName() + QLatin1Char(' ') + widget->metaObject()->className();
  }
  return names;
}

namespace {

// The letter that a text is reached by; null for none.
QChar mnemonicOf(const QString& text) {
  const QKeySequence keys = QKeySequence::mnemonic(text);
  if (keys.isEmpty()) return {};
  const QString name = keys.toString(QKeySequence::PortableText);
  return name.back();
}

void addCollisions(const QStringList& texts, QStringList& collisions) {
  QMap<QChar, QString> known;
  for (const QString& text : texts) {
    const QChar letter = mnemonicOf(text);
    if (letter.isNull()) continue;
    if (known.contains(letter)) collisions << known[letter] + QStringLiteral(" / ") + text;
    known[letter] = text;
  }
}

QStringList textsOf(const QMenu& menu) {
  QStringList texts;
  for (const QAction* action : menu.actions())
    if (action->isVisible() && !action->isSeparator()) texts << action->text();
  return texts;
}

}  // namespace

QStringList collidingMnemonics(const QWidget& window) {
  QStringList collisions;
  QStringList together;
  for (const auto* bar : window.findChildren<QMenuBar*>())
    for (const QAction* action : bar->actions()) together << action->text();
  for (const auto* button : window.findChildren<QAbstractButton*>())
    if (button->isVisible()) together << button->text();
  addCollisions(together, collisions);
  for (const auto* menu : window.findChildren<QMenu*>()) addCollisions(textsOf(*menu), collisions);
  return collisions;
}

QStringList beyondTheKeyboard(const QWidget& window) {
  QStringList names;
  for (const auto* button : window.findChildren<QAbstractButton*>()) {
    // What a larger control is made of is reached with it.
    const QString name = button->metaObject()->className();
    const bool part = name == QLatin1String("QDockWidgetTitleButton") || name == QLatin1String("QTabBar") ||
                      qobject_cast<const QTabBar*>(button->parentWidget()) != nullptr ||
                      button->objectName().startsWith(QLatin1String("qt_"));
    if (!part && button->isVisible() && button->isEnabled() && (button->focusPolicy() & Qt::TabFocus) != Qt::TabFocus)
      names << button->objectName() + QLatin1Char(' ') + button->text();
  }
  return names;
}

bool says(QWidget& window, const QString& text) {
  for (const auto* label : window.findChildren<QLabel*>())
    if (label->isVisible() && label->text().contains(text)) return true;
  for (const PaintedText& painted : paintedText(window))
    if (painted.text.contains(text)) return true;
  return false;
}

}  // namespace vantage::testing
