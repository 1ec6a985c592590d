#include "wizard/device_box.h"

#include <QGridLayout>
#include <QTimer>
#include <QVBoxLayout>

#include "form_parts.h"
#include "session_controller.h"

namespace vantage {
namespace {

// Between two looks at devices that nobody uses.
constexpr int kLookEvery = 1500;  // [ms]

}  // namespace

DeviceBox::DeviceBox(SessionController& controller, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      look_(new QTimer(this)),
      states_(new FigureTable),
      failure_(makeLabel({}, "warning")),
      connect_(makeButton(tr("&Connect again"), QStringLiteral("connectDevices"),
                          tr("Open the devices anew. A turntable then counts from where it stands."))),
      tableRow_(new QWidget),
      home_(makeButton(tr("Ho&me"), QStringLiteral("home"),
                       tr("Let the table find its index, where it has one, and count from there."))),
      stop_(makeButton(tr("St&op"), QStringLiteral("stopDevice"), tr("Stop the table, and whatever else goes on."))) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(states_);
  column->addWidget(failure_);
  failure_->setObjectName(QStringLiteral("deviceFailure"));
  column->addWidget(connect_);
  auto* grid = new QGridLayout(tableRow_);
  grid->setContentsMargins(0, 0, 0, 0);
  for (const double degrees : {-30.0, -5.0, 5.0, 30.0}) addJog(degrees);
  for (std::size_t i = 0; i < jogs_.size(); ++i) grid->addWidget(jogs_[i], 0, static_cast<int>(i));
  grid->addWidget(home_, 1, 0, 1, 2);
  grid->addWidget(stop_, 1, 2, 1, 2);
  column->addWidget(tableRow_);
  DeviceBench& bench = controller.bench();
  connect(connect_, &QPushButton::clicked, &bench, &DeviceBench::connectDevices);
  connect(home_, &QPushButton::clicked, &bench, &DeviceBench::home);
  connect(stop_, &QPushButton::clicked, &controller, &SessionController::stop);
  connect(&bench, &DeviceBench::changed, this, &DeviceBox::refresh);
  connect(&controller, &SessionController::activityChanged, this, &DeviceBox::refresh);
  look_->setInterval(kLookEvery);
  connect(look_, &QTimer::timeout, &bench, &DeviceBench::look);
  refresh();
}

void DeviceBox::addJog(double degrees) {
  const QString angle = (degrees > 0 ? QStringLiteral("+") : QStringLiteral("−")) +
                        QString::number(std::abs(degrees), 'f', 0) + QStringLiteral("°");
  auto* jog =
      makeButton(angle, QStringLiteral("jog%1").arg(degrees), tr("Turn the table by %1 as it counts.").arg(angle));
  connect(jog, &QPushButton::clicked, this, [this, degrees] { controller_.bench().jog(degrees); });
  jogs_.push_back(jog);
}

void DeviceBox::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  look_->start();
}

void DeviceBox::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  look_->stop();
}

QString DeviceBox::whyNot() const {
  if (!controller_.idle()) return tr("Something else is under way.");
  return controller_.bench().connected() ? QString() : tr("The devices are not connected.");
}

void DeviceBox::refresh() {
  const DeviceBench& bench = controller_.bench();
  states_->clear();
  for (const DeviceState& device : bench.states())
    states_->add(device.what, device.ready ? tr("ready") : tr("not ready"),
                 device.identity + QStringLiteral("\n") + device.state);
  if (!bench.connected())
    states_->add(tr("Devices"), controller_.idle() ? tr("not connected") : tr("being connected…"));
  failure_->setText(bench.failure());
  failure_->setVisible(!bench.failure().isEmpty());
  tableRow_->setVisible(bench.hasTable());
  const QString why = whyNot();
  for (QPushButton* jog : jogs_) allow(*jog, why);
  allow(*home_, why);
  connect_->setText(bench.connected() ? tr("&Connect again") : tr("&Connect"));
  allow(*connect_, controller_.idle() ? QString() : tr("Something else is under way."));
  const bool stoppable = !controller_.idle() && controller_.activity() != Activity::Stopping;
  allow(*stop_, stoppable ? QString() : tr("Nothing runs that could be stopped."));
}

}  // namespace vantage
