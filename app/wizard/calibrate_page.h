#pragma once

#include "wizard/wizard_page.h"

class QLabel;
class QPushButton;
class QSpinBox;

namespace vantage {

class FigureTable;

/// Where a real turntable stands before its scanner, which way and how far it turns: found by scanning any object on
/// it.
class CalibratePage final : public WizardPage {
  Q_OBJECT

 public:
  explicit CalibratePage(SessionController& controller, QWidget* parent = nullptr);

  [[nodiscard]] QString key() const override { return QStringLiteral("calibrate"); }
  [[nodiscard]] QString title() const override { return tr("Calibrate the table"); }
  [[nodiscard]] QString whatNext() const override;
  [[nodiscard]] QString nextText() const override { return tr("&Next: acquire"); }
  [[nodiscard]] bool complete() const override;
  [[nodiscard]] bool applies() const override;
  void entered() override;

 private:
  void refresh();
  void refreshResult();
  [[nodiscard]] QString current() const;

  QLabel* current_;
  QSpinBox* scans_;
  QPushButton* calibrate_;
  QPushButton* stop_;
  QLabel* verdict_;
  FigureTable* figures_;
  QLabel* findings_;
  QPushButton* use_;
};

}  // namespace vantage
