#include "views/threaded_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <QTest>
#include <QWidget>
#include <atomic>
#include <chrono>
#include <semaphore>
#include <thread>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr int kPatience = 20000;  // [ms]
constexpr QSize kSize(240, 160);

// What happened in a window.
struct Log {
  std::mutex mutex;
  std::vector<double> eyes;  // x of the camera, per picture
  std::thread::id drawer;
  std::thread::id releaser;
  std::counting_semaphore<> gate{1000};  // a picture passes once per permit
  std::atomic<int> begun = 0;
  std::atomic<int> drawn = 0;
  std::atomic<bool> fails = false;
};

// Draws nothing but red, and no more pictures than it is let.
class RedWindow final : public OffscreenWindow {
 public:
  explicit RedWindow(Log& log) : log_(log) {}

  QImage render(Scene& scene, const Camera& camera, const QSize& pixels, double pixelRatio) override {
    scene.prepare(camera, pixelRatio);
    ++log_.begun;
    log_.gate.acquire();
    if (log_.fails) throw DeviceError("no colour");
    {
      const std::lock_guard lock(log_.mutex);
      log_.eyes.push_back(camera.eye.x());
      log_.drawer = std::this_thread::get_id();
    }
    ++log_.drawn;
    QImage image(pixels, QImage::Format_RGB888);
    image.fill(Qt::red);
    image.setDevicePixelRatio(pixelRatio);
    return image;
  }
  void release() override { log_.releaser = std::this_thread::get_id(); }

 private:
  Log& log_;
};

// A scene in sight on a thread of its own.
class ThreadedSurface : public ::testing::Test {
 protected:
  void show() {
    parent_.resize(kSize);
    surface_->widget().setGeometry(parent_.rect());
    parent_.show();
  }
  // The picture on the screen as far as it is there.
  [[nodiscard]] QImage onScreen() { return surface_->widget().grab().toImage().convertToFormat(QImage::Format_RGB32); }
  [[nodiscard]] bool isRed(double x = 0.5) {
    const QImage image = onScreen();
    return image.pixelColor(static_cast<int>(x * (image.width() - 1)), image.height() / 2) == QColor(Qt::red);
  }
  void lookFrom(double x) {
    Camera camera;
    camera.eye.x() = x;
    scene_.setCamera(camera);
    surface_->update();
  }
  void closeGate() {
    while (log_.gate.try_acquire()) {
    }
  }
  [[nodiscard]] bool waitForPictures(int count) {
    return QTest::qWaitFor([&] { return log_.drawn == count; }, kPatience);
  }

  Log log_;
  Scene scene_;
  QWidget parent_;
  std::unique_ptr<RenderSurface> surface_ = threadedSurfaces(
      std::make_shared<RenderThread>(), [this] { return std::make_unique<RedWindow>(log_); })(scene_, parent_);
};

TEST_F(ThreadedSurface, DrawsAndReleasesBesideTheUiThread) {
  show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return isRed(); }, kPatience));
  surface_.reset();
  EXPECT_NE(log_.drawer, std::this_thread::get_id());
  EXPECT_EQ(log_.releaser, log_.drawer);
}

TEST_F(ThreadedSurface, OfManyUpdatesDuringAPictureOnlyTheLastIsDrawn) {
  closeGate();
  show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return log_.begun == 1; }, kPatience));
  for (int x = 1; x <= 50; ++x) lookFrom(x);
  log_.gate.release(1000);
  ASSERT_TRUE(waitForPictures(2));
  QTest::qWait(50);
  EXPECT_EQ(log_.drawn, 2);
  EXPECT_EQ(log_.eyes.back(), 50.0);
}

TEST_F(ThreadedSurface, ChangesDuringAPictureWaitForTheNextInTheirOrder) {
  closeGate();
  show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return log_.begun == 1; }, kPatience));
  std::vector<int> order;
  for (int i = 0; i < 3; ++i) scene_.change([&order, i] { order.push_back(i); });
  EXPECT_TRUE(order.empty());
  surface_->update();
  log_.gate.release(1000);
  ASSERT_TRUE(waitForPictures(2));
  EXPECT_EQ(order, (std::vector{0, 1, 2}));
}

TEST_F(ThreadedSurface, ShowsTheOldPictureUntilOneOfTheNewSizeIsThere) {
  show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return isRed(); }, kPatience));
  closeGate();
  surface_->widget().resize(3 * kSize);
  EXPECT_TRUE(isRed());
  log_.gate.release(1000);
  surface_->widget().resize(QSize(10 * kSize.width(), kSize.height()));
  EXPECT_TRUE(QTest::qWaitFor([&] { return isRed(0.0) && isRed(1.0); }, kPatience)) << "a picture of all of it";
}

TEST_F(ThreadedSurface, ClosingDuringAPictureLosesNoChange) {
  closeGate();
  show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return log_.begun == 1; }, kPatience));
  bool changed = false;
  scene_.change([&] { changed = true; });
  // The picture ends while the surface waits for it; what the first paint asked for besides is not drawn any more.
  std::thread opener([this] {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    log_.gate.release(1000);
  });
  surface_.reset();
  opener.join();
  EXPECT_TRUE(changed);
  EXPECT_EQ(log_.drawn, 1);
}

TEST_F(ThreadedSurface, HiddenItIsNotDrawnButKeepsUp) {
  std::atomic<bool> changed = false;
  scene_.change([&] { changed = true; });
  surface_->update();
  EXPECT_TRUE(QTest::qWaitFor([&] { return changed.load(); }, kPatience));
  EXPECT_EQ(log_.begun, 0);
}

TEST_F(ThreadedSurface, PicturesAreTakenFromElsewhereWithoutMovingTheCamera) {
  show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return isRed(); }, kPatience));
  Camera elsewhere;
  elsewhere.eye.x() = -7.0;
  QSize taken;
  surface_->takePicture(elsewhere, [&](const QImage& picture) { taken = picture.size(); });
  EXPECT_TRUE(QTest::qWaitFor([&] { return taken == kSize; }, kPatience));
  surface_.reset();
  // The surface itself may have been drawn once more meanwhile, but never from there.
  EXPECT_EQ(std::count(log_.eyes.begin(), log_.eyes.end(), -7.0), 1);
  EXPECT_NE(scene_.camera().eye.x(), -7.0);
}

TEST_F(ThreadedSurface, SaysWhyNothingCanBeDrawn) {
  log_.fails = true;
  show();
  const QRgb ink = scene_.theme().text.rgb();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const QImage image = onScreen();
        for (int y = 0; y < image.height(); ++y)
          for (int x = 0; x < image.width(); ++x)
            if (std::abs(qGray(image.pixel(x, y)) - qGray(ink)) < 60) return true;
        return false;
      },
      kPatience));
}

TEST(RenderThread, WhereOpenGlCannotLeaveTheUiThreadWorkIsDoneThereInOrder) {
  RenderThread here(false);
  std::vector<int> order;
  here.post([&] { order.push_back(1); });
  EXPECT_TRUE(order.empty());
  here.finish([&] { order.push_back(2); });
  EXPECT_EQ(order, (std::vector{1, 2}));
}

}  // namespace
}  // namespace vantage
