// How the stands lie in each other, in the real window with its OpenGL views. Needs a display: with_display.sh gives it
// one.
#include <gtest/gtest.h>

#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "app/operator.h"
#include "app/turned_session.h"
#include "stands/point_picker.h"
#include "stands/pose_chooser.h"
#include "stands/stand_dialog.h"
#include "support/meshes.h"
#include "views/composite_view.h"

namespace vantage {
namespace {

constexpr int kLongestCancel = 500;  // [ms]

using testing::waitFor;

// Balls about a ball: it lies in itself in four ways.
Mesh cross() {
  Mesh mesh = testing::makeSphere(28, 22, {0, 0, 40});
  for (const double side : {-1.0, 1.0}) {
    mesh = testing::joined(mesh, testing::makeSphere(18, 18, {side * 36, 0, 40}));
    mesh = testing::joined(mesh, testing::makeSphere(12, 16, {0, side * 32, 40}));
  }
  return mesh;
}

// The window before a session, and the dialog on it.
class Desk : public testing::Operator {
 public:
  Desk(const QString& folder, const Mesh& object) : Operator(folder, 8) {
    const QString path = folder + "/turned.vantage";
    QDir().mkpath(folder);
    testing::writeTurnedSession(path.toStdString(), object, testing::lyingOn(object, 2), 8);
    controller().open(path);
    EXPECT_TRUE(waitUntilIdle());
    window().compareStands();
    EXPECT_TRUE(waitFor([&] { return dialog()->inspector().stand().comparison != nullptr; }));
  }
  [[nodiscard]] StandDialog* dialog() { return window().findChild<StandDialog*>(); }
  [[nodiscard]] const Stand& stand() { return controller().now()->stands[1]; }
  [[nodiscard]] bool waitForLooks() {
    return waitFor([&] { return controller().idle() && !dialog()->inspector().busy(); });
  }
  void lookAt(const QString& name) {
    QTest::qWait(400);  // the views are drawn on a thread of their own
    const QString folder = qEnvironmentVariable("VANTAGE_SCREENSHOTS");
    if (folder.isEmpty()) return;
    QDir().mkpath(folder);
    dialog()->grab().save(folder + "/display_" + name + ".png");
  }
};

TEST(StandWindow, AligningIsStoppedAtOnceAndGoesOnWhenItIsAskedAgain) {
  const QTemporaryDir folder;
  Desk me(folder.filePath("window"), cross());
  const std::size_t steps = me.controller().present().moments().size();
  for (const int moment : {50, 300, 900}) {
    me.click("searchPoses");
    QTest::qWait(moment);
    if (me.stand().alignment) break;  // it was faster
    const testing::Stopwatch watch;
    QTest::keyClick(me.dialog(), Qt::Key_Escape);
    ASSERT_TRUE(me.waitUntilIdle());
    EXPECT_LE(watch.milliseconds(), kLongestCancel) << "stopped after " << moment << " ms";
    ASSERT_TRUE(me.dialog() && me.dialog()->isVisible());
    if (me.stand().alignment) break;  // it was faster than the key
    EXPECT_EQ(me.controller().present().moments().size(), steps);
  }
  if (!me.stand().alignment) me.click("searchPoses");
  ASSERT_TRUE(me.waitForLooks());
  ASSERT_TRUE(me.stand().alignment);
  EXPECT_EQ(me.stand().alignment->verdict, AlignmentVerdict::Ambiguous);
  me.lookAt("ambiguous");
  me.click("usePose");
  ASSERT_TRUE(me.waitForLooks());
  EXPECT_TRUE(me.stand().T_object_table);
  me.lookAt("in_place");
  QTest::keyClick(me.dialog(), Qt::Key_Escape);
  EXPECT_TRUE(waitFor([&] { return me.dialog() == nullptr; }));
  me.controller().undo();
  ASSERT_TRUE(me.waitUntilIdle());
  EXPECT_FALSE(me.stand().T_object_table);
}

TEST(StandWindow, ClosesWhileItIsStillBeingMadeReady) {
  const QTemporaryDir folder;
  Desk me(folder.filePath("window"), testing::smallObject());
  me.lookAt("not_aligned");
  me.click("pickPoints");
  me.lookAt("picking");
  QTest::keyClick(me.dialog(), Qt::Key_Escape);
  QTest::keyClick(me.dialog(), Qt::Key_Escape);
  ASSERT_TRUE(waitFor([&] { return me.dialog() == nullptr; }));
  me.window().compareStands(1);
  QTest::keyClick(me.dialog(), Qt::Key_Escape);
  EXPECT_TRUE(waitFor([&] { return me.dialog() == nullptr; }));
  EXPECT_TRUE(me.controller().idle());
}

}  // namespace
}  // namespace vantage
