#pragma once

#include "wizard/wizard_page.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace vantage {

class CompletenessBox;
class FigureTable;

/// What was covered, what is left and why.
class ReviewPage final : public WizardPage {
  Q_OBJECT

 public:
  explicit ReviewPage(SessionController& controller, QWidget* parent = nullptr);

  [[nodiscard]] QString key() const override { return QStringLiteral("review"); }
  [[nodiscard]] QString title() const override { return tr("Review"); }
  [[nodiscard]] QString whatNext() const override { return tr("Model and report are written where you say."); }
  [[nodiscard]] QString nextText() const override { return tr("&Next: finish"); }
  [[nodiscard]] bool complete() const override;
  void entered() override;

 signals:
  /// A scan of the list was chosen, or none.
  void scanChosen(const std::optional<std::int64_t>& scan);
  /// Where the edges are that are left for a reason.
  void edgesWanted(vantage::EdgeReason reason);

 private:
  void refresh();
  void refreshTurnOver();
  void refreshLeft(const AcquisitionState& state);
  void refreshViews(const AcquisitionState& state);
  void addScan(const KeptScan& scan);
  void toggle();
  void choose();
  void select(std::int64_t scan);

  QLabel* reason_;
  QLabel* stands_;
  CompletenessBox* completeness_;
  FigureTable* figures_;
  FigureTable* left_;
  QTableWidget* views_;
  QPushButton* toggle_;
  QPushButton* turnOver_;
};

}  // namespace vantage
