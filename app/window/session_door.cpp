#include "window/session_door.h"

#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include "help/help_topic.h"
#include "recent/recent_list.h"
#include "window/dropped_files.h"
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

SessionDoor::SessionDoor(SessionController& controller, JobRunner& jobs, ChoosePage& choosePage, QWidget& window)
    : QObject(&window), controller_(controller), jobs_(jobs), choosePage_(choosePage), window_(window) {
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
  jobs_.run<Dropped>(
      {}, [files](const Progress& progress) { return judgeDrop(files, progress); },
      [door = QPointer(this)](const JobResult<Dropped>& result) {
        if (!door || result.cancelled) return;
        if (result.value)
          door->take(*result.value);
        else
          door->refuseDrop(result.error + QLatin1Char('.'));
      });
}

void SessionDoor::take(const Dropped& dropped) {
  switch (dropped.kind) {
    case DropKind::Session:
      return openSession(dropped.files.front());
    case DropKind::Scans:
      return importScans(dropped.files);
    case DropKind::Mesh:
      return takeMesh(dropped.files.front());
    case DropKind::Refused:
      refuseDrop(dropped.whyNot);
  }
}

void SessionDoor::refuseDrop(const QString& why) {
  auto* box = new QMessageBox(QMessageBox::Information, tr("Not taken"), why, QMessageBox::Ok, &window_);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName(QStringLiteral("dropRefused"));
  setHelpTopic(*box, QStringLiteral("messages_files#a-file-that-was-dropped-is-not-taken"));
  box->setInformativeText(droppableText());
  box->open();
}

// What a mesh is for is asked: it may be what is scanned, or something else.
void SessionDoor::takeMesh(const QString& path) {
  const QString name = QFileInfo(path).fileName();
  if (!choosePage_.isVisible())
    return refuseDrop(
        tr("%1 is a mesh. A mesh can be dropped on the first page, as what the simulated scanner looks at.").arg(name));
  if (const QString why = choosePage_.whyNoObject(); !why.isEmpty())
    return refuseDrop(tr("%1 is a mesh. %2").arg(name, why));
  auto* box = new QMessageBox(QMessageBox::Question, tr("A mesh"), tr("%1 is a mesh.").arg(name), QMessageBox::Cancel,
                              &window_);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName(QStringLiteral("droppedMesh"));
  setHelpTopic(*box, QStringLiteral("choose#files-that-are-dropped"));
  box->setInformativeText(tr("The simulated scanner can look at it. Its file is only read."));
  QPushButton* scan = box->addButton(tr("&Scan it in simulation"), QMessageBox::AcceptRole);
  scan->setObjectName(QStringLiteral("scanMesh"));
  box->setDefaultButton(scan);
  connect(scan, &QPushButton::clicked, this, [this, path] {
    if (const QString why = choosePage_.whyNoObject(); !why.isEmpty()) return emit refused(why);
    choosePage_.takeObject(path);
  });
  box->open();
}

void SessionDoor::openRecent(const QString& path, RecentSessions& recent) {
  if (!QFileInfo::exists(path)) {
    recent.refresh();
    return offerToForget(recent, path, window_);
  }
  openSession(path);
}

}  // namespace vantage
