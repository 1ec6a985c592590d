#include "docks/log_panel.h"

#include <QTime>

namespace vantage {

LogPanel::LogPanel(QWidget* parent) : QPlainTextEdit(parent) {
  setReadOnly(true);
  setMaximumBlockCount(5000);
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Log"));
  setPlaceholderText(tr("Nothing has happened yet."));
}

void LogPanel::add(const QString& line) {
  appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + line);
}

void LogPanel::addError(const QString& line) {
  add(tr("Problem: %1").arg(line));
}

}  // namespace vantage
