#include "scanner/patient_devices.h"

namespace vantage {
namespace {

// What both kinds of devices have in common.
template <typename DeviceKind>
void openPatiently(const std::shared_ptr<DeviceKind>& device, Patience& patience, const Progress& progress) {
  patience.run(
      "opening", [device](const Progress& inner) { device->open(inner); }, progress);
}

// One that hangs is closed by whoever drops it last, when it comes back.
template <typename DeviceKind>
void closeBriefly(const std::shared_ptr<DeviceKind>& device, Patience& patience) noexcept {
  if (!patience.hanging()) patience.runBriefly([device] { device->close(); });
}

std::optional<std::string> notReadyOf(const Device& device, const Patience& patience) {
  if (patience.hanging()) return "it has not come back since it stopped answering; start it again, or wait for it";
  return device.notReady();
}

}  // namespace

PatientSensor::PatientSensor(std::shared_ptr<RangeSensor> sensor, std::chrono::milliseconds patience)
    : sensor_(std::move(sensor)), identity_(sensor_->identity()), patience_(identity_, patience) {}

PatientSensor::~PatientSensor() {
  closeBriefly(sensor_, patience_);
}

void PatientSensor::open(const Progress& progress) {
  openPatiently(sensor_, patience_, progress);
}

void PatientSensor::close() noexcept {
  closeBriefly(sensor_, patience_);
}

std::optional<std::string> PatientSensor::notReady() const {
  return notReadyOf(*sensor_, patience_);
}

RangeImage PatientSensor::capture(const Progress& progress) {
  return patience_.call<RangeImage>(
      "scanning", [sensor = sensor_](const Progress& inner) { return sensor->capture(inner); }, progress);
}

void PatientSensor::announceMove() {
  if (!patience_.hanging()) sensor_->announceMove();
}

void PatientSensor::standAt(const ReachedPose& pose) {
  if (!patience_.hanging()) sensor_->standAt(pose);
}

PatientPositioner::PatientPositioner(std::shared_ptr<Positioner> positioner, std::chrono::milliseconds patience)
    : positioner_(std::move(positioner)), identity_(positioner_->identity()), patience_(identity_, patience) {}

PatientPositioner::~PatientPositioner() {
  closeBriefly(positioner_, patience_);
}

void PatientPositioner::open(const Progress& progress) {
  openPatiently(positioner_, patience_, progress);
}

void PatientPositioner::close() noexcept {
  closeBriefly(positioner_, patience_);
}

std::optional<std::string> PatientPositioner::notReady() const {
  return notReadyOf(*positioner_, patience_);
}

ReachedPose PatientPositioner::moveTo(int position, const Progress& progress) {
  return patience_.call<ReachedPose>(
      "moving to position " + std::to_string(position),
      [positioner = positioner_, position](const Progress& inner) { return positioner->moveTo(position, inner); },
      progress);
}

void PatientPositioner::standsFarther(double angle) {
  if (!patience_.hanging()) positioner_->standsFarther(angle);
}

std::optional<ReachedPose> PatientPositioner::where() const {
  if (patience_.hanging()) return {};
  return positioner_->where();
}

PatientTurntable::PatientTurntable(std::shared_ptr<Turntable> table, std::chrono::milliseconds patience)
    : table_(std::move(table)), patience_(table_->identity(), patience) {}

// Whoever drops the table itself closes it.
PatientTurntable::~PatientTurntable() = default;

void PatientTurntable::open(const Progress& progress) {
  openPatiently(table_, patience_, progress);
}

void PatientTurntable::close() noexcept {
  closeBriefly(table_, patience_);
}

std::optional<std::string> PatientTurntable::notReady() const {
  return notReadyOf(*table_, patience_);
}

void PatientTurntable::headFor(int position) {
  if (!patience_.hanging()) table_->headFor(position);
}

TableAngle PatientTurntable::turnTo(double degrees, const Progress& progress) {
  return patience_.call<TableAngle>(
      "turning", [table = table_, degrees](const Progress& inner) { return table->turnTo(degrees, inner); }, progress);
}

std::optional<TableAngle> PatientTurntable::jog(double degrees, const Progress& progress) {
  return patience_.call<std::optional<TableAngle>>(
      "turning", [table = table_, degrees](const Progress& inner) { return table->jog(degrees, inner); }, progress);
}

void PatientTurntable::ask(const Progress& progress) {
  patience_.run(
      "telling where it stands", [table = table_](const Progress& inner) { table->ask(inner); }, progress);
}

std::optional<TableAngle> PatientTurntable::angle() const {
  if (patience_.hanging()) return {};
  return table_->angle();
}

void PatientTurntable::home(const Progress& progress) {
  patience_.run(
      "going home", [table = table_](const Progress& inner) { table->home(inner); }, progress);
}

Rig withPatience(const Rig& rig, std::chrono::milliseconds patience) {
  Rig patient{std::make_shared<PatientSensor>(rig.sensor, patience),
              std::make_shared<PatientPositioner>(rig.positioner, patience), nullptr};
  if (rig.table) patient.table = std::make_shared<PatientTurntable>(rig.table, patience);
  return patient;
}

}  // namespace vantage
