#pragma once

#include <QString>

class QWidget;

namespace vantage {

/// Names the place of the manual that is about a widget and all that is in it: "acquire", or "acquire#by-hand" for a
/// heading of that page.
void setHelpTopic(QWidget& widget, const QString& topic);

/// The topic of the widget, else of what it is in, across windows too; "contents" where nothing names one.
/// @param widget may be null
[[nodiscard]] QString helpTopicOf(const QWidget* widget);

}  // namespace vantage
