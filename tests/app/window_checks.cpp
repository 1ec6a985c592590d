#include "app/window_checks.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>

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

bool says(QWidget& window, const QString& text) {
  for (const auto* label : window.findChildren<QLabel*>())
    if (label->isVisible() && label->text().contains(text)) return true;
  for (const PaintedText& painted : paintedText(window))
    if (painted.text.contains(text)) return true;
  return false;
}

}  // namespace vantage::testing
