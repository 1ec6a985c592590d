#pragma once

#include "wizard/wizard_page.h"

class QLabel;
class QPushButton;

namespace vantage {

class DeviceBox;
class FigureTable;
class TestScanBox;
class VolumeSketch;

/// Whether the set-up fits: the devices as they are, viewing volume, what a scan sees, and a test turn.
class CheckPage final : public WizardPage {
  Q_OBJECT

 public:
  explicit CheckPage(SessionController& controller, QWidget* parent = nullptr);

  [[nodiscard]] QString key() const override { return QStringLiteral("check"); }
  [[nodiscard]] QString title() const override { return tr("Check the set-up"); }
  [[nodiscard]] QString whatNext() const override;
  [[nodiscard]] QString nextText() const override;
  [[nodiscard]] bool complete() const override;
  [[nodiscard]] QString whyNotNext() const override;
  void entered() override;

 private:
  void refresh();
  void refreshTestTurn();
  void connectDevices();
  [[nodiscard]] bool calibrates() const;
  void fit();

  QLabel* devicesTitle_;
  DeviceBox* devices_;
  QLabel* memory_;
  QLabel* verdict_;
  VolumeSketch* sketch_;
  FigureTable* figures_;
  QPushButton* fit_;
  TestScanBox* testScan_;
  QPushButton* turn_;
  QLabel* turnVerdict_;
  FigureTable* turnFigures_;
};

}  // namespace vantage
