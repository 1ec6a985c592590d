#pragma once

#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

class QLabel;
class QPushButton;

namespace vantage {

class SessionController;

/// Of a scan that does not fit where it was said to be taken: the turns of the table that it does fit, each to be
/// confirmed by the operator with one button. Hidden while there are none.
class OtherTurnBox final : public QWidget {
  Q_OBJECT

 public:
  explicit OtherTurnBox(SessionController& controller, QWidget* parent = nullptr);

 private:
  void refresh();
  void offer(std::optional<std::int64_t> scan, const std::vector<double>& turns);

  SessionController& controller_;
  QLabel* what_;
  std::optional<std::int64_t> scan_;
  std::vector<double> turns_;
  std::vector<QPushButton*> buttons_;
};

}  // namespace vantage
