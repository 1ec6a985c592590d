#include "window/session_door.h"

#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include "help/help_topic.h"
#include "wizard/choose_page.h"
#include "wizard/import_dialog.h"

namespace vantage {
namespace {

// Where the session of last time was, else where sessions are kept.
QString usualFolder() {
  const QString last = QSettings().value(QStringLiteral("lastFolder")).toString();
  if (!last.isEmpty() && QFileInfo(last).isDir()) return last;
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString ours = documents + QStringLiteral("/Vantage");
  return QFileInfo(ours).isDir() ? ours : documents;
}

}  // namespace

SessionDoor::SessionDoor(SessionController& controller, const ChoosePage& choosePage, QWidget& window)
    : QObject(&window), controller_(controller), choosePage_(choosePage), window_(window) {
  connect(&controller, &SessionController::inUse, this, &SessionDoor::offerToLook);
}

void SessionDoor::openSession(SessionAccess access) {
  if (const QString why = controller_.permissions().whyNotOpen(); !why.isEmpty()) return emit refused(why);
  const QString title = access == SessionAccess::Read ? tr("Open a session to look at") : tr("Open a session");
  const QString path = QFileDialog::getOpenFileName(&window_, title, usualFolder(), tr("Sessions (*.vantage)"));
  if (!path.isEmpty()) openSession(path, access);
}

void SessionDoor::openSession(const QString& path, SessionAccess access) {
  if (const QString why = controller_.permissions().whyNotOpen(); !why.isEmpty()) return emit refused(why);
  if (controller_.hasSession() && QFileInfo(path) == QFileInfo(controller_.sessionPath()))
    return emit refused(tr("%1 is open already.").arg(path));
  QSettings().setValue(QStringLiteral("lastFolder"), QFileInfo(path).absolutePath());
  controller_.open(path, access);
}

void SessionDoor::offerToLook(const QString& path, const QString& why) {
  auto* box = new QMessageBox(QMessageBox::Question, tr("Open a session"), why + QLatin1Char('.'), QMessageBox::Cancel,
                              &window_);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName(QStringLiteral("sessionInUse"));
  setHelpTopic(*box, QStringLiteral("sessions#a-session-that-another-program-writes-to"));
  box->setInformativeText(
      tr("You can look at it as it is now: everything is shown and can be exported, nothing is changed."));
  QPushButton* look = box->addButton(tr("&Open to look at"), QMessageBox::AcceptRole);
  look->setObjectName(QStringLiteral("openToLook"));
  box->setDefaultButton(look);
  connect(look, &QPushButton::clicked, this, [this, path] { openSession(path, SessionAccess::Read); });
  box->open();
}

void SessionDoor::importScans(const QStringList& files) {
  if (const QString why = controller_.permissions().whyNotOpen(); !why.isEmpty()) return emit refused(why);
  const bool intoOpen = controller_.permissions().whyNotAddScans().isEmpty();
  auto* dialog = new ImportDialog(
      controller_, intoOpen ? ImportDialog::Into::OpenSession : ImportDialog::Into::NewSession, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowModality(Qt::WindowModal);
  dialog->suggest(choosePage_.importChoice());
  dialog->addFiles(files);
  dialog->open();
}

void SessionDoor::take(QDropEvent& event) {
  QStringList files;
  for (const QUrl& url : event.mimeData()->urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  if (files.isEmpty()) return;
  event.acceptProposedAction();
  if (files.size() == 1 && files.front().endsWith(QStringLiteral(".vantage"))) return openSession(files.front());
  importScans(files);
}

}  // namespace vantage
