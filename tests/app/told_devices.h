#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/errors.h"
#include "devices/device_factory.h"
#include "geometry/mesh.h"
#include "scanner/turntable_positioner.h"
#include "set_up.h"
#include "support/scenes/small_scene.h"

namespace vantage::testing {

/// A turntable that does what a test tells it to.
class ToldTable final : public Turntable {
 public:
  [[nodiscard]] std::string identity() const override { return "told table"; }
  void open(const Progress& /*progress*/) override {
    ++opened;
    problem.reset();
  }
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return problem; }
  [[nodiscard]] TableAngle turnTo(double degrees, const Progress& progress) override {
    progress.checkpoint(0.5);
    if (failsNext) problem = std::exchange(failsNext, std::nullopt);
    if (problem) throw DeviceError("told table: " + *problem);
    counted = degrees;
    return *angle();
  }
  void ask(const Progress& /*progress*/) override {
    if (vanished) problem = "was unplugged";
  }
  [[nodiscard]] std::optional<TableAngle> angle() const override { return TableAngle{counted, PoseSource::Reported}; }
  void home(const Progress& /*progress*/) override {
    ++homed;
    counted = 0.0;
  }

  double counted = 0.0;
  int opened = 0;
  int homed = 0;
  bool vanished = false;  ///< is noticed when it is asked
  std::optional<std::string> problem;
  std::optional<std::string> failsNext;  ///< the next turn does, with that problem
};

/// A scanner before an object on that table.
class SensorBeforeTable final : public RangeSensor {
 public:
  SensorBeforeTable(Mesh object, std::shared_ptr<const ScannerProfile> profile, std::shared_ptr<ToldTable> table)
      : object_(std::move(object)), profile_(std::move(profile)), table_(std::move(table)) {}

  [[nodiscard]] std::string identity() const override { return "scanner of a test"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }
  [[nodiscard]] RangeImage capture(const Progress& progress) override {
    Pose turned = Pose::Identity();
    turned.rotate(Eigen::AngleAxisd(radians(table_->counted), Vec3::UnitZ()));
    SimulationOptions options;
    options.seed = ++scans_;
    const auto still = std::make_shared<ScannerProfile>(*profile_);
    still->mechanics = {};
    RangeImage image = scanFrom(simulation(transformed(object_, turned), still, options), 0, progress);
    image.T_table_scanner = Pose::Identity();
    image.station = {};
    return image;
  }

 private:
  Mesh object_;
  std::shared_ptr<const ScannerProfile> profile_;
  std::shared_ptr<ToldTable> table_;
  std::uint64_t scans_ = 0;
};

/// Real devices, as a factory makes them: the small object on a told table.
struct ToldDevices {
  std::shared_ptr<ToldTable> table = std::make_shared<ToldTable>();
  int made = 0;
  std::string failsToOpen;  ///< why; empty: they open
  double handOff = 0.0;     ///< by so much a person turns the table wrong [deg]

  [[nodiscard]] DeviceFactory factory() {
    return DeviceFactory(DeviceFactory::kPatience, [this](const DeviceSetUp& setUp, std::int64_t /*scansBefore*/) {
      ++made;
      if (!failsToOpen.empty()) throw DeviceError(failsToOpen);
      const auto& real = std::get<RealDevices>(setUp);
      if (std::holds_alternative<HandTableDevice>(real.rig.table)) {
        const auto turn = [this, profile = real.profile](int position, const Progress&) {
          table->counted = tableAngleOf(*profile, position, 0.0) + handOff;
        };
        return Rig{std::make_shared<SensorBeforeTable>(smallObject(), real.profile, table),
                   std::make_shared<HandTable>(real.profile, turn, kTurnedByHand), nullptr};
      }
      return Rig{std::make_shared<SensorBeforeTable>(smallObject(), real.profile, table),
                 std::make_shared<TurntablePositioner>(real.profile, table, TurntableUse{real.stands, false}), table};
    });
  }
};

/// A set-up with a folder that is watched and a table on a port; neither is there.
[[nodiscard]] inline std::shared_ptr<SetUp> realSetUp() {
  auto setUp = std::make_shared<SetUp>();
  setUp->choice.rig = {FolderDevice{"/nowhere"}, SerialTableDevice{"/dev/nothing", {}}, {}, {}};
  setUp->source = smallProfileSource();
  setUp->profile = smallProfile();
  connectDevices(*setUp);
  return setUp;
}

}  // namespace vantage::testing
