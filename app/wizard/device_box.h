#pragma once

#include <QWidget>
#include <vector>

class QLabel;
class QPushButton;
class QTimer;

namespace vantage {

class FigureTable;
class SessionController;

/// The real devices of a set-up: how each is now, and the table turned by the operator's hand on a button.
class DeviceBox final : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceBox(SessionController& controller, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void addJog(double degrees);
  void refresh();
  [[nodiscard]] QString whyNot() const;

  SessionController& controller_;
  QTimer* look_;
  FigureTable* states_;
  QLabel* failure_;
  QPushButton* connect_;
  QWidget* tableRow_;
  std::vector<QPushButton*> jogs_;
  QPushButton* home_;
  QPushButton* stop_;
};

}  // namespace vantage
