#include "window/tool_bar.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QSignalSpy>
#include <QToolButton>
#include <memory>

#include "base/errors.h"
#include "window/stroke_icon.h"

namespace vantage {
namespace {

// How much of a picture is covered, 0 to 1, and whether all of that has about one colour.
struct Ink {
  double share = 0.0;
  bool ofOneColour = true;
};

Ink inkOf(const QPixmap& pixmap, const QColor& colour) {
  const QImage image = pixmap.toImage().convertToFormat(QImage::Format_ARGB32);
  Ink ink;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      ink.share += pixel.alphaF();
      if (pixel.alpha() > 128)
        ink.ofOneColour = ink.ofOneColour && std::abs(pixel.red() - colour.red()) < 4 &&
                          std::abs(pixel.green() - colour.green()) < 4 && std::abs(pixel.blue() - colour.blue()) < 4;
    }
  ink.share /= image.width() * image.height();
  return ink;
}

TEST(StrokeIcons, AreDrawnInTheColourThatIsAskedForAndLeaveRoomAround) {
  ASSERT_GE(strokeIconNames().size(), 10);
  for (const QString& name : strokeIconNames())
    for (const QColor& colour : {QColor(0x1b, 0x1f, 0x24), QColor(0xe8, 0x20, 0x30)}) {
      const QPixmap pixmap = strokePixmap(name, colour, 48);
      const Ink ink = inkOf(pixmap, colour);
      EXPECT_GT(ink.share, 0.03) << name.toStdString();
      EXPECT_LT(ink.share, 0.5) << name.toStdString();
      EXPECT_TRUE(ink.ofOneColour) << name.toStdString();
      const QImage image = pixmap.toImage();
      for (int i = 0; i < 48; ++i)
        for (const QPoint& edge : {QPoint(i, 0), QPoint(i, 47), QPoint(0, i), QPoint(47, i)})
          EXPECT_LT(image.pixelColor(edge).alpha(), 64) << name.toStdString();
    }
}

TEST(StrokeIcons, AreAllDifferent) {
  const QStringList names = strokeIconNames();
  for (int i = 0; i < names.size(); ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_NE(strokePixmap(names[i], Qt::black, 24).toImage(), strokePixmap(names[j], Qt::black, 24).toImage())
          << names[i].toStdString() << " " << names[j].toStdString();
}

TEST(StrokeIcons, OfActionsThatCannotBeHadAreInTheOtherColour) {
  const QIcon icon = strokeIcon("run", Qt::green, Qt::gray);
  EXPECT_TRUE(inkOf(icon.pixmap(QSize(24, 24), 1.0, QIcon::Normal), Qt::green).ofOneColour);
  EXPECT_TRUE(inkOf(icon.pixmap(QSize(24, 24), 1.0, QIcon::Disabled), Qt::gray).ofOneColour);
  EXPECT_EQ(icon.pixmap(QSize(24, 24), 2.0, QIcon::Normal).size(), QSize(48, 48)) << "sharp at every scale";
}

TEST(StrokeIcons, ThatNobodyDrewAreRefused) {
  EXPECT_THROW(strokeIcon("no_such_icon", Qt::black, Qt::gray), InvalidInput);
}

class ToolBarTest : public ::testing::Test {
 protected:
  ToolBarTest() {
    run_.setText("&Run or go on…\tF5");
    wire_.setText("&Wireframe");
    wire_.setShortcut(QKeySequence("Ctrl+9"));
    wire_.setCheckable(true);
    bar_.addTools({{&run_, "run", ToolTint::Go}, {&wire_, "wireframe"}});
  }

  QAction run_;
  QAction wire_;
  ToolBar bar_;
};

TEST_F(ToolBarTest, AButtonIsCalledAsItsActionWithTheKey) {
  EXPECT_EQ(toolName(run_), "Run or go on (F5)");
  EXPECT_EQ(bar_.button(run_)->toolTip(), "Run or go on (F5)");
  EXPECT_EQ(bar_.button(run_)->accessibleName(), "Run or go on");
  EXPECT_EQ(bar_.button(wire_)->toolTip(), "Wireframe (Ctrl+9)");
  EXPECT_EQ(bar_.button(QAction()), nullptr);
}

TEST_F(ToolBarTest, ItSaysWhyAnActionCannotBeHad) {
  run_.setEnabled(false);
  run_.setStatusTip("Scanner and object are not read yet.");
  EXPECT_FALSE(bar_.button(run_)->isEnabled());
  EXPECT_EQ(bar_.button(run_)->toolTip(), "Run or go on (F5)\nScanner and object are not read yet.");
  run_.setStatusTip({});
  run_.setEnabled(true);
  EXPECT_TRUE(bar_.button(run_)->isEnabled());
  EXPECT_EQ(bar_.button(run_)->toolTip(), "Run or go on (F5)");
}

TEST_F(ToolBarTest, AClickDoesWhatTheActionDoesAndShowsWhetherItIsOn) {
  const QSignalSpy ran(&run_, &QAction::triggered);
  bar_.button(run_)->click();
  EXPECT_EQ(ran.size(), 1);
  bar_.button(wire_)->click();
  EXPECT_TRUE(wire_.isChecked());
  EXPECT_TRUE(bar_.button(wire_)->isChecked());
  wire_.setChecked(false);
  EXPECT_FALSE(bar_.button(wire_)->isChecked());
}

TEST_F(ToolBarTest, TheTabKeyComesByEveryButtonAndTheBarCannotBeHidden) {
  for (const QAction* action : {&run_, &wire_}) EXPECT_EQ(bar_.button(*action)->focusPolicy(), Qt::TabFocus);
  EXPECT_FALSE(bar_.toggleViewAction()->isEnabled());
  EXPECT_FALSE(bar_.isMovable());
  EXPECT_FALSE(bar_.isFloatable());
}

TEST_F(ToolBarTest, IconsAreToldFromTheBarInBothThemes) {
  for (const Theme* theme : {&lightTheme(), &darkTheme()}) {
    bar_.setTheme(*theme);
    EXPECT_TRUE(inkOf(run_.icon().pixmap(24), theme->good).ofOneColour);
    EXPECT_TRUE(inkOf(wire_.icon().pixmap(24), theme->text).ofOneColour);
    EXPECT_EQ(bar_.button(run_)->icon().pixmap(24).toImage(), run_.icon().pixmap(24).toImage());
  }
}

}  // namespace
}  // namespace vantage
