#include "wizard/device_editor.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "base/errors.h"
#include "devices/serial/port_list.h"
#include "form_parts.h"
#include "program/installed_files.h"

namespace vantage {
namespace {

enum class SensorKind { Simulated, Folder, Camera, Replay, File };
enum class TableKind { Simulated, Serial, Hand, None, File };

QComboBox* makeBox(const QString& name, const QString& title, const QString& help) {
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->setAccessibleName(title);
  box->setToolTip(help);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumWidth(80);
  return box;
}

template <typename Kind>
Kind kindIn(const QComboBox& box) {
  return static_cast<Kind>(box.currentData().toInt());
}

void select(QComboBox& box, int kind) {
  box.setCurrentIndex(box.findData(kind));
}

struct SensorKindOf {
  SensorKind operator()(const SimulatedSensorDevice&) const { return SensorKind::Simulated; }
  SensorKind operator()(const FolderDevice&) const { return SensorKind::Folder; }
  SensorKind operator()(const OpenNi2Device&) const { return SensorKind::Camera; }
  SensorKind operator()(const ReplayDevice&) const { return SensorKind::Replay; }
  SensorKind operator()(const ProgramDevice&) const { return SensorKind::File; }
};

struct TableKindOf {
  TableKind operator()(const SimulatedTableDevice&) const { return TableKind::Simulated; }
  TableKind operator()(const NoTableDevice&) const { return TableKind::None; }
  TableKind operator()(const HandTableDevice&) const { return TableKind::Hand; }
  TableKind operator()(const SerialTableDevice&) const { return TableKind::Serial; }
  TableKind operator()(const ProgramDevice&) const { return TableKind::File; }
};

QString pathIn(const SensorDevice& sensor) {
  if (const auto* folder = std::get_if<FolderDevice>(&sensor)) return QString::fromStdString(folder->folder);
  if (const auto* replay = std::get_if<ReplayDevice>(&sensor)) return QString::fromStdString(replay->session);
  return {};
}

}  // namespace

DeviceEditor::DeviceEditor(QWidget* parent)
    : QWidget(parent),
      sensor_(makeBox(QStringLiteral("sensor"), tr("What scans"), tr("The range scanner that takes the scans."))),
      camera_(new QLineEdit),
      table_(makeBox(QStringLiteral("table"), tr("What turns"),
                     tr("What brings the object from one position to the next."))),
      port_(makeBox(QStringLiteral("port"), tr("Port of the turntable"),
                    tr("The serial port that the turntable is connected to; any path can be typed."))),
      protocol_(makeBox(QStringLiteral("protocol"), tr("Language of the turntable"),
                        tr("What the controller of the turntable speaks; it is asked when none is chosen."))),
      hint_(makeLabel(QString(), "muted")),
      complaint_(makeLabel(QString(), "warning")) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(makeLabel(tr("What scans"), "section"));
  column->addWidget(sensor_);
  sensorPath_ = addPathRow(*column, QStringLiteral("sensorPath"), {}, {});
  camera_->setObjectName(QStringLiteral("camera"));
  camera_->setAccessibleName(tr("Address of the camera"));
  camera_->setPlaceholderText(tr("The first camera that answers"));
  column->addWidget(camera_);
  column->addWidget(makeLabel(tr("What turns"), "section"));
  column->addWidget(table_);
  port_->setEditable(true);
  column->addWidget(port_);
  column->addWidget(protocol_);
  calibration_ =
      addPathRow(*column, QStringLiteral("calibration"), tr("No calibration: the table is where the profile says"),
                 tr("Where the table's axis is, which way and how far it turns, as measured."));
  column->addWidget(hint_);
  auto* load = makeButton(tr("&Load a rig…"), QStringLiteral("loadRig"),
                          tr("Take scanner, turntable, profile and calibration from a file. Programs as devices are "
                             "described that way."));
  connect(load, &QPushButton::clicked, this, [this] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Load a rig"), {}, tr("Rigs (*.json)"));
    if (!path.isEmpty()) loadRig(path);
  });
  load_ = load;
  column->addWidget(load);
  column->addWidget(complaint_);
  complaint_->hide();
  sensor_->addItem(tr("Simulated scanner"), static_cast<int>(SensorKind::Simulated));
  sensor_->addItem(tr("Files in a folder"), static_cast<int>(SensorKind::Folder));
  sensor_->addItem(tr("Depth camera (OpenNI2)"), static_cast<int>(SensorKind::Camera));
  sensor_->addItem(tr("Scans of a session again"), static_cast<int>(SensorKind::Replay));
  table_->addItem(tr("Simulated turntable"), static_cast<int>(TableKind::Simulated));
  table_->addItem(tr("Turntable on a serial port"), static_cast<int>(TableKind::Serial));
  table_->addItem(tr("By hand"), static_cast<int>(TableKind::Hand));
  table_->addItem(tr("Nothing: a single scan"), static_cast<int>(TableKind::None));
  protocol_->addItem(tr("Ask the turntable"), QString());
  const QDir protocols(QString::fromStdString(resourceFolder("turntables")));
  for (const QFileInfo& file : protocols.entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
    protocol_->addItem(file.completeBaseName(), file.completeBaseName());
  listPorts();
  connect(sensor_, &QComboBox::currentIndexChanged, this, &DeviceEditor::sensorChosen);
  for (QComboBox* box : {table_, port_, protocol_})
    connect(box, &QComboBox::currentIndexChanged, this, &DeviceEditor::refresh);
  connect(port_, &QComboBox::editTextChanged, this, &DeviceEditor::refresh);
  for (QLineEdit* edit : {sensorPath_.edit, camera_, calibration_.edit})
    connect(edit, &QLineEdit::textChanged, this, &DeviceEditor::refresh);
  connect(sensorPath_.browse, &QToolButton::clicked, this, [this] {
    const bool folder = kindIn<SensorKind>(*sensor_) == SensorKind::Folder;
    browse(sensorPath_, folder ? tr("Folder that range files are written to") : tr("Session"), folder,
           tr("Sessions (*.vantage)"));
  });
  connect(calibration_.browse, &QToolButton::clicked, this,
          [this] { browse(calibration_, tr("Calibration of the table"), false, tr("Calibrations (*.json)")); });
  refresh();
}

DeviceEditor::PathRow DeviceEditor::addPathRow(QVBoxLayout& column, const QString& name, const QString& placeholder,
                                               const QString& help) {
  PathRow row{new QLineEdit, new QToolButton};
  row.edit->setObjectName(name);
  row.edit->setPlaceholderText(placeholder);
  row.edit->setToolTip(help);
  row.browse->setObjectName(QStringLiteral("browse"));
  row.browse->setText(QStringLiteral("…"));
  row.browse->setToolTip(tr("Take another file"));
  row.browse->setAccessibleName(tr("Take another file"));
  auto* line = new QHBoxLayout;
  line->addWidget(row.edit, 1);
  line->addWidget(row.browse);
  column.addLayout(line);
  return row;
}

void DeviceEditor::browse(const PathRow& row, const QString& title, bool folder, const QString& filter) {
  const QString path = folder ? QFileDialog::getExistingDirectory(this, title, row.edit->text())
                              : QFileDialog::getOpenFileName(this, title, row.edit->text(), filter);
  if (!path.isEmpty()) row.edit->setText(path);
}

void DeviceEditor::loadRig(const QString& path) {
  try {
    const RigFile file = readRigFile(path.toStdString());
    setRig(file.rig);
    complaint_->hide();
    emit rigRead(file);
  } catch (const Error& e) {
    complaint_->setText(QString::fromUtf8(e.what()));
    complaint_->show();
  }
}

// What is connected now, with what it says of itself.
void DeviceEditor::listPorts() {
  const QSignalBlocker quiet(port_);
  const QString typed = port_->currentText();
  port_->clear();
  for (const PortDescription& port : serialPorts()) {
    port_->addItem(QString::fromStdString(port.path));
    port_->setItemData(port_->count() - 1, QString::fromStdString(describe(port)), Qt::ToolTipRole);
  }
  port_->setCurrentText(typed);
  port_->lineEdit()->setPlaceholderText(
      port_->count() == 0 ? tr("No port is there: connect the table, or type its path") : tr("Port of the turntable"));
}

// A simulated scanner sees a simulated table only.
void DeviceEditor::sensorChosen() {
  const bool simulated = kindIn<SensorKind>(*sensor_) == SensorKind::Simulated;
  const TableKind table = kindIn<TableKind>(*table_);
  if (simulated && table != TableKind::Hand) select(*table_, static_cast<int>(TableKind::Simulated));
  if (!simulated && table == TableKind::Simulated) select(*table_, static_cast<int>(TableKind::Serial));
  listPorts();
  refresh();
}

bool DeviceEditor::simulated() const {
  return kindIn<SensorKind>(*sensor_) == SensorKind::Simulated;
}

QString DeviceEditor::whyNot() const {
  const SensorKind sensor = kindIn<SensorKind>(*sensor_);
  const TableKind table = kindIn<TableKind>(*table_);
  if (sensor == SensorKind::Folder && sensorPath_.edit->text().trimmed().isEmpty())
    return tr("Choose the folder that the scanner's program writes to.");
  if (sensor == SensorKind::Replay && sensorPath_.edit->text().trimmed().isEmpty())
    return tr("Choose the session whose scans are taken again.");
  if (simulated() && table != TableKind::Simulated && table != TableKind::Hand)
    return tr("The simulated scanner sees the simulated table only.");
  if (!simulated() && table == TableKind::Simulated) return tr("A real scanner does not see the simulated table.");
  if (table == TableKind::Serial && port_->currentText().trimmed().isEmpty())
    return tr("Choose the port of the turntable.");
  return {};
}

RigDescription DeviceEditor::rig() const {
  RigDescription rig = given_;
  const std::string path = sensorPath_.edit->text().trimmed().toStdString();
  switch (kindIn<SensorKind>(*sensor_)) {
    case SensorKind::Simulated:
      rig.sensor = SimulatedSensorDevice{};
      break;
    case SensorKind::Folder:
      rig.sensor = FolderDevice{path};
      break;
    case SensorKind::Camera:
      rig.sensor = OpenNi2Device{camera_->text().trimmed().toStdString()};
      break;
    case SensorKind::Replay:
      rig.sensor = ReplayDevice{path};
      break;
    case SensorKind::File:
      break;
  }
  switch (kindIn<TableKind>(*table_)) {
    case TableKind::Simulated:
      rig.table = SimulatedTableDevice{};
      break;
    case TableKind::Serial:
      rig.table = SerialTableDevice{port_->currentText().trimmed().toStdString(),
                                    protocol_->currentData().toString().toStdString()};
      break;
    case TableKind::Hand:
      rig.table = HandTableDevice{};
      break;
    case TableKind::None:
      rig.table = NoTableDevice{};
      break;
    case TableKind::File:
      break;
  }
  rig.calibration = calibration_.edit->text().trimmed().toStdString();
  return rig;
}

void DeviceEditor::setRig(const RigDescription& rig) {
  given_ = rig;
  const SensorKind sensor = std::visit(SensorKindOf{}, rig.sensor);
  const TableKind table = std::visit(TableKindOf{}, rig.table);
  if (sensor == SensorKind::File && sensor_->findData(static_cast<int>(sensor)) < 0)
    sensor_->addItem(QString::fromStdString(describe(rig.sensor)), static_cast<int>(sensor));
  if (table == TableKind::File && table_->findData(static_cast<int>(table)) < 0)
    table_->addItem(QString::fromStdString(describe(rig.table)), static_cast<int>(table));
  const QSignalBlocker quiet(sensor_);
  select(*sensor_, static_cast<int>(sensor));
  select(*table_, static_cast<int>(table));
  sensorPath_.edit->setText(pathIn(rig.sensor));
  if (const auto* camera = std::get_if<OpenNi2Device>(&rig.sensor))
    camera_->setText(QString::fromStdString(camera->uri));
  if (const auto* serial = std::get_if<SerialTableDevice>(&rig.table)) {
    port_->setCurrentText(QString::fromStdString(serial->port));
    protocol_->setCurrentIndex(std::max(0, protocol_->findData(QString::fromStdString(serial->protocol))));
  }
  calibration_.edit->setText(QString::fromStdString(rig.calibration));
  refresh();
}

std::vector<QWidget*> DeviceEditor::editors() const {
  return {sensor_,   sensorPath_.edit,  sensorPath_.browse,  camera_, table_, port_,
          protocol_, calibration_.edit, calibration_.browse, load_};
}

void DeviceEditor::refresh() {
  const SensorKind sensor = kindIn<SensorKind>(*sensor_);
  const TableKind table = kindIn<TableKind>(*table_);
  const bool path = sensor == SensorKind::Folder || sensor == SensorKind::Replay;
  sensorPath_.edit->setVisible(path);
  sensorPath_.browse->setVisible(path);
  sensorPath_.edit->setPlaceholderText(sensor == SensorKind::Folder ? tr("Folder that range files are written to")
                                                                    : tr("Session"));
  sensorPath_.edit->setAccessibleName(sensorPath_.edit->placeholderText());
  camera_->setVisible(sensor == SensorKind::Camera);
  for (QWidget* widget : {static_cast<QWidget*>(port_), static_cast<QWidget*>(protocol_)})
    widget->setVisible(table == TableKind::Serial);
  const bool calibrated = sensor != SensorKind::Simulated;
  calibration_.edit->setVisible(calibrated);
  calibration_.edit->setAccessibleName(tr("Calibration of the table"));
  calibration_.browse->setVisible(calibrated);
  hint_->setText(
      table == TableKind::Hand
          ? tr("You turn the table as the dial says, about as far as asked: where it really came to stand is "
               "found from the scan.")
          : QString());
  hint_->setVisible(!hint_->text().isEmpty());
  emit edited();
}

}  // namespace vantage
