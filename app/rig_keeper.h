#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "devices/device_factory.h"
#include "set_up.h"

namespace vantage {

/// Real devices stay open from one job to the next: opening a turntable anew restarts it. One user at a time.
class RigKeeper {
 public:
  explicit RigKeeper(DeviceFactory factory) : factory_(std::move(factory)) {}

  /// The devices while somebody uses them: nobody else does meanwhile.
  class Use {
   public:
    [[nodiscard]] const Rig& rig() const { return rig_; }
    /// After a failure they are opened anew the next time.
    void drop();

   private:
    friend class RigKeeper;
    Use(RigKeeper& keeper, std::unique_lock<std::timed_mutex> alone) : keeper_(&keeper), alone_(std::move(alone)) {}

    RigKeeper* keeper_;
    std::unique_lock<std::timed_mutex> alone_;
    Rig rig_;
  };

  /// The open devices of a set-up: those of the last time, when they are its own and can still be used. Waits for who
  /// uses them now.
  /// @param stands where the table stands, if it has to be opened. @throws DeviceError, Cancelled
  [[nodiscard]] Use open(const SharedSetUp& setUp, std::int64_t scansBefore, const TableStand& stands,
                         const Progress& progress);

  /// The devices of the last time, usable or not, when they are those of the set-up and nobody uses them; else nothing.
  [[nodiscard]] std::optional<Use> lookAt(const SharedSetUp& setUp);

 private:
  [[nodiscard]] bool keeps(const SetUp& setUp) const;

  DeviceFactory factory_;
  std::timed_mutex inUse_;
  std::optional<Rig> rig_;  // of real devices
  SharedSetUp of_;
};

}  // namespace vantage
