#pragma once

#include <chrono>

#include "scanner/patience.h"
#include "scanner/rig.h"

namespace vantage {

/// A sensor that is given up when it shows no sign of life for too long (see Patience).
class PatientSensor final : public RangeSensor {
 public:
  PatientSensor(std::shared_ptr<RangeSensor> sensor, std::chrono::milliseconds patience);
  ~PatientSensor() override;

  [[nodiscard]] std::string identity() const override { return identity_; }
  /// @throws as every call here DeviceError also when the device does not answer, and until it comes back; Cancelled
  /// soon, whether the device listens or not.
  void open(const Progress& progress) override;
  /// Waits for the device no longer than for a moment.
  void close() noexcept override;
  [[nodiscard]] std::optional<std::string> notReady() const override;
  [[nodiscard]] RangeImage capture(const Progress& progress) override;
  void announceMove() override;
  void standAt(const ReachedPose& pose) override;

 private:
  std::shared_ptr<RangeSensor> sensor_;
  std::string identity_;
  Patience patience_;
};

/// The same of a positioner. Where it stands is not known while it does not answer.
class PatientPositioner final : public Positioner {
 public:
  PatientPositioner(std::shared_ptr<Positioner> positioner, std::chrono::milliseconds patience);
  ~PatientPositioner() override;

  [[nodiscard]] std::string identity() const override { return identity_; }
  void open(const Progress& progress) override;
  void close() noexcept override;
  [[nodiscard]] std::optional<std::string> notReady() const override;
  [[nodiscard]] ReachedPose moveTo(int position, const Progress& progress) override;
  void standsFarther(double angle) override;
  [[nodiscard]] std::optional<ReachedPose> where() const override;

 private:
  std::shared_ptr<Positioner> positioner_;
  std::string identity_;
  Patience patience_;
};

/// The same of a turntable. Where it stands is not known while it does not answer.
class PatientTurntable final : public Turntable {
 public:
  PatientTurntable(std::shared_ptr<Turntable> table, std::chrono::milliseconds patience);
  ~PatientTurntable() override;

  [[nodiscard]] std::string identity() const override { return table_->identity(); }
  void open(const Progress& progress) override;
  void close() noexcept override;
  [[nodiscard]] std::optional<std::string> notReady() const override;
  void headFor(int position) override;
  [[nodiscard]] TableAngle turnTo(double degrees, const Progress& progress) override;
  [[nodiscard]] std::optional<TableAngle> jog(double degrees, const Progress& progress) override;
  void ask(const Progress& progress) override;
  [[nodiscard]] std::optional<TableAngle> angle() const override;
  void home(const Progress& progress) override;

 private:
  std::shared_ptr<Turntable> table_;
  Patience patience_;
};

/// The rig with all its devices given up when they show no sign of life for too long.
[[nodiscard]] Rig withPatience(const Rig& rig, std::chrono::milliseconds patience);

}  // namespace vantage
