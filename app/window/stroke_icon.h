#pragma once

#include <QColor>
#include <QIcon>
#include <QString>
#include <QStringList>

namespace vantage {

/// The names of the icons of actions that the program brings along.
[[nodiscard]] QStringList strokeIconNames();

/// The drawing of an icon in one colour. @param pixels its width and height
/// @throws InvalidInput when there is none of that name
[[nodiscard]] QPixmap strokePixmap(const QString& name, const QColor& colour, int pixels);

/// An icon of an action in the colours of a theme, sharp at every scale. @throws InvalidInput when there is none of
/// that name
/// @param disabled of the action that cannot be had now
[[nodiscard]] QIcon strokeIcon(const QString& name, const QColor& normal, const QColor& disabled);

}  // namespace vantage
