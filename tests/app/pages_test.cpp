// Every page of the wizard in the whole window, drawn without a display: nothing is blank, clipped or missing, in both
// themes and at every size.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <cmath>

#include "app/desk.h"
#include "app/in_language.h"
#include "app/window_checks.h"
#include "geometry/measures.h"
#include "main_window.h"
#include "screenshots/painted_text.h"
#include "screenshots/screenshot.h"
#include "support/scenes/small_scene.h"
#include "why_card.h"
#include "wizard/import_dialog.h"
#include "wizard/next_view_box.h"

namespace vantage {
namespace {

using testing::Desk;

struct Look {
  const char* name;
  QSize size;
  bool dark;
  bool kept;  // compared with baselines
  const char* language = "en";
};

class Pages : public ::testing::TestWithParam<Look> {
 protected:
  void check(Desk& desk, const QString& page) {
    const QImage image = desk.picture(page + "_" + GetParam().name);
    EXPECT_TRUE(testing::isNotBlank(image)) << page.toStdString();
    EXPECT_EQ(testing::clipped(desk.window()).join(" | ").toStdString(), "") << page.toStdString();
    const auto texts = testing::paintedText(desk.window());
    EXPECT_GT(texts.size(), 20U) << page.toStdString();
    EXPECT_EQ(testing::cutOff(texts).join(" | ").toStdString(), "") << page.toStdString();
    EXPECT_EQ(testing::overlapping(texts).join(" | ").toStdString(), "") << page.toStdString();
    EXPECT_EQ(testing::nameless(desk.window()).join(" | ").toStdString(), "") << page.toStdString();
    EXPECT_EQ(testing::unexplained(desk.window()).join(" | ").toStdString(), "") << page.toStdString();
    EXPECT_EQ(desk.window().size(), GetParam().size) << "the window grew: " << page.toStdString();
    if (!GetParam().kept || image.devicePixelRatio() != 1.0) return;
    EXPECT_TRUE(testing::matchesBaseline(image, "window_" + page.toStdString() + "_" + GetParam().name));
  }
};
INSTANTIATE_TEST_SUITE_P(Window, Pages,
                         ::testing::Values(Look{"light", {1280, 800}, false, true},
                                           Look{"dark", {1280, 800}, true, true},
                                           Look{"wide", {1920, 1080}, false, false},
                                           Look{"german", {1280, 800}, false, false, "de"},
                                           Look{"chinese", {1280, 800}, true, false, "zh_CN"}),
                         [](const auto& p) { return p.param.name; });

TEST_P(Pages, NothingIsBlankClippedOrNameless) {
  const testing::InLanguage language(GetParam().language);
  Desk desk(GetParam().size, GetParam().dark);
  check(desk, "1_choose");
  desk.next();
  desk.controller().testTurn();
  check(desk, "2_check");
  desk.next();
  check(desk, "3_acquire");
  desk.controller().step();
  check(desk, "3_acquire_after_a_scan");
  desk.window().wizard().acquirePage().setAssisted(true);
  check(desk, "3_assisted");
  ASSERT_TRUE(desk.controller().now());
  desk.window().views().examine((desk.controller().present().nextPosition().value() + 20) % 90);
  check(desk, "3_why_not");
  desk.controller().step();
  ASSERT_EQ(countScans(*desk.controller().now(), ScanStatus::In), 2U);
  ASSERT_EQ(desk.window().wizard().page().key().toStdString(), "review");
  check(desk, "4_review");
  desk.window().wizard().goTo(QStringLiteral("turn_over"));
  check(desk, "4_turn_over");
  desk.window().wizard().goTo(QStringLiteral("review"));
  desk.controller().showMoment(1);
  check(desk, "4_earlier");
  desk.controller().showNow();
  desk.next();
  check(desk, "5_finish");
}

TEST_P(Pages, NothingIsBlankClippedOrNamelessAfterALongSession) {
  const testing::InLanguage language(GetParam().language);
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

// A session under way, at the page where scans are taken.
class Told : public ::testing::Test {
 protected:
  void acquire(int scans) {
    desk_.window().findChild<QSpinBox*>("max_views")->setValue(8);
    desk_.next();
    desk_.next();
    for (int i = 0; i < scans; ++i) desk_.controller().step();
    ASSERT_TRUE(desk_.controller().now());
  }
  void press(const QKeySequence& key) {
    for (auto* shortcut : desk_.window().findChildren<QShortcut*>())
      if (shortcut->key() == key) emit shortcut->activated();
  }
  // Looked at by people; what it says is compared.
  void lookAt(const QString& name) {
    EXPECT_TRUE(testing::isNotBlank(desk_.picture(QStringLiteral("told_") + name)));
    EXPECT_EQ(testing::clipped(desk_.window()).join(" | ").toStdString(), "") << name.toStdString();
    EXPECT_EQ(testing::unexplained(desk_.window()).join(" | ").toStdString(), "") << name.toStdString();
  }
  void expectSaid(const QString& text) {
    EXPECT_TRUE(testing::says(desk_.window(), text)) << "nowhere: " << text.toStdString();
  }
  void expectNotSaid(const QString& text) {
    EXPECT_FALSE(testing::says(desk_.window(), text)) << "somewhere: " << text.toStdString();
  }

  Desk desk_{{1280, 800}, false};
};

TEST_F(Told, AFailedScanIsToldAndEveryPaneGoesOnFromOnePosition) {
  acquire(2);
  desk_.controller().setMode(Mode::Assisted);
  desk_.controller().choosePosition(50);
  desk_.controller().step();
  const AcquisitionState& now = *desk_.controller().now();
  ASSERT_EQ(now.scans.back().status, ScanStatus::Rejected);
  const QString next = QString::number(desk_.controller().present().nextPosition().value());
  lookAt("failed_scan");
  expectSaid("from position 50 did not fit: ");
  expectSaid("Position " + next + ", proposed");
  expectSaid("Next best view: position " + next);
  expectSaid("This is the proposed position.");
  // The table stands at 200 degrees, whatever became of the scan.
  const double turn = 4.0 * std::abs(std::remainder(next.toInt() - 50, 90));
  expectSaid(QStringLiteral("Turn the table %1°").arg(QString::number(turn, 'f', 1)));
  EXPECT_EQ(desk_.window().findChild<QSpinBox*>("otherPosition")->value(), next.toInt());
}

TEST_F(Told, TheOperatorsChoiceIsSpokenOfEverywhere) {
  acquire(2);
  const QString proposed = QString::number(desk_.controller().present().nextPosition().value());
  desk_.controller().choosePosition(20);
  lookAt("taken");
  expectSaid("Position 20, your choice");
  expectSaid("Next view, your choice: position 20");
  expectSaid("Your choice: the next scan is taken from here.");
  expectNotSaid("Next best view");
  expectNotSaid("Position " + proposed + ", proposed");
  EXPECT_EQ(desk_.window().findChild<QSpinBox*>("otherPosition")->value(), 20);
}

TEST_F(Told, AnEndThatTheOperatorWantedIsNoEndOfWhatCouldBeSeen) {
  acquire(2);
  const QString proposed = QString::number(desk_.controller().present().nextPosition().value());
  desk_.controller().endHere();
  const QString ending = "Ended by you. Position " + proposed + " would still show ";
  lookAt("ended_here");
  expectSaid(ending);
  expectSaid("Ended; position " + proposed + " would be next");
  expectNotSaid("no position would show more");
  desk_.window().wizard().goTo(QStringLiteral("review"));
  lookAt("ended_here_review");
  expectSaid(ending);
  desk_.window().wizard().goTo(QStringLiteral("acquire"));
  desk_.controller().step();
  EXPECT_EQ(countScans(*desk_.controller().now(), ScanStatus::In), 3U);
}

TEST_F(Told, TheKeyThatRunsSaysWhyItDoesNotWhileTheOperatorTurnsTheTable) {
  acquire(1);
  desk_.controller().setMode(Mode::Assisted);
  press(QKeySequence(Qt::Key_F5));
  EXPECT_EQ(countScans(*desk_.controller().now(), ScanStatus::In), 1U);
  EXPECT_EQ(desk_.window().statusBar()->currentMessage(), desk_.controller().permissions().whyNotRun());
  press(QKeySequence(Qt::Key_F6));
  EXPECT_EQ(countScans(*desk_.controller().now(), ScanStatus::In), 2U);
}

TEST_F(Told, TheSurfaceIsThatOfTheModelAlsoWithoutAView) {
  acquire(3);
  desk_.controller().leaveOut(desk_.controller().now()->scans[1].number);
  const QString surface = areaText(area(desk_.controller().now()->model->mesh));
  for (const auto* page : {"acquire", "review"}) {
    desk_.window().wizard().goTo(QString::fromLatin1(page));
    lookAt(QStringLiteral("left_out_") + page);
    expectSaid(surface);
  }
}

TEST_F(Told, RecordedScansAreNothingElse) {
  QTemporaryDir folder(QDir::temp().filePath(QStringLiteral("recorded_XXXXXX")));
  const QString file = folder.filePath("imported.vantage");
  static_cast<void>(testing::importSmallScans(file.toStdString()));
  desk_.controller().open(file);
  lookAt("imported_review");
  expectSaid("Recorded scans, put together.");
  expectSaid("Nothing is planned from recorded scans");
  expectSaid(areaText(area(desk_.controller().now()->model->mesh)));
  for (const auto* page : {"choose", "check", "acquire", "review", "finish"}) {
    desk_.window().wizard().goTo(QString::fromLatin1(page));
    lookAt(QStringLiteral("imported_") + page);
    expectNotSaid("Mug");
    expectNotSaid("Rotating stripe");
    for (const testing::PaintedText& painted : testing::paintedText(desk_.window())) EXPECT_NE(painted.text, "-1");
    expectNotSaid("no position would show more");
  }
}

TEST_F(Told, WhatIsKnownOfRecordedScansIsAskedInOneDialog) {
  desk_.window().findChild<QAbstractButton*>("import")->click();
  auto* dialog = desk_.window().findChild<ImportDialog*>();
  ASSERT_NE(dialog, nullptr);
  dialog->addFiles({"/scans/of the mug/scan_000.ply", "/scans/of the mug/scan_045.ply"});
  dialog->findChild<QComboBox*>("importScanner")->setCurrentIndex(1);
  for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
  const QImage image = dialog->grab().toImage();
  image.save(QStringLiteral(VANTAGE_SCREENSHOT_DIR) + "/window_import.png");
  EXPECT_TRUE(testing::isNotBlank(image));
  EXPECT_EQ(testing::clipped(*dialog).join(" | ").toStdString(), "");
  EXPECT_EQ(testing::nameless(*dialog).join(" | ").toStdString(), "");
  EXPECT_EQ(testing::unexplained(*dialog).join(" | ").toStdString(), "");
  EXPECT_EQ(testing::collidingMnemonics(*dialog).join(" | ").toStdString(), "");
  dialog->reject();
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
