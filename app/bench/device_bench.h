#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "rig_keeper.h"
#include "undertaking.h"

namespace vantage {

/// How a device is now.
struct DeviceState {
  QString what;      ///< "Scanner", "Turntable"
  QString identity;  ///< as the device says
  QString state;     ///< where it stands, or what keeps it from being used and what to do
  bool ready = false;
};

/// The devices of a set-up before anything is scanned with them: connected, asked how they are, the table turned by
/// hand of the operator. Lives on the UI thread; every call returns at once.
class DeviceBench final : public QObject {
  Q_OBJECT

 public:
  DeviceBench(Undertaking& work, JobRunner& jobs, std::shared_ptr<RigKeeper> devices, QObject* parent = nullptr);

  /// The set-up whose devices they are; another one forgets what was known.
  void setSetUp(const SharedSetUp& setUp);

  /// Whether they are real devices, which can be connected and disconnected.
  [[nodiscard]] bool real() const;
  /// Whether the table can be turned from here. It may yet refuse.
  [[nodiscard]] bool hasTable() const;
  /// As known last; empty before they were connected.
  [[nodiscard]] const std::vector<DeviceState>& states() const { return states_; }
  [[nodiscard]] bool connected() const { return !states_.empty(); }
  /// Why the last thing that was asked of them was not done; empty when it was.
  [[nodiscard]] const QString& failure() const { return failure_; }

  void connectDevices();
  /// Asks the devices how they are, unless they are busy with something else.
  void look();
  /// Turns the table by so many degrees as it counts.
  void jog(double degrees);
  /// Lets the table find its index where it has one, and count from there.
  void home();

 signals:
  void changed();

 private:
  struct Outcome {
    std::vector<DeviceState> states;
    QString failure;
  };
  using Deed = std::function<void(const Rig&, const Progress&)>;

  void carryOut(const QString& title, Deed deed);
  void show(Outcome outcome);

  Undertaking& work_;
  JobRunner& jobs_;
  std::shared_ptr<RigKeeper> devices_;
  SharedSetUp setUp_;
  std::vector<DeviceState> states_;
  QString failure_;
  bool looking_ = false;
};

}  // namespace vantage
