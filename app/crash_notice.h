#pragma once

#include <QMessageBox>

#include "program/crash_trace.h"

namespace vantage {

/// Says after a crash that the program broke, where the trace of it is, and offers both: the trace to copy, and the
/// session that was open.
class CrashNotice final : public QMessageBox {
  Q_OBJECT

 public:
  explicit CrashNotice(const CrashTrace& crash, QWidget* parent = nullptr);

 signals:
  void sessionWanted(const QString& path);

 private:
  void offerSession(const QString& path);
};

}  // namespace vantage
