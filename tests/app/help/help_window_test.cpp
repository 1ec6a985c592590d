#include "help/help_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>

#include "app/help/operator_manual.h"
#include "help/help_desk.h"
#include "help/help_topic.h"
#include "help/manual_browser.h"

namespace vantage {
namespace {

class Help : public ::testing::Test {
 protected:
  [[nodiscard]] QString page() const { return page_.source().fileName(); }
  [[nodiscard]] QStringList listed() const {
    QStringList texts;
    for (int i = 0; i < list_.count(); ++i) texts << list_.item(i)->text();
    return texts;
  }

  HelpWindow window_{testing::manualFolder()};
  ManualBrowser& page_ = *window_.findChild<ManualBrowser*>();
  QListWidget& list_ = *window_.findChild<QListWidget*>("helpList");
  QLineEdit& words_ = *window_.findChild<QLineEdit*>("helpWords");
};

TEST_F(Help, ShowsEveryPageOfTheManual) {
  EXPECT_EQ(static_cast<std::size_t>(list_.count()), window_.manual().pages().size());
  for (const ManualPage& page : window_.manual().pages()) {
    window_.showTopic(page.key);
    EXPECT_EQ(this->page(), page.key + ".md");
    EXPECT_EQ(page_.document()->firstBlock().text().toStdString(), page.sections.front().heading.toStdString());
    EXPECT_EQ(page_.document()->firstBlock().blockFormat().headingLevel(), 1);
  }
}

TEST_F(Help, OpensAtTheHeadingOfATopicAndAtTheContentsWithoutOne) {
  window_.showTopic("messages_devices#a-program");
  EXPECT_GT(page_.verticalScrollBar()->value(), 0);
  window_.showTopic("messages_devices#any-device");
  const int higher = page_.verticalScrollBar()->value();
  window_.showTopic("messages_devices#a-program");
  EXPECT_GT(page_.verticalScrollBar()->value(), higher);
  window_.showTopic("nothing of the kind");
  EXPECT_EQ(page(), "contents.md");
}

TEST_F(Help, GoesBackAndForward) {
  auto* back = window_.findChild<QPushButton*>("helpBack");
  auto* forward = window_.findChild<QPushButton*>("helpForward");
  EXPECT_FALSE(back->isEnabled());
  EXPECT_FALSE(back->toolTip().isEmpty());
  window_.showTopic("review");
  window_.showTopic("finish");
  back->click();
  EXPECT_EQ(page(), "review.md");
  forward->click();
  EXPECT_EQ(page(), "finish.md");
  QTest::keyClick(&page_, Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(page(), "review.md");
}

TEST_F(Help, FollowsLinksToTheTechnicalPages) {
  window_.showTopic("devices");
  page_.setSource(page_.source().resolved(QUrl("../turntables.md")));
  EXPECT_TRUE(page_.toPlainText().startsWith("Turntables on a serial line"));
}

TEST_F(Help, FindsWordsInAllPagesAndMarksThem) {
  window_.showTopic("contents");
  QTest::keyClicks(&words_, "safety door");
  ASSERT_GE(list_.count(), 1);
  list_.setCurrentRow(0);
  EXPECT_EQ(page(), "messages_devices.md");
  EXPECT_GE(page_.extraSelections().size(), 2);
  ASSERT_TRUE(page_.findNext());
  const QString first = page_.textCursor().selectedText().toLower();
  EXPECT_TRUE(first == "safety" || first == "door") << first.toStdString();
  const int place = page_.textCursor().position();
  ASSERT_TRUE(page_.findNext());
  EXPECT_NE(page_.textCursor().position(), place);
  ASSERT_TRUE(page_.findNext(true));
  EXPECT_EQ(page_.textCursor().position(), place);
  words_.clear();
  EXPECT_TRUE(page_.extraSelections().isEmpty());
  EXPECT_EQ(static_cast<std::size_t>(list_.count()), window_.manual().pages().size());
}

TEST_F(Help, SaysWhereNothingIsFound) {
  window_.search("xylophone");
  ASSERT_EQ(list_.count(), 1);
  EXPECT_FALSE(list_.item(0)->flags().testFlag(Qt::ItemIsEnabled));
  EXPECT_FALSE(page_.findNext());
}

TEST_F(Help, EscClosesIt) {
  window_.showTopic("keyboard");
  EXPECT_TRUE(window_.isVisible());
  QTest::keyClick(&page_, Qt::Key_Escape);
  EXPECT_FALSE(window_.isVisible());
}

TEST(HelpWithoutAManual, SaysThatItIsNotThere) {
  HelpWindow window(QStringLiteral("/nowhere"));
  EXPECT_TRUE(window.findChild<ManualBrowser*>()->toPlainText().contains("/nowhere"));
  window.showTopic("review");
}

TEST(HelpTopic, IsThatOfTheNearestWidgetAlsoAcrossWindows) {
  QWidget window;
  auto* part = new QWidget(&window);
  auto* button = new QPushButton(part);
  auto* dialog = new QDialog(&window);
  EXPECT_EQ(helpTopicOf(button), "contents");
  EXPECT_EQ(helpTopicOf(nullptr), "contents");
  setHelpTopic(window, "window");
  EXPECT_EQ(helpTopicOf(button), "window");
  EXPECT_EQ(helpTopicOf(dialog), "window");
  setHelpTopic(*part, "review");
  EXPECT_EQ(helpTopicOf(button), "review");
}

TEST(HelpDesk, F1OpensThePageAboutWhatHasTheKeyboardAlsoInADialog) {
  QWidget window;
  setHelpTopic(window, "acquire");
  HelpDesk desk(testing::manualFolder(), window);
  const auto* page = desk.window().findChild<ManualBrowser*>();
  window.show();
  QTest::keyClick(&window, Qt::Key_F1);
  EXPECT_TRUE(desk.window().isVisible());
  EXPECT_EQ(page->source().fileName(), "acquire.md");
  desk.window().close();
  QDialog dialog(&window);
  setHelpTopic(dialog, "settings");
  dialog.open();
  dialog.activateWindow();
  QTest::keyClick(&dialog, Qt::Key_F1);
  EXPECT_TRUE(desk.window().isVisible());
  EXPECT_EQ(page->source().fileName(), "settings.md");
  EXPECT_EQ(desk.window().windowModality(), Qt::NonModal);
  EXPECT_TRUE(dialog.isVisible());
}

TEST(HelpDesk, ItsMenuLeadsToPagesThatAreThere) {
  QWidget window;
  HelpDesk desk(testing::manualFolder(), window);
  QMenu menu;
  desk.addTo(menu);
  QStringList pages;
  for (QAction* action : menu.actions()) {
    action->trigger();
    pages << desk.window().findChild<ManualBrowser*>()->source().fileName();
  }
  EXPECT_EQ(pages.join(' ').toStdString(), "contents.md messages.md keyboard.md glossary.md");
}

}  // namespace
}  // namespace vantage
