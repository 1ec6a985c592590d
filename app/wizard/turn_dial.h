#pragma once

#include <QWidget>

namespace vantage {

/// A turntable from above: where it stands, and which way and how far to turn it.
class TurnDial final : public QWidget {
  Q_OBJECT

 public:
  explicit TurnDial(QWidget* parent = nullptr);

  /// @param current, target azimuths of the scanner about the object [rad], counter-clockwise from the right
  /// @param turn of the table, counter-clockwise [rad]
  void show(double current, double target, double turn);
  void clear();
  [[nodiscard]] QSize sizeHint() const override { return {220, 190}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  bool shown_ = false;
  double current_ = 0.0;
  double target_ = 0.0;
  double turn_ = 0.0;
};

}  // namespace vantage
