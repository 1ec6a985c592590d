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
    const QImage image = window_->grab().toImage();
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
    EXPECT_EQ(clipped(desk.window()).join(" | "), QString()) << page.toStdString();
    EXPECT_EQ(nameless(desk.window()).join(" | "), QString()) << page.toStdString();
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
  desk.window().views().examine((desk.controller().next().position + 20) % 90);
  check(desk, "3_why_not");
  desk.controller().step();
  ASSERT_EQ(desk.controller().now()->views.size(), 2U);
  ASSERT_EQ(desk.window().wizard().page().key().toStdString(), "review");
  check(desk, "4_review");
  desk.controller().showMoment(1);
  check(desk, "4_earlier");
  desk.controller().showNow();
  desk.next();
  check(desk, "5_finish");
}

TEST(PageText, EveryPageSaysWhatHappensNext) {
  Desk desk({1280, 800}, false);
  for (int i = 0; i < desk.window().wizard().pageCount(); ++i) {
    desk.window().wizard().goTo(i);
    EXPECT_FALSE(desk.window().wizard().page().title().isEmpty());
    EXPECT_TRUE(desk.window().wizard().page().whatNext().endsWith('.'));
  }
}

}  // namespace
}  // namespace vantage
