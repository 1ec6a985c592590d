#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <fstream>

#include "io/mesh_writer.h"
#include "session_controller.h"
#include "support/scenes/small_scene.h"
#include "support/stuck_devices.h"

// A device that hangs holds neither the window nor a job of it, and who leaves does not wait for it.

namespace vantage {
namespace {

using testing::Stuck;
using testing::StuckSensor;
using testing::StuckTable;

constexpr std::chrono::hours kForEver{1};
constexpr int kSoon = 5000;  // [ms]; on a busy machine

// Runs the event loop until the condition holds, for some seconds at most.
template <typename Condition>
bool waitFor(Condition condition) {
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < 30000) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
  return condition();
}

// A controller before the small object and scanner, whose sensor or table is stuck.
class HangingDevices : public ::testing::TestWithParam<bool> {
 protected:
  HangingDevices() {
    std::ofstream(path("scanner.json")) << testing::smallProfileSource().text;
    exportMesh(testing::smallObject(), path("object.ply"));
  }
  ~HangingDevices() override { stuck_->go = true; }

  void begin(std::chrono::milliseconds patience) {
    const auto hanging = [sensor = GetParam(), stuck = stuck_](const DeviceSetUp& setUp, std::int64_t scansBefore) {
      Rig rig = makeDevices(setUp, scansBefore);
      if (sensor)
        rig.sensor = std::make_shared<StuckSensor>(stuck);
      else
        rig.positioner = std::make_shared<StuckTable>(stuck);
      return rig;
    };
    controller_ = std::make_unique<SessionController>(*jobs_, "", DeviceFactory(patience, hanging));
    QObject::connect(controller_.get(), &SessionController::failed, [this](const QString& what) { failure_ = what; });
    SetUpChoice choice;
    choice.scanner = path("scanner.json");
    choice.folder = path("out");
    choice.settings.simulation.object = path("object.ply");
    controller_->setChoice(choice);
    controller_->prepare();
    ASSERT_TRUE(waitFor([&] { return controller_->setUp() && controller_->idle(); }));
  }

  [[nodiscard]] std::string path(const QString& name) const { return folder_.filePath(name).toStdString(); }

  QTemporaryDir folder_;
  std::shared_ptr<Stuck> stuck_ = std::make_shared<Stuck>();
  std::unique_ptr<JobRunner> jobs_ = std::make_unique<ThreadedJobRunner>(1);
  std::unique_ptr<SessionController> controller_;
  QString failure_;
};
INSTANTIATE_TEST_SUITE_P(Either, HangingDevices, ::testing::Values(true, false),
                         [](const auto& kind) { return kind.param ? "Sensor" : "Table"; });

TEST_P(HangingDevices, AreGivenUpWithAMessage) {
  begin(std::chrono::seconds(4));  // the other device answers within that also on a busy machine
  controller_->testTurn();
  ASSERT_TRUE(waitFor([&] { return controller_->idle(); }));
  EXPECT_TRUE(failure_.contains(GetParam() ? "stuck sensor has not answered" : "stuck table has not answered"))
      << failure_.toStdString();
  failure_.clear();
  controller_->step();
  ASSERT_TRUE(waitFor([&] { return controller_->idle(); }));
  EXPECT_TRUE(failure_.contains("has not answered")) << failure_.toStdString();
}

TEST_P(HangingDevices, AreStoppedSoon) {
  begin(kForEver);
  for (const bool test : {true, false}) {
    if (test)
      controller_->testTurn();
    else
      controller_->run();
    QElapsedTimer timer;
    timer.start();
    ASSERT_TRUE(waitFor([&] { return timer.elapsed() > 200; }));
    EXPECT_FALSE(controller_->idle());
    timer.restart();
    controller_->stop();
    ASSERT_TRUE(waitFor([&] { return controller_->idle(); }));
    EXPECT_LT(timer.elapsed(), kSoon);
    EXPECT_TRUE(failure_.isEmpty()) << failure_.toStdString();
  }
}

TEST_P(HangingDevices, DoNotHoldWhoLeaves) {
  begin(kForEver);
  controller_->testTurn();
  QElapsedTimer timer;
  timer.start();
  ASSERT_TRUE(waitFor([&] { return timer.elapsed() > 200; }));
  EXPECT_FALSE(controller_->idle());
  timer.restart();
  controller_.reset();
  jobs_.reset();
  EXPECT_LT(timer.elapsed(), kSoon);
}

}  // namespace
}  // namespace vantage
