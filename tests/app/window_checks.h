#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>

namespace vantage::testing {

/// Texts that are not given the room that they ask for.
[[nodiscard]] QStringList clipped(const QWidget& window);

/// Widgets that take the keyboard but tell assistive technology nothing.
[[nodiscard]] QStringList nameless(const QWidget& window);

/// Controls in sight that cannot be used and do not say why: their tooltip is empty, or the help of when they can be.
[[nodiscard]] QStringList unexplained(const QWidget& window);

/// Whether a text is written anywhere in the window, in one piece of text or as a part of one.
[[nodiscard]] bool says(QWidget& window, const QString& text);

/// What is reached by the same letter at the same time: titles of menus and visible buttons, and within a menu.
[[nodiscard]] QStringList collidingMnemonics(const QWidget& window);

/// Visible buttons that can be used, but not reached by the keyboard.
[[nodiscard]] QStringList beyondTheKeyboard(const QWidget& window);

}  // namespace vantage::testing
