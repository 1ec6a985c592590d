// Every part of the window can be reached: on small screens and in large print, by the keyboard alone, by letters that
// do not collide.
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/desk.h"
#include "app/window_checks.h"
#include "screenshots/painted_text.h"
#include "window/fitting.h"
#include "window/flow_layout.h"
#include "window/page_scroll.h"
#include "window_theme.h"

namespace vantage {
namespace {

using testing::Desk;

const QStringList kPages{"choose", "check", "acquire", "turn_over", "review", "finish"};

// The font of the program while it lives.
class InFont {
 public:
  explicit InFont(double points) : before_(QApplication::font()) {
    QFont font = before_;
    font.setPointSizeF(points);
    QApplication::setFont(font);
  }
  ~InFont() { QApplication::setFont(before_); }
  InFont(const InFont&) = delete;
  InFont& operator=(const InFont&) = delete;

 private:
  QFont before_;
};

TEST(Fitting, AWindowKeepsInsideOfItsRoom) {
  const QRect room(100, 50, 1024, 768);
  EXPECT_EQ(fittedInto({200, 100, 800, 600}, room), QRect(200, 100, 800, 600));
  EXPECT_EQ(fittedInto({0, 0, 1280, 800}, room), room);
  EXPECT_EQ(fittedInto({900, 700, 800, 600}, room), QRect(324, 218, 800, 600));
  EXPECT_EQ(fittedInto({-500, -500, 2560, 100}, room), QRect(100, 50, 1024, 100));
}

TEST(FlowLayout, TakesFurtherLinesWhereOneHasNoRoom) {
  QWidget bar;
  auto* flow = new FlowLayout(4, &bar);
  flow->setContentsMargins(0, 0, 0, 0);
  std::vector<QWidget*> boxes;
  for (int i = 0; i < 4; ++i) {
    auto* box = new QLabel;
    box->setFixedSize(50, 20);
    flow->addWidget(box);
    boxes.push_back(box);
  }
  EXPECT_EQ(flow->heightForWidth(212), 20);
  EXPECT_EQ(flow->heightForWidth(211), 44);
  EXPECT_EQ(flow->minimumSize(), QSize(50, 20));
  flow->setGeometry({0, 0, 110, 44});
  EXPECT_EQ(boxes[1]->pos(), QPoint(54, 0));
  EXPECT_EQ(boxes[2]->pos(), QPoint(0, 24));
}

TEST(PageScroll, DoesNotMoveWhenAButtonIsDisabledAndGivesItTheKeyboardBack) {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  auto* first = new QPushButton("first");
  column->addWidget(first);
  auto* space = new QWidget;
  space->setFixedHeight(2000);
  column->addWidget(space);
  column->addWidget(new QPushButton("last"));
  PageScroll scroll(page);
  scroll.resize(200, 300);
  scroll.show();
  scroll.activateWindow();
  Desk::settle();
  first->setFocus();
  first->setEnabled(false);
  Desk::settle();
  EXPECT_EQ(scroll.verticalScrollBar()->value(), 0);
  first->setEnabled(true);
  EXPECT_EQ(scroll.focusWidget(), first);
}

struct Screen {
  QSize size;
  double points;
};

class Reach : public ::testing::TestWithParam<Screen> {};
INSTANTIATE_TEST_SUITE_P(Screens, Reach,
                         ::testing::Values(Screen{{1024, 740}, 9.0}, Screen{{1000, 700}, 9.0},
                                           Screen{{1024, 740}, 12.0}, Screen{{1024, 740}, 16.0},
                                           Screen{{1920, 1050}, 16.0}, Screen{{3840, 2100}, 9.0}),
                         [](const auto& p) {
                           return QStringLiteral("w%1h%2pt%3")
                               .arg(p.param.size.width())
                               .arg(p.param.size.height())
                               .arg(p.param.points)
                               .toStdString();
                         });

TEST_P(Reach, EveryPageFits) {
  const InFont font(GetParam().points);
  Desk desk(GetParam().size, false);
  desk.controller().setMode(Mode::Automatic);
  desk.next();
  desk.next();
  desk.controller().step();
  for (const QString& page : kPages) {
    desk.window().wizard().goTo(page);
    const QImage image = desk.picture(QStringLiteral("reach_%1x%2_%3pt_%4")
                                          .arg(GetParam().size.width())
                                          .arg(GetParam().size.height())
                                          .arg(GetParam().points)
                                          .arg(page));
    EXPECT_EQ(desk.window().size(), GetParam().size) << page.toStdString();
    EXPECT_LE(desk.window().minimumSizeHint().height(), GetParam().size.height()) << page.toStdString();
    for (const char* name : {"back", "next"}) {
      const auto* button = desk.window().findChild<QPushButton*>(name);
      const QRect place(button->mapTo(&desk.window(), QPoint()), button->size());
      EXPECT_TRUE(desk.window().rect().contains(place)) << page.toStdString() << ", " << name;
    }
    EXPECT_GE(desk.window().views().model().width(), 240) << page.toStdString();
  }
}

TEST(ReachTheSides, DocksGoWhereThereIsNoRoomAndComeBack) {
  const InFont font(16.0);
  Desk desk({1920, 1050}, false);
  auto* objective = desk.window().findChild<QDockWidget*>("objectiveDock");
  EXPECT_FALSE(objective->isHidden());
  const int least = desk.window().minimumWidth();
  desk.window().resize(least, 740);
  Desk::settle();
  EXPECT_TRUE(objective->isHidden());
  EXPECT_EQ(desk.window().width(), least);
  desk.window().resize(1920, 1050);
  Desk::settle();
  EXPECT_FALSE(objective->isHidden());
}

TEST(ReachByLetters, NoTwoThingsHaveTheSameOne) {
  Desk desk({1280, 800}, false);
  const auto check = [&](const QString& when) {
    Desk::settle();
    EXPECT_EQ(testing::collidingMnemonics(desk.window()).join(" | ").toStdString(), "") << when.toStdString();
    EXPECT_EQ(testing::beyondTheKeyboard(desk.window()).join(" | ").toStdString(), "") << when.toStdString();
  };
  for (const QString& page : kPages) {
    desk.window().wizard().goTo(page);
    check("before the first scan: " + page);
  }
  desk.window().wizard().goTo(QStringLiteral("acquire"));
  desk.controller().step();
  for (const Mode mode : {Mode::Automatic, Mode::Assisted}) {
    desk.controller().setMode(mode);
    for (const QString& page : kPages) {
      desk.window().wizard().goTo(page);
      check((mode == Mode::Automatic ? "automatic: " : "assisted: ") + page);
    }
  }
  desk.controller().setMode(Mode::Automatic);
  desk.controller().choosePosition(45);
  desk.controller().step();
  desk.window().wizard().goTo(QStringLiteral("acquire"));
  check("at the greatest number of views");
}

TEST(ReachByKeys, TheTabKeyComesByThePageFirst) {
  Desk desk({1280, 800}, false);
  desk.window().wizard().takeKeyboard();
  const QWidget* page = desk.window().focusWidget();
  ASSERT_NE(page, nullptr);
  EXPECT_TRUE(desk.window().wizard().isAncestorOf(page));
  // In the chain of the whole window nothing in sight takes the keyboard before the page does.
  for (const QWidget* widget = desk.window().nextInFocusChain(); widget != &desk.window();
       widget = widget->nextInFocusChain()) {
    const bool takes = (widget->focusPolicy() & Qt::TabFocus) == Qt::TabFocus && widget->isVisible() &&
                       widget->isEnabled() && widget->focusProxy() == nullptr;
    if (!takes) continue;
    EXPECT_TRUE(desk.window().wizard().isAncestorOf(widget))
        << widget->metaObject()->className() << " " << widget->objectName().toStdString();
    break;
  }
}

TEST(ReachByKeys, TurningThePagesEndsNoSession) {
  Desk desk({1280, 800}, false);
  desk.next();
  desk.next();
  desk.controller().step();
  for (int i = 0; i < 8; ++i) desk.window().wizard().turnPage();
  EXPECT_EQ(desk.window().wizard().page().key(), "finish");
  EXPECT_TRUE(desk.controller().hasSession());
}

// Colours of the window by themselves; what is painted with them is measured in pictures.
TEST(Contrast, TextAndMarksAreToldFromWhatIsBehindThem) {
  for (const Theme* theme : {&lightTheme(), &darkTheme()}) {
    const QPalette palette = paletteFor(*theme);
    const auto against = [&](QPalette::ColorGroup group, QPalette::ColorRole a, QPalette::ColorRole b) {
      return contrast(palette.color(group, a), palette.color(group, b));
    };
    EXPECT_GE(against(QPalette::Active, QPalette::WindowText, QPalette::Window), 4.5);
    EXPECT_GE(against(QPalette::Active, QPalette::ButtonText, QPalette::Button), 4.5);
    EXPECT_GE(against(QPalette::Active, QPalette::HighlightedText, QPalette::Highlight), 4.5);
    EXPECT_GE(against(QPalette::Disabled, QPalette::ButtonText, QPalette::Button), 3.0);
    EXPECT_GE(against(QPalette::Disabled, QPalette::WindowText, QPalette::Window), 3.0);
    // On and off of a layer.
    EXPECT_GE(against(QPalette::Active, QPalette::Highlight, QPalette::Window), 2.0);
    for (const QColor& colour : {theme->mutedText, theme->threshold, theme->good})
      EXPECT_GE(contrast(colour, palette.color(QPalette::Window)), 4.5) << colour.name().toStdString();
  }
}

// What is on is told from what is off in the picture itself.
TEST(Contrast, LayersThatAreOnAreToldFromThoseThatAreOff) {
  for (const bool dark : {false, true}) {
    Desk desk({1280, 800}, dark);
    const QImage image = desk.picture(dark ? "layers_dark" : "layers_light");
    QColor on;
    QColor off;
    for (const auto* button : desk.window().findChildren<QToolButton*>()) {
      if (!button->property("layer").toBool()) continue;
      const QPoint corner = button->mapTo(&desk.window(), QPoint(5, button->height() / 2));
      (button->isChecked() ? on : off) = image.pixelColor(corner * image.devicePixelRatio());
    }
    EXPECT_GE(contrast(on, off), 3.0) << on.name().toStdString() << " " << off.name().toStdString();
  }
}

}  // namespace
}  // namespace vantage
