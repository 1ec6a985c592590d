#pragma once

#include <QCheckBox>
#include <QDialog>
#include <QPlainTextEdit>

#include "diagnostics.h"

namespace vantage {

/// Shows the diagnostics as they would be copied, and copies them. Names of files are in them only when that is agreed
/// to; they are sent to nobody.
class DiagnosticsDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit DiagnosticsDialog(Diagnostics diagnostics, QWidget* parent = nullptr);

 private:
  void refresh();
  void copy();

  Diagnostics diagnostics_;
  QPlainTextEdit* text_;
  QCheckBox* withFiles_;
};

}  // namespace vantage
