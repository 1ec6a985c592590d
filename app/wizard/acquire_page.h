#pragma once

#include "wizard/wizard_page.h"

class QLabel;
class QPushButton;
class QTabBar;

namespace vantage {

class FigureTable;
class NextViewBox;
class StandDesk;

/// Scanning: automatic, or assisted, where the operator turns the table.
class AcquirePage final : public WizardPage {
  Q_OBJECT

 public:
  AcquirePage(SessionController& controller, StandDesk& stands, QWidget* parent = nullptr);

  [[nodiscard]] QString key() const override { return QStringLiteral("acquire"); }
  [[nodiscard]] QString title() const override { return tr("Acquire"); }
  [[nodiscard]] QString whatNext() const override;
  [[nodiscard]] QString nextText() const override { return tr("&Next: review"); }
  [[nodiscard]] bool complete() const override;
  void entered() override;

  void setAssisted(bool assisted);
  [[nodiscard]] NextViewBox& nextView() { return *nextView_; }

 private:
  void build();
  void refresh();
  void refreshFigures();
  [[nodiscard]] QString status() const;
  [[nodiscard]] QString stage() const;
  [[nodiscard]] bool assisted() const;

  QTabBar* mode_;
  QLabel* failure_;
  QPushButton* again_;
  QPushButton* byHand_;
  QLabel* status_;
  FigureTable* figures_;
  NextViewBox* nextView_;
  QPushButton* run_;
  QPushButton* pause_;
  QPushButton* step_;
  QPushButton* stop_;
  QPushButton* scan_;
  QPushButton* more_;
  QPushButton* end_;
  QPushButton* turnOver_;
  StandDesk& stands_;
};

}  // namespace vantage
