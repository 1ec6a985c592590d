#include "views/region_drawing.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

namespace vantage {
namespace {

class RegionDrawingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    view_.resize(400, 300);
    view_.show();
    drawing_.begin(DrawnShape::Rectangle);
  }
  void drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(&drawing_, Qt::LeftButton, {}, from);
    QTest::mouseMove(&drawing_, to);
    QTest::mouseRelease(&drawing_, Qt::LeftButton, {}, to);
  }

  QWidget view_;
  RegionDrawing drawing_{view_};
};

TEST_F(RegionDrawingTest, ADragClosesARectangle) {
  QSignalSpy closed(&drawing_, &RegionDrawing::closed);
  drag({100, 80}, {180, 140});
  EXPECT_EQ(closed.count(), 1);
  EXPECT_EQ(drawing_.drawn().boundingRect(), QRectF(100, 80, 80, 60));
}

TEST_F(RegionDrawingTest, AClickDrawsNothing) {
  QSignalSpy closed(&drawing_, &RegionDrawing::closed);
  drag({100, 80}, {102, 81});
  EXPECT_EQ(closed.count(), 0);
  EXPECT_TRUE(drawing_.drawn().isEmpty());
}

TEST_F(RegionDrawingTest, TheLineStaysOnWhatItIsAroundWhenTheViewGetsAnotherSize) {
  drag({100, 100}, {200, 200});
  view_.resize(500, 150);  // half as high: half as large, about the middle
  QCoreApplication::processEvents();
  EXPECT_EQ(drawing_.size(), view_.size());
  EXPECT_EQ(drawing_.drawn().boundingRect(), QRectF(200, 50, 50, 50));
}

TEST_F(RegionDrawingTest, KeysDrawToo) {
  drawing_.begin(DrawnShape::Lasso);
  for (const auto key : {Qt::Key_Right, Qt::Key_Down, Qt::Key_Left}) {
    QTest::keyClick(&drawing_, Qt::Key_Space);
    for (int i = 0; i < 4; ++i) QTest::keyClick(&drawing_, key);
  }
  QTest::keyClick(&drawing_, Qt::Key_Return);
  EXPECT_EQ(drawing_.drawn().boundingRect(), QRectF(200, 150, 40, 40));
}

}  // namespace
}  // namespace vantage
