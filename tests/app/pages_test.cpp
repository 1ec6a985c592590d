// Every page of the wizard in the whole window, drawn without a display: nothing is blank, clipped or missing, in both
// themes and at every size.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include "main_window.h"
#include "screenshots/painted_text.h"
#include "screenshots/screenshot.h"
#include "wizard/next_view_box.h"

namespace vantage {
namespace {

// A window that works at once, before the mug and a folder of its own.
class Desk {
 public:
  Desk(const QSize& size, bool dark) {
    QDir(folder()).removeRecursively();
    Preferences preferences;
    preferences.theme = dark ? 1 : 0;
    window_ = std::make_unique<MainWindow>(
        WindowParts{controller_, jobs_, testing::testSurfaces(), QStringLiteral(VANTAGE_RESOURCES)}, preferences);
    window_->resize(size);
    window_->show();
    window_->findChild<QSpinBox*>("max_views")->setValue(2);
    window_->findChild<QLineEdit*>("folder")->setText(folder());
    QObject::connect(&controller_, &SessionController::failed,
                     [](const QString& what) { ADD_FAILURE() << what.toStdString(); });
    settle();
  }
  ~Desk() { QDir(folder()).removeRecursively(); }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  void next() {
    window_->wizard().goOn();
    settle();
  }
  // The picture of the window as it is, kept beside the other screenshots.
  QImage picture(const QString& name) {
    window_->views().model().view().finishLoading();
    settle();
    QImage image = window_->grab().toImage();
    QDir().mkpath(QStringLiteral(VANTAGE_SCREENSHOT_DIR));
    const QString scale = image.devicePixelRatio() > 1.0 ? QStringLiteral("_x2") : QString();
    image.save(QStringLiteral(VANTAGE_SCREENSHOT_DIR) + "/window_" + name + scale + ".png");
    return image;
  }
  SessionController& controller() { return controller_; }
  MainWindow& window() { return *window_; }

 private:
  // The same in every run: it is written on the pages. Tests at another scale may run beside these.
  static QString folder() {
    return QDir::temp().filePath(QStringLiteral("vantage-pages-%1").arg(qApp->devicePixelRatio()));
  }
  static void settle() {
    for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
  }

  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, QDir::temp().filePath("vantage-pages-cache").toStdString()};
  std::unique_ptr<MainWindow> window_;
};

// Texts that are not given the room that they ask for.
QStringList clipped(const QWidget& window) {
  QStringList names;
  for (const auto* label : window.findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty()) continue;
    const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
    if (label->height() < needed || (!label->wordWrap() && label->width() < label->sizeHint().width()))
      names << label->text();
  }
  for (const auto* button : window.findChildren<QAbstractButton*>()) {
    const bool named = button->isVisible() && !button->text().isEmpty();
    if (named && button->width() < QFontMetrics(button->font()).size(Qt::TextShowMnemonic, button->text()).width())
      names << button->text();
  }
  return names;
}

// Widgets that take the keyboard but tell assistive technology nothing.
QStringList nameless(const QWidget& window) {
  QStringList names;
  for (const auto* button : window.findChildren<QAbstractButton*>())
    if (button->isVisible() && button->focusPolicy() != Qt::NoFocus && button->accessibleName().isEmpty() &&
        button->text().isEmpty())
      names << button->objectName() + QLatin1Char(' ') + button->metaObject()->className();
  return names;
}

struct Look {
  const char* name;
  QSize size;
  bool dark;
  bool kept;  // compared with baselines
};

class Pages : public ::testing::TestWithParam<Look> {
 protected:
  void check(Desk& desk, const QString& page) {
    const QImage image = desk.picture(page + "_" + GetParam().name);
    EXPECT_TRUE(testing::isNotBlank(image)) << page.toStdString();
    EXPECT_EQ(clipped(desk.window()).join(" | ").toStdString(), "") << page.toStdString();
    const auto texts = testing::paintedText(desk.window());
    EXPECT_GT(texts.size(), 20U) << page.toStdString();
    EXPECT_EQ(testing::cutOff(texts).join(" | ").toStdString(), "") << page.toStdString();
    EXPECT_EQ(testing::overlapping(texts).join(" | ").toStdString(), "") << page.toStdString();
    EXPECT_EQ(nameless(desk.window()).join(" | ").toStdString(), "") << page.toStdString();
    EXPECT_EQ(desk.window().size(), GetParam().size) << "the window grew: " << page.toStdString();
    if (!GetParam().kept || image.devicePixelRatio() != 1.0) return;
    EXPECT_TRUE(testing::matchesBaseline(image, "window_" + page.toStdString() + "_" + GetParam().name));
  }
};
INSTANTIATE_TEST_SUITE_P(Window, Pages,
                         ::testing::Values(Look{"light", {1280, 800}, false, true},
                                           Look{"dark", {1280, 800}, true, true},
                                           Look{"wide", {1920, 1080}, false, false}),
                         [](const auto& p) { return p.param.name; });

TEST_P(Pages, NothingIsBlankClippedOrNameless) {
  Desk desk(GetParam().size, GetParam().dark);
  check(desk, "1_choose");
  desk.next();
  desk.controller().startTestTurn();
  check(desk, "2_check");
  desk.next();
  check(desk, "3_acquire");
  desk.controller().step();
  check(desk, "3_acquire_after_a_scan");
  desk.window().wizard().acquirePage().setAssisted(true);
  check(desk, "3_assisted");
  ASSERT_TRUE(desk.controller().now());
  desk.window().views().examine((desk.controller().nextPosition().value() + 20) % 90);
  check(desk, "3_why_not");
  desk.controller().step();
  ASSERT_EQ(countScans(*desk.controller().now(), ScanStatus::In), 2U);
  ASSERT_EQ(desk.window().wizard().page().key().toStdString(), "review");
  check(desk, "4_review");
  desk.controller().showMoment(1);
  check(desk, "4_earlier");
  desk.controller().showNow();
  desk.next();
  check(desk, "5_finish");
}

TEST_P(Pages, NothingIsBlankClippedOrNamelessAfterALongSession) {
  Desk desk(GetParam().size, GetParam().dark);
  desk.window().findChild<QSpinBox*>("max_views")->setValue(40);
  desk.next();
  desk.next();
  desk.controller().run();
  ASSERT_TRUE(desk.controller().now());
  ASSERT_GT(countScans(*desk.controller().now(), ScanStatus::In), 4U);
  check(desk, "4_review_finished");
  desk.window().views().examine(20);
  check(desk, "4_why_at_the_end");
  desk.next();
  check(desk, "5_finish_finished");
}

TEST(PageText, EveryPageSaysWhatHappensNext) {
  Desk desk({1280, 800}, false);
  for (int i = 0; i < desk.window().wizard().pageCount(); ++i) {
    desk.window().wizard().goTo(i);
    EXPECT_FALSE(desk.window().wizard().page().title().isEmpty());
    EXPECT_TRUE(desk.window().wizard().page().whatNext().endsWith('.'));
  }
}

TEST(PaintedText, TellsWhatIsCutOffAndWhatIsWrittenOverEachOther) {
  QWidget window;
  window.resize(300, 100);
  QLabel whole(QStringLiteral("whole"), &window);
  whole.setGeometry(10, 10, 100, 30);
  QLabel narrow(QStringLiteral("more than there is room for"), &window);
  narrow.setGeometry(10, 60, 20, 30);
  QLabel above(QStringLiteral("above"), &window);
  above.setGeometry(15, 10, 100, 30);
  window.show();
  const auto texts = testing::paintedText(window);
  EXPECT_EQ(texts.size(), 3U);
  EXPECT_EQ(testing::cutOff(texts).join(" | ").toStdString(), "more than there is room for");
  EXPECT_EQ(testing::overlapping(texts).join(" | ").toStdString(), "whole / above");
}

}  // namespace
}  // namespace vantage
