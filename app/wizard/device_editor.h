#pragma once

#include <QWidget>
#include <vector>

#include "devices/rig_description.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;
class QVBoxLayout;

namespace vantage {

/// What scans and what turns: a kind each, with what has to be known of it.
class DeviceEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceEditor(QWidget* parent = nullptr);

  [[nodiscard]] RigDescription rig() const;
  void setRig(const RigDescription& rig);

  /// Whether the sensor and the table are simulated: then an object is needed.
  [[nodiscard]] bool simulated() const;
  /// What is missing, as a sentence; empty for nothing.
  [[nodiscard]] QString whyNot() const;
  /// Everything that can be edited.
  [[nodiscard]] std::vector<QWidget*> editors() const;

 signals:
  void edited();
  void rigRead(const RigFile& file);  ///< what a file says of a rig is shown; its profile and cut are for others

 private:
  struct PathRow {
    QLineEdit* edit = nullptr;
    QToolButton* browse = nullptr;
  };

  PathRow addPathRow(QVBoxLayout& column, const QString& name, const QString& placeholder, const QString& help);
  void browse(const PathRow& row, const QString& title, bool folder, const QString& filter);
  void loadRig(const QString& path);
  void listPorts();
  void sensorChosen();
  void refresh();

  QComboBox* sensor_;
  PathRow sensorPath_;
  QLineEdit* camera_;
  QComboBox* table_;
  QComboBox* port_;
  QComboBox* protocol_;
  PathRow calibration_;
  QLabel* hint_;
  QLabel* complaint_;
  QWidget* load_ = nullptr;
  RigDescription given_;  ///< programs are described in a file, and kept as they came
};

}  // namespace vantage
