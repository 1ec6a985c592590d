#pragma once

#include <QDir>
#include <QFile>
#include <QString>
#include <QStringList>

#include "support/test_data.h"

namespace vantage::testing {

/// The folder of the operator's manual in the source tree.
[[nodiscard]] inline QString manualFolder() {
  return QString::fromStdString((sourceFolder() / "resources/manual/operator").string());
}

[[nodiscard]] inline QString textOf(const QString& file) {
  QFile in(file);
  return in.open(QIODevice::ReadOnly) ? QString::fromUtf8(in.readAll()) : QString();
}

/// The pages as files, also those that no contents lead to.
[[nodiscard]] inline QStringList manualFiles() {
  const QDir folder(manualFolder());
  QStringList files;
  for (const QString& name : folder.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name))
    files << folder.filePath(name);
  return files;
}

}  // namespace vantage::testing
