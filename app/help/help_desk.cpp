#include "help/help_desk.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <utility>

#include "help/help_topic.h"
#include "help/help_window.h"

namespace vantage {

HelpDesk::HelpDesk(QString folder, QWidget& window)
    : QObject(&window), folder_(std::move(folder)), mainWindow_(window) {
  qApp->installEventFilter(this);
}

HelpDesk::~HelpDesk() = default;

void HelpDesk::addTo(QMenu& menu) {
  const auto add = [&](const QString& text, const QString& topic) {
    connect(menu.addAction(text), &QAction::triggered, this, [this, topic] { showTopic(topic); });
  };
  connect(menu.addAction(tr("&Manual") + QStringLiteral("\tF1")), &QAction::triggered, this,
          [this] { showTopic(topicOfNow()); });
  add(tr("M&essages and what to do"), QStringLiteral("messages"));
  add(tr("&Keyboard"), QStringLiteral("keyboard"));
  add(tr("&Words"), QStringLiteral("glossary"));
}

HelpWindow& HelpDesk::window() {
  if (!window_) window_ = std::make_unique<HelpWindow>(folder_);
  return *window_;
}

void HelpDesk::showTopic(const QString& topic) {
  window().showTopic(topic);
}

QString HelpDesk::topicOfNow() const {
  const QWidget* at = QApplication::focusWidget();
  if (at == nullptr) at = QApplication::activeModalWidget();
  if (at == nullptr) at = QApplication::activeWindow();
  return helpTopicOf(at != nullptr ? at : &mainWindow_);
}

// As in every dialog F1 is asked first whether it is a shortcut: it is none, and comes as a key.
bool HelpDesk::eventFilter(QObject* watched, QEvent* event) {
  const bool asks = event->type() == QEvent::ShortcutOverride;
  if (!asks && event->type() != QEvent::KeyPress) return QObject::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (key.key() != Qt::Key_F1 || key.modifiers() != Qt::NoModifier || QApplication::activePopupWidget() != nullptr)
    return QObject::eventFilter(watched, event);
  event->accept();
  if (!asks) showTopic(topicOfNow());
  return true;
}

}  // namespace vantage
