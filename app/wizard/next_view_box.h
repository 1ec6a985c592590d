#pragma once

#include <QGroupBox>

#include "session_controller.h"

class QLabel;
class QPushButton;
class QSpinBox;

namespace vantage {

class TurnDial;

/// Where the next scan is taken: which way and how far to turn, and what another position would cost.
class NextViewBox final : public QGroupBox {
  Q_OBJECT

 public:
  explicit NextViewBox(SessionController& controller, QWidget* parent = nullptr);

  /// With the dial, for an operator who turns the table by hand.
  void setAssisted(bool assisted);
  /// Puts a position up for choice.
  void offer(int position);

 signals:
  void considered(int position);  ///< the operator looks at a position

 private:
  void refresh();
  void refreshCost();
  [[nodiscard]] QString headline() const;
  [[nodiscard]] QString cost(int position) const;
  [[nodiscard]] QString costNow(int position) const;
  [[nodiscard]] QString instruction(int position) const;

  SessionController& controller_;
  bool assisted_ = false;
  QLabel* headline_;
  TurnDial* dial_;
  QLabel* instruction_;
  QSpinBox* other_;
  QLabel* cost_;
  QPushButton* take_;
  QPushButton* back_;
};

}  // namespace vantage
