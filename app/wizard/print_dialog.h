#pragma once

#include <QDialog>

#include "hand_over.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace vantage {

/// Asks how a model is made ready: which openings are closed, what is left out, how fine it is, and in which unit.
class PrintDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit PrintDialog(QWidget* parent = nullptr);

  [[nodiscard]] HandOver choice() const;

 private:
  void refresh();

  QComboBox* close_;
  QDoubleSpinBox* width_;
  QCheckBox* largest_;
  QCheckBox* coarser_;
  QDoubleSpinBox* error_;
  QComboBox* unit_;
  QCheckBox* printable_;
};

}  // namespace vantage
