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

Rig withPatience(const Rig& rig, std::chrono::milliseconds patience) {
  return {std::make_shared<PatientSensor>(rig.sensor, patience),
          std::make_shared<PatientPositioner>(rig.positioner, patience)};
}

}  // namespace vantage
