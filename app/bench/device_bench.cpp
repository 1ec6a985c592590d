#include "bench/device_bench.h"

#include <QCoreApplication>
#include <cmath>

#include "base/errors.h"
#include "look/figures.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(DeviceBench)
};

DeviceState stateOf(const QString& what, const Device& device) {
  const auto problem = device.notReady();
  return {what, QString::fromStdString(device.identity()),
          problem ? QString::fromStdString(*problem) : Text::tr("Ready."), !problem};
}

// What a table says of its angle, in the words of who looks at it.
QString standing(const TableAngle& angle) {
  const QString degrees = figureText(std::abs(angle.degrees) < 0.005 ? 0.0 : angle.degrees, 2);
  return angle.knownBy == PoseSource::Reported ? Text::tr("At rest at %1°, as it reports.").arg(degrees)
                                               : Text::tr("Told to stand at %1°; it does not report.").arg(degrees);
}

std::vector<DeviceState> statesOf(const Rig& rig) {
  std::vector<DeviceState> states{stateOf(Text::tr("Scanner"), *rig.sensor),
                                  stateOf(Text::tr("Turntable"), *rig.positioner)};
  if (rig.table && states.back().ready) {
    const auto angle = rig.table->angle();
    states.back().state = angle ? standing(*angle) : Text::tr("Ready; where it stands is known after its first move.");
  }
  return states;
}

}  // namespace

DeviceBench::DeviceBench(Undertaking& work, JobRunner& jobs, std::shared_ptr<RigKeeper> devices, QObject* parent)
    : QObject(parent), work_(work), jobs_(jobs), devices_(std::move(devices)) {}

void DeviceBench::setSetUp(const SharedSetUp& setUp) {
  const bool same = setUp && setUp_ && setUp->choice.rig == setUp_->choice.rig && setUp->profile == setUp_->profile;
  setUp_ = setUp;
  if (!same) show({});
}

bool DeviceBench::real() const {
  return setUp_ && setUp_->devices && std::holds_alternative<RealDevices>(*setUp_->devices);
}

bool DeviceBench::hasTable() const {
  return real() && turnsByItself(setUp_->choice.rig.table);
}

void DeviceBench::show(Outcome outcome) {
  states_ = std::move(outcome.states);
  failure_ = std::move(outcome.failure);
  emit changed();
}

// Whatever comes of it, the devices then are as they say.
void DeviceBench::carryOut(const QString& title, Deed deed) {
  if (!real()) return;
  work_.begin<Outcome>(
      Activity::Testing, title,
      [setUp = setUp_, devices = devices_, deed = std::move(deed)](const Progress& progress) {
        RigKeeper::Use use = devices->open(setUp, 0, {}, progress.part(0.0, 0.3));
        Outcome outcome;
        try {
          deed(use.rig(), progress.part(0.3, 1.0));
        } catch (const DeviceError& e) {
          outcome.failure = QString::fromUtf8(e.what());
        }
        outcome.states = statesOf(use.rig());
        return outcome;
      },
      [this](Outcome outcome) { show(std::move(outcome)); },
      [this](const QString& why) {
        show({{}, why});
      });
}

void DeviceBench::connectDevices() {
  carryOut(tr("Connecting the devices"), [](const Rig&, const Progress&) {});
}

void DeviceBench::jog(double degrees) {
  carryOut(tr("Turning the table"), [degrees](const Rig& rig, const Progress& progress) {
    if (rig.table) static_cast<void>(rig.table->jog(degrees, progress));
  });
}

void DeviceBench::home() {
  carryOut(tr("Setting the reference of the table"), [](const Rig& rig, const Progress& progress) {
    if (rig.table) rig.table->home(progress);
  });
}

void DeviceBench::look() {
  if (looking_ || !connected() || !work_.idle()) return;
  looking_ = true;
  using Found = std::optional<std::vector<DeviceState>>;
  jobs_.run<Found>(
      {},
      [setUp = setUp_, devices = devices_](const Progress& progress) -> Found {
        const auto use = devices->lookAt(setUp);
        if (!use) return std::nullopt;
        try {
          if (use->rig().table) use->rig().table->ask(progress);
        } catch (const DeviceError&) {
          // What is wrong with it is its state.
        }
        return statesOf(use->rig());
      },
      [this, of = setUp_](JobResult<Found> result) {
        looking_ = false;
        if (!result.value || !connected() || of != setUp_) return;
        if (!*result.value) {
          // Those that failed elsewhere are kept no more.
          if (work_.idle() && !devices_->lookAt(setUp_))
            show({{}, tr("The devices were given up after a failure. Connect them again.")});
          return;
        }
        states_ = std::move(**result.value);
        emit changed();
      });
}

}  // namespace vantage
