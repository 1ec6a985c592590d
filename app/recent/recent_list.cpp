#include "recent/recent_list.h"

#include <QDir>
#include <QKeyEvent>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "form_parts.h"
#include "help/help_topic.h"

namespace vantage {
namespace {

constexpr QSize kRowPicture(64, 48);  // [px]
constexpr int kMostRows = 3;          // that are in sight without scrolling

QIcon pictureOf(const RecentSession& session) {
  if (session.digest && !session.digest->picture.isNull()) return QPixmap::fromImage(session.digest->picture);
  QPixmap none(kRowPicture);
  none.fill(Qt::transparent);
  return none;
}

QString placeOf(const RecentSession& session) {
  const QString place = QDir::toNativeSeparators(session.path);
  return session.unreadable.isEmpty() ? place : place + QLatin1Char('\n') + session.unreadable;
}

}  // namespace

RecentList::RecentList(RecentSessions& sessions, const SessionController& controller, QWidget* parent)
    : QWidget(parent), sessions_(sessions), controller_(controller), list_(new QListWidget) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(makeLabel(tr("Go on with a session"), "section"));
  column->addWidget(list_);
  list_->setObjectName(QStringLiteral("recentSessions"));
  list_->setAccessibleName(tr("Sessions of lately"));
  list_->setIconSize(kRowPicture);
  list_->setUniformItemSizes(true);
  list_->setTextElideMode(Qt::ElideMiddle);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->installEventFilter(this);
  setHelpTopic(*this, QStringLiteral("choose#go-on-with-a-session"));
  connect(list_, &QListWidget::itemClicked, this, &RecentList::choose);
  connect(list_, &QListWidget::customContextMenuRequested, this, &RecentList::showMenu);
  connect(&sessions, &RecentSessions::changed, this, &RecentList::fill);
  connect(&controller, &SessionController::sessionChanged, this, &RecentList::fill);
  fill();
}

const RecentSession* RecentList::current() const {
  const int row = list_->currentRow();
  return row >= 0 && row < sessions_.sessions().size() ? &sessions_.sessions()[row] : nullptr;
}

void RecentList::fill() {
  const int row = list_->currentRow();
  list_->clear();
  // As tall as the tallest of them: name, how far it is, when it was changed.
  const int height = std::max(kRowPicture.height(), 3 * fontMetrics().lineSpacing()) + 6;
  for (const RecentSession& session : sessions_.sessions()) {
    auto* item = new QListWidgetItem(pictureOf(session),
                                     sessionName(session.path) + QLatin1Char('\n') + recentText(session), list_);
    item->setToolTip(placeOf(session));
    item->setSizeHint({0, height});
    if (session.gone || !session.unreadable.isEmpty())
      item->setForeground(palette().color(QPalette::Disabled, QPalette::Text));
  }
  const int count = list_->count();
  list_->setFixedHeight(std::min(count, kMostRows) * height + 2 * list_->frameWidth());
  list_->setCurrentRow(std::min(row, count - 1));
  setVisible(count > 0 && !controller_.hasSession());
}

void RecentList::choose() {
  const RecentSession* session = current();
  if (session == nullptr) return;
  if (session->gone) return offerToForget(sessions_, session->path, *this);
  emit chosen(session->path);
}

bool RecentList::eventFilter(QObject* watched, QEvent* event) {
  if (watched != list_) return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::FocusIn && list_->currentRow() < 0) list_->setCurrentRow(0);
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  switch (static_cast<const QKeyEvent&>(*event).key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      choose();
      return true;
    case Qt::Key_Delete:
      if (const RecentSession* session = current()) sessions_.remove(QString(session->path));
      return true;
    default:
      return QWidget::eventFilter(watched, event);
  }
}

void RecentList::showMenu(const QPoint& place) {
  const RecentSession* session = current();
  if (session == nullptr) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QAction* remove = menu->addAction(tr("&Take off this list") + QLatin1Char('\t') +
                                    QKeySequence(Qt::Key_Delete).toString(QKeySequence::NativeText));
  connect(remove, &QAction::triggered, this, [this, path = session->path] { sessions_.remove(path); });
  menu->popup(list_->viewport()->mapToGlobal(place));
}

void fillRecentMenu(QMenu& menu, RecentSessions& sessions, const std::function<void(const QString& path)>& choose) {
  menu.clear();
  menu.setToolTipsVisible(true);
  int number = 1;
  for (const RecentSession& session : sessions.sessions()) {
    const QString name = sessionName(session.path).replace(QLatin1Char('&'), QStringLiteral("&&"));
    QAction* action = menu.addAction(pictureOf(session),
                                     QStringLiteral("&%1  %2: %3")
                                         .arg(QString::number(number++), name,
                                              recentText(session).replace(QLatin1Char('\n'), QStringLiteral(", "))));
    action->setToolTip(placeOf(session));
    action->setEnabled(!session.open);
    QObject::connect(action, &QAction::triggered, &menu, [choose, path = session.path] { choose(path); });
  }
  if (menu.isEmpty()) menu.addAction(RecentList::tr("No session was opened yet."))->setEnabled(false);
}

void offerToForget(RecentSessions& sessions, const QString& path, QWidget& parent) {
  auto* box = new QMessageBox(QMessageBox::Information, RecentList::tr("Open a session"),
                              RecentList::tr("%1 is gone.").arg(sessionName(path)), QMessageBox::Close, &parent);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName(QStringLiteral("sessionGone"));
  box->setInformativeText(RecentList::tr("There is no file %1 any more. It may have been moved, or its drive is not "
                                         "connected.")
                              .arg(QDir::toNativeSeparators(path)));
  QPushButton* forget = box->addButton(RecentList::tr("&Take off the list"), QMessageBox::AcceptRole);
  forget->setObjectName(QStringLiteral("forgetSession"));
  QObject::connect(forget, &QPushButton::clicked, &sessions, [&sessions, path] { sessions.remove(path); });
  box->open();
}

}  // namespace vantage
