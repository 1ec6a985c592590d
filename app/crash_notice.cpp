#include "crash_notice.h"

#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPushButton>

#include "help/help_topic.h"

namespace vantage {

CrashNotice::CrashNotice(const CrashTrace& crash, QWidget* parent)
    : QMessageBox(Warning, tr("Vantage"), tr("Vantage broke when it was last used."), NoButton, parent) {
  setHelpTopic(*this, QStringLiteral("messages#when-something-is-wrong-with-vantage-itself"));
  setAttribute(Qt::WA_DeleteOnClose);
  const QString file = QString::fromStdString(crash.file.filename().string());
  const QString folder = QDir::toNativeSeparators(QString::fromStdString(crash.file.parent_path().string()));
  QString text = tr("What it was doing is in %1 in the folder %2. It stays there, and was sent to nobody.")
                     .arg(QString(file).replace(QStringLiteral(".new"), QStringLiteral(".txt")), folder);
  const QString session = QString::fromLocal8Bit(crash.session.c_str());
  const bool there = !session.isEmpty() && QFileInfo::exists(session);
  if (there)
    text += "\n\n" + tr("The session %1 was open. Every scan was written before anything was made of it.")
                         .arg(QDir::toNativeSeparators(session));
  setInformativeText(text);
  const QString trace = QString::fromStdString(crash.text);
  setDetailedText(trace);
  QPushButton* copy = addButton(tr("&Copy the trace"), ActionRole);
  copy->setObjectName(QStringLiteral("copyTrace"));
  // Copying leaves the notice where it is.
  copy->disconnect();
  connect(copy, &QPushButton::clicked, this, [trace] { QGuiApplication::clipboard()->setText(trace); });
  if (there) offerSession(session);
  setEscapeButton(addButton(Close));
}

void CrashNotice::offerSession(const QString& path) {
  QPushButton* open = addButton(tr("&Open the session"), AcceptRole);
  open->setObjectName(QStringLiteral("openSession"));
  setDefaultButton(open);
  connect(open, &QPushButton::clicked, this, [this, path] { emit sessionWanted(path); });
}

}  // namespace vantage
