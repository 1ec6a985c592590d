// Erasing in the real window with its OpenGL view, by mouse and by keys. Needs a display: with_display.sh gives it one.
#include <gtest/gtest.h>

#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include "app/operator.h"
#include "docks/model_pane.h"
#include "erase/erasing.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"
#include "views/region_drawing.h"

namespace vantage {
namespace {

using testing::waitFor;

// The middle of the ball that is erased, and how far it reaches.
const Vec3 kBall(30, 25, 30);
constexpr double kBallRadius = 14.0;

// The window with a session of the small object, of which the smallest ball is not the object.
class EraseOperator : public testing::Operator {
 public:
  explicit EraseOperator(const QString& folder) : Operator(folder, 8) {
    QDir().mkpath(folder);
    const QString path = folder + "/small.vantage";
    {
      AcquisitionSettings settings;
      settings.maxViews = 8;
      Session session = testing::createSmallSession(path.toStdString(), settings);
      Acquisition acquisition(session, testing::smallTools(session.profile(), settings));
      for (int i = 0; i < 4; ++i) acquisition.scanNext();
    }
    controller().open(path);
    EXPECT_TRUE(waitUntilIdle());
    view().finishLoading();
  }

  [[nodiscard]] ModelView& view() { return window().views().model().view(); }
  [[nodiscard]] EraseDesk& desk() { return window().erasing().desk(); }
  [[nodiscard]] QWidget& bar() { return window().erasing().bar(); }
  [[nodiscard]] RegionDrawing& drawing() { return *window().findChild<RegionDrawing*>("regionDrawing"); }
  [[nodiscard]] QString said() { return window().findChild<QLabel*>("erasePreview")->text(); }
  [[nodiscard]] bool waitForPreview() {
    return waitFor([&] { return !desk().asking() && desk().preview().has_value(); });
  }
  [[nodiscard]] std::size_t verticesOnBall() {
    const std::vector<Vec3>& vertices = controller().now()->model->mesh.vertices;
    return static_cast<std::size_t>(std::count_if(
        vertices.begin(), vertices.end(), [](const Vec3& v) { return (v - kBall).norm() < kBallRadius + 1.0; }));
  }

  // Where a point of the scene is in the view.
  [[nodiscard]] QPoint at(const Vec3& p) {
    const Camera& camera = view().camera();
    const Vec3 seen = p - camera.eye;
    const double depth = seen.dot(camera.forward());
    const Vec3 up = camera.right().cross(camera.forward());
    const double scale = 0.5 * view().height() / (depth * std::tan(0.5 * camera.viewAngle));
    return {static_cast<int>(0.5 * view().width() + scale * seen.dot(camera.right())),
            static_cast<int>(0.5 * view().height() - scale * seen.dot(up))};
  }
  // A ring about the ball, as the view shows it now.
  [[nodiscard]] std::vector<QPoint> ring() {
    const Camera& camera = view().camera();
    const Vec3 up = camera.right().cross(camera.forward());
    std::vector<QPoint> points;
    for (int i = 0; i <= 24; ++i) {
      const double angle = radians(15.0 * i);
      points.push_back(at(kBall + 1.25 * kBallRadius * (std::cos(angle) * camera.right() + std::sin(angle) * up)));
    }
    return points;
  }
  void drawByMouse(const std::vector<QPoint>& points) {
    QTest::mousePress(&drawing(), Qt::LeftButton, {}, points.front());
    for (const QPoint& point : points) QTest::mouseMove(&drawing(), point);
    QTest::mouseRelease(&drawing(), Qt::LeftButton, {}, points.back());
  }

  void lookAt(const QString& name) {
    QTest::qWait(400);  // the view is drawn on a thread of its own
    const QString folder = qEnvironmentVariable("VANTAGE_SCREENSHOTS");
    if (folder.isEmpty()) return;
    QDir().mkpath(folder);
    window().grab().save(folder + "/erase_" + name + ".png");
  }
};

TEST(EraseWindow, ALassoByMouseErasesWhatIsMarkedAndUndoTakesItBack) {
  const QTemporaryDir folder;
  EraseOperator me(folder.filePath("window"));
  const std::uint64_t before = stateHash(*me.controller().now());
  const std::size_t there = me.verticesOnBall();
  ASSERT_GT(there, 50U);
  me.click("erase");
  ASSERT_TRUE(me.bar().isVisible());
  me.lookAt("begun");
  me.click("eraseFront");  // all the way through
  me.drawByMouse(me.ring());
  ASSERT_TRUE(me.waitForPreview());
  EXPECT_GT(me.desk().preview()->area, 300.0);
  EXPECT_TRUE(me.said().contains(QStringLiteral("mm²"))) << me.said().toStdString();
  me.lookAt("previewed");
  EXPECT_EQ(stateHash(*me.controller().now()), before) << "nothing is erased before it is confirmed";
  me.click("eraseNow");
  ASSERT_TRUE(waitFor([&] { return me.controller().idle() && me.verticesOnBall() < there / 4; }));
  ASSERT_EQ(me.controller().now()->stands[0].erased.size(), 1U);
  me.lookAt("erased");
  me.controller().undo();
  ASSERT_TRUE(waitFor([&] { return me.controller().idle() && me.verticesOnBall() == there; }));
  EXPECT_EQ(stateHash(*me.controller().now()), before);
  EXPECT_TRUE(me.bar().isVisible());
  QTest::keyClick(&me.drawing(), Qt::Key_Escape);
  EXPECT_FALSE(me.bar().isVisible());
  EXPECT_FALSE(me.drawing().isVisible());
  EXPECT_FALSE(me.desk().preview());
}

TEST(EraseWindow, KeysInTheRowErase) {
  const QTemporaryDir folder;
  EraseOperator me(folder.filePath("window"));
  me.click("erase");
  ASSERT_TRUE(me.bar().isVisible());
  me.click("eraseBelow");
  auto* height = me.window().findChild<QDoubleSpinBox*>("eraseHeight");
  ASSERT_TRUE(height->isVisible());
  height->setFocus();
  height->selectAll();
  QTest::keyClicks(height, "25");
  QTest::keyClick(height, Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return me.desk().preview() && me.desk().preview()->samples > 0; }));
  me.lookAt("below");
  auto* erase = me.window().findChild<QAbstractButton*>("eraseNow");
  ASSERT_TRUE(erase->isEnabled());
  erase->setFocus();
  QTest::keyClick(erase, Qt::Key_Space);
  const auto lowest = [&] {
    double z = 1e9;
    for (const Vec3& v : me.controller().now()->model->mesh.vertices) z = std::min(z, v.z());
    return z;
  };
  ASSERT_TRUE(waitFor([&] { return me.controller().idle() && lowest() > 25.0; }));
  // A square with the keys.
  me.click("eraseBox");
  QTest::keyClick(&me.drawing(), Qt::Key_Space);
  for (int i = 0; i < 6; ++i) {
    QTest::keyClick(&me.drawing(), Qt::Key_Right);
    QTest::keyClick(&me.drawing(), Qt::Key_Down);
  }
  me.lookAt("keys");
  QTest::keyClick(&me.drawing(), Qt::Key_Return);
  ASSERT_TRUE(me.waitForPreview());
  EXPECT_GT(me.desk().preview()->samples, 0U) << "the middle of the view shows the object";
  me.click("eraseLoosePieces");
  ASSERT_TRUE(me.waitForPreview());
  me.click("eraseEnd");
  EXPECT_FALSE(me.bar().isVisible());
}

TEST(EraseWindow, OtherButtonsTurnTheViewMeanwhile) {
  const QTemporaryDir folder;
  EraseOperator me(folder.filePath("window"));
  me.click("erase");
  const Vec3 eye = me.view().camera().eye;
  QTest::mousePress(&me.drawing(), Qt::RightButton, {}, QPoint(100, 100));
  QTest::mouseMove(&me.drawing(), QPoint(160, 130));
  QTest::mouseRelease(&me.drawing(), Qt::RightButton, {}, QPoint(160, 130));
  EXPECT_NE(me.view().camera().eye, eye);
  EXPECT_FALSE(me.desk().preview());
}

}  // namespace
}  // namespace vantage
