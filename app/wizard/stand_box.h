#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace vantage {

class StandDesk;
class SessionController;

/// How it stands with the stand of now after the object was turned over: what came of aligning it, and the ways on.
/// Hidden for the first stand.
class StandBox final : public QWidget {
  Q_OBJECT

 public:
  StandBox(SessionController& controller, StandDesk& desk, QWidget* parent = nullptr);

 signals:
  void turnWanted();

 private:
  void refresh();

  StandDesk& desk_;
  QLabel* sentence_;
  QPushButton* align_;
  QPushButton* compare_;
  QPushButton* turn_;
  QPushButton* back_;
};

}  // namespace vantage
