#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace vantage {

class CutPictureView;
class FigureTable;
class SessionController;
class SettingsForm;

/// A scan that is only looked at, what is cut of it because it is not the object, and the options of that.
class TestScanBox final : public QWidget {
  Q_OBJECT

 public:
  explicit TestScanBox(SessionController& controller, QWidget* parent = nullptr);

 private:
  void refresh();
  void refreshCut();

  SessionController& controller_;
  QPushButton* scan_;
  CutPictureView* picture_;
  QLabel* verdict_;
  FigureTable* figures_;
  SettingsForm* form_;
};

}  // namespace vantage
