// What the window says, and offers, when something is not as it should be.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>

#include "app/desk.h"
#include "app/window_checks.h"
#include "docks/session_log.h"
#include "support/scenes/small_scene.h"
#include "window/attention.h"
#include "window/notices.h"
#include "wizard/completeness_box.h"
#include "wizard/finish_page.h"

namespace vantage {
namespace {

using testing::Desk;

class Truth : public ::testing::Test {
 protected:
  void acquire(int scans, int mostViews = 8) {
    window().findChild<QSpinBox*>("max_views")->setValue(mostViews);
    desk_.next();
    desk_.next();
    for (int i = 0; i < scans; ++i) controller().step();
  }
  [[nodiscard]] QList<QMessageBox*> boxes() { return window().findChildren<QMessageBox*>(); }
  [[nodiscard]] QString logged() { return window().findChild<QPlainTextEdit*>()->toPlainText(); }
  void goTo(const char* page) {
    window().wizard().goTo(QString::fromLatin1(page));
    Desk::settle();
  }
  SessionController& controller() { return desk_.controller(); }
  MainWindow& window() { return desk_.window(); }

  Desk desk_{{1280, 800}, false};
};

TEST_F(Truth, ADamagedSessionIsToldInOneDialog) {
  QStringList losses;
  for (int i = 0; i < 25; ++i) losses << QStringLiteral("view %1 is damaged").arg(i);
  emit controller().damaged(losses);
  ASSERT_EQ(boxes().size(), 1);
  EXPECT_TRUE(boxes().front()->text().contains("25 things"));
  EXPECT_TRUE(boxes().front()->detailedText().contains("view 24 is damaged"));
  desk_.letFail();
  emit controller().failed("something else");
  EXPECT_EQ(boxes().size(), 1) << "what comes meanwhile is added";
  EXPECT_TRUE(boxes().front()->detailedText().contains("something else"));
  boxes().front()->accept();
}

TEST_F(Truth, WhatCannotBeReadIsSaidOnThePageWithTheWayOn) {
  QTemporaryDir folder;
  QFile broken(folder.filePath("broken.ply"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("ply\nthis is none");
  broken.close();
  auto* object = window().findChild<QComboBox*>("object");
  object->addItem("broken", broken.fileName());
  object->setCurrentIndex(object->count() - 1);
  desk_.letFail();
  desk_.next();
  ASSERT_EQ(window().wizard().page().key(), "check");
  static_cast<void>(desk_.picture("truth_unreadable"));
  EXPECT_TRUE(testing::says(window(), "could not be read: "));
  EXPECT_TRUE(testing::says(window(), "Go back and choose something else."));
  EXPECT_FALSE(testing::says(window(), "are being read"));
  EXPECT_FALSE(window().findChild<QPushButton*>("next")->isEnabled());
  EXPECT_TRUE(boxes().isEmpty()) << "the page says it";
  window().wizard().goBack();
  object->setCurrentIndex(0);
  desk_.next();
  EXPECT_TRUE(window().findChild<QPushButton*>("next")->isEnabled());
}

TEST_F(Truth, AFirstPositionThatTheScannerHasNotIsRefusedBeforeAnythingIsScanned) {
  desk_.next();
  SetUpChoice choice = controller().choice();
  choice.settings.firstView = 500;
  desk_.letFail();
  controller().setChoice(choice);
  controller().prepare();
  EXPECT_EQ(controller().setUp(), nullptr);
  EXPECT_TRUE(controller().setUpFailure().contains("500")) << controller().setUpFailure().toStdString();
  EXPECT_TRUE(controller().setUpFailure().contains("0 to 89"));
}

TEST_F(Truth, ASessionThatAnotherProgramWritesToIsOfferedToBeLookedAt) {
  QTemporaryDir folder;
  const QString file = folder.filePath("held.vantage");
  const Session held = testing::importSmallScans(file.toStdString());
  controller().open(file);
  Desk::settle();
  ASSERT_EQ(boxes().size(), 1);
  EXPECT_TRUE(boxes().front()->text().contains("is open for writing in "));
  auto* look = window().findChild<QPushButton*>("openToLook");
  ASSERT_NE(look, nullptr);
  look->click();
  Desk::settle();
  ASSERT_TRUE(controller().hasSession());
  EXPECT_TRUE(controller().readOnly());
  EXPECT_TRUE(window().windowTitle().contains("to be looked at only"));
  EXPECT_TRUE(controller().permissions().whyNotUndo().contains("looked at only"));
  EXPECT_TRUE(controller().permissions().whyNotScan().contains("looked at only"));
  EXPECT_EQ(controller().permissions().whyNotExport(), "");
  for (const char* page : {"choose", "review", "finish"}) goTo(page);
  EXPECT_EQ(held.note("page"), "") << "not a word was written";
  controller().leaveOut(controller().now()->scans.front().number);
  EXPECT_EQ(countScans(*controller().now(), ScanStatus::LeftOut), 0U);
}

TEST_F(Truth, TheReviewSaysHowCompleteTheModelIsAndWhatToDo) {
  acquire(2, 2);
  ASSERT_EQ(window().wizard().page().key(), "review");
  auto* box = window().findChild<CompletenessBox*>();
  ASSERT_TRUE(box->isVisible());
  ASSERT_TRUE(controller().present().completeness());
  const Completeness& complete = *controller().present().completeness();
  EXPECT_GT(complete.holes, 0U);
  EXPECT_TRUE(testing::says(window(), QString::number(complete.holes)));
  EXPECT_TRUE(window().findChild<QLabel*>("completenessAdvice")->text().contains("Scan on: position "));
}

TEST_F(Truth, AScanThatIsChosenInTheReviewIsLitUpAndStaysChosen) {
  acquire(3);
  goTo("review");
  auto* list = window().findChild<QTableWidget*>();
  list->selectRow(1);
  Desk::settle();
  const QImage image = desk_.picture("truth_chosen_scan");
  EXPECT_TRUE(testing::showsColour(image, lightTheme().examined, 0.002, 60));
  EXPECT_TRUE(testing::says(window(), "what the chosen scan brought"));
  const std::int64_t chosen = controller().now()->scans[1].number;
  controller().leaveOut(chosen);
  Desk::settle();
  ASSERT_FALSE(list->selectedItems().isEmpty());
  EXPECT_EQ(list->item(list->currentRow(), 0)->text(), QString::number(chosen));
}

TEST_F(Truth, BeforeTheFirstScanTheSetUpIsInThePicture) {
  desk_.next();
  static_cast<void>(desk_.picture("truth_before_the_first_scan"));
  EXPECT_TRUE(testing::says(window(), "Before the first scan"));
  EXPECT_TRUE(testing::says(window(), "The simulated object and the viewing volume"));
  EXPECT_TRUE(testing::says(window(), "The scanner at position 0"));
  desk_.next();
  controller().step();
  Desk::settle();
  EXPECT_FALSE(testing::says(window(), "Before the first scan"));
}

TEST_F(Truth, TheLogSaysThatSomethingWasUndone) {
  acquire(2);
  const QString last = controller().present().moments().back().text;
  controller().undo();
  EXPECT_TRUE(logged().endsWith("Undone: " + last)) << logged().toStdString();
  controller().redo();
  EXPECT_TRUE(logged().endsWith("Redone: " + last)) << logged().toStdString();
  EXPECT_TRUE(logged().contains("Session begun"));
  EXPECT_FALSE(logged().contains("Set-up changed"));
}

TEST_F(Truth, NothingIsWrittenOverWithoutAWord) {
  acquire(1);
  goTo("finish");
  auto* stl = window().findChild<QPushButton*>("exportStl");
  stl->click();
  const QString model = QDir(Desk::folder()).filePath("model.stl");
  ASSERT_TRUE(QFile::exists(model));
  EXPECT_TRUE(window().findChild<QMessageBox*>("overwrite") == nullptr);
  ASSERT_TRUE(QFile(model).resize(3));
  stl->click();
  Desk::settle();
  ASSERT_NE(window().findChild<QMessageBox*>("overwrite"), nullptr);
  EXPECT_EQ(QFileInfo(model).size(), 3) << "not before somebody says so";
  window().findChild<QPushButton*>("replaceFile")->click();
  Desk::settle();
  EXPECT_GT(QFileInfo(model).size(), 100);
}

TEST(Notices, SayWhatFailedAsASentence) {
  const FailureText named = readableFailure("/scans/a b/mug.vantage: is no session: there is no such file");
  EXPECT_EQ(named.sentence, "mug.vantage is no session: there is no such file.");
  EXPECT_EQ(named.place, "In the folder /scans/a b.");
  EXPECT_EQ(readableFailure("the device does not answer: 5 s").sentence, "The device does not answer: 5 s.");
  EXPECT_EQ(readableFailure("Done.").sentence, "Done.");
}

TEST(Export, TakesTheSuffixOfTheFilter) {
  EXPECT_EQ(withSuffix("/a/foo", "STL (*.stl)"), "/a/foo.stl");
  EXPECT_EQ(withSuffix("/a/foo", "PLY (*.ply)"), "/a/foo.ply");
  EXPECT_EQ(withSuffix("/a/foo.OBJ", "PLY (*.ply)"), "/a/foo.OBJ");
  EXPECT_EQ(withSuffix("/a/v1.2", "OBJ (*.obj)"), "/a/v1.2.obj");
}

TEST_F(Truth, SomebodyIsCalledOnceWhenScanningEnds) {
  int shown = 0;
  int heard = 0;
  Attention attention(controller(), {[&] { ++shown; }, [&] { ++heard; }});
  acquire(1);
  EXPECT_EQ(shown, 1);
  EXPECT_EQ(heard, 1);
  attention.setSound(false);
  controller().run();
  EXPECT_EQ(shown, 2);
  EXPECT_EQ(heard, 1);
  controller().undo();
  EXPECT_EQ(shown, 2) << "what somebody just did themselves is no news";
}

TEST_F(Truth, AReopenedSessionKnowsItsObject) {
  acquire(1);
  const QString path = controller().sessionPath();
  const double height = controller().setUp()->object->height;
  controller().close();
  controller().open(path);
  ASSERT_TRUE(controller().setUp()->object);
  EXPECT_NEAR(controller().setUp()->object->height, height, 1e-6);
}

}  // namespace
}  // namespace vantage
