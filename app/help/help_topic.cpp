#include "help/help_topic.h"

#include <QVariant>
#include <QWidget>

namespace vantage {
namespace {

constexpr const char* kProperty = "helpTopic";

}  // namespace

void setHelpTopic(QWidget& widget, const QString& topic) {
  widget.setProperty(kProperty, topic);
}

QString helpTopicOf(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget())
    if (const QString topic = widget->property(kProperty).toString(); !topic.isEmpty()) return topic;
  return QStringLiteral("contents");
}

}  // namespace vantage
