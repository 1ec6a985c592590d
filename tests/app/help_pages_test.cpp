// F1 in the whole window: every page, dock and dialog opens the part of the manual that is about it.
#include <gtest/gtest.h>

#include <QDialog>
#include <QDockWidget>
#include <QKeyEvent>
#include <QListWidget>
#include <QMenuBar>
#include <QScrollBar>
#include <QSet>

#include "app/desk.h"
#include "app/window_checks.h"
#include "help/help_desk.h"
#include "help/help_topic.h"
#include "help/help_window.h"
#include "help/manual_browser.h"
#include "screenshots/painted_text.h"

namespace vantage {
namespace {

using testing::Desk;

class HelpPages : public ::testing::Test {
 protected:
  [[nodiscard]] bool has(const QString& topic) { return help().manual().has(topic); }
  [[nodiscard]] HelpWindow& help() { return desk_.window().help().window(); }
  [[nodiscard]] QString shown() { return help().findChild<ManualBrowser*>()->source().fileName(); }
  void pressF1(QWidget& widget) {
    QKeyEvent key(QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier);
    QCoreApplication::sendEvent(&widget, &key);
  }

  Desk desk_{{1280, 800}, false};
};

TEST_F(HelpPages, EveryPageOfTheWizardHasItsOwnThatIsThere) {
  QSet<QString> topics;
  Wizard& wizard = desk_.window().wizard();
  for (int i = 0; i < wizard.pageCount(); ++i) {
    wizard.goTo(i);
    const QString topic = helpTopicOf(&wizard.page());
    EXPECT_TRUE(has(topic)) << topic.toStdString();
    EXPECT_EQ(helpTopicOf(&wizard), topic) << "also for the buttons below the page";
    topics << topic;
  }
  EXPECT_EQ(topics.size(), wizard.pageCount());
}

TEST_F(HelpPages, EveryDockHasOneThatIsThere) {
  int docks = 0;
  for (const auto* dock : desk_.window().findChildren<QDockWidget*>()) {
    const QString topic = helpTopicOf(dock->widget());
    EXPECT_NE(topic, "contents") << dock->objectName().toStdString();
    EXPECT_TRUE(has(topic)) << dock->objectName().toStdString() << ": " << topic.toStdString();
    ++docks;
  }
  EXPECT_EQ(docks, 7);
  EXPECT_TRUE(has(helpTopicOf(&desk_.window().views().model())));
}

TEST_F(HelpPages, EveryDialogOfTheMenusHasOneThatIsThere) {
  for (const char* text : {"&Settings…", "Copy &diagnostics…", "&Import or add scans…"}) {
    for (const auto* menu : desk_.window().findChildren<QMenu*>())
      for (QAction* action : menu->actions())
        if (action->text().startsWith(QString::fromUtf8(text))) action->trigger();
    Desk::settle();
    QDialog* dialog = nullptr;
    for (auto* candidate : desk_.window().findChildren<QDialog*>())
      if (candidate->isVisible()) dialog = candidate;
    ASSERT_NE(dialog, nullptr) << text;
    pressF1(*dialog);
    EXPECT_TRUE(help().isVisible()) << text;
    EXPECT_TRUE(has(helpTopicOf(dialog))) << text;
    EXPECT_EQ(shown(), helpTopicOf(dialog).section('#', 0, 0) + ".md") << text;
    EXPECT_TRUE(dialog->isVisible()) << text;
    help().close();
    dialog->reject();
    Desk::settle();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

TEST_F(HelpPages, F1OpensTheManualAtThePageOfTheWizard) {
  desk_.next();
  desk_.window().wizard().takeKeyboard();
  pressF1(*desk_.window().focusWidget());
  EXPECT_TRUE(help().isVisible());
  EXPECT_EQ(shown(), "check.md");
}

TEST_F(HelpPages, IsLegibleInBothThemes) {
  for (const bool dark : {false, true}) {
    Preferences preferences;
    preferences.theme = dark ? 1 : 0;
    desk_.window().applyPreferences(preferences);
    for (const char* topic : {"contents", "first_scan", "why", "messages_scans", "keyboard"}) {
      desk_.window().help().showTopic(QString::fromLatin1(topic));
      Desk::settle();
      const QImage image = help().grab().toImage();
      QDir().mkpath(QStringLiteral(VANTAGE_SCREENSHOT_DIR));
      image.save(QStringLiteral(VANTAGE_SCREENSHOT_DIR) + "/help_" + topic + (dark ? "_dark.png" : "_light.png"));
      EXPECT_TRUE(testing::isNotBlank(image)) << topic;
      EXPECT_EQ(testing::clipped(help()).join(" | ").toStdString(), "") << topic;
      EXPECT_EQ(testing::nameless(help()).join(" | ").toStdString(), "") << topic;
      EXPECT_EQ(testing::unexplained(help()).join(" | ").toStdString(), "") << topic;
      EXPECT_EQ(testing::collidingMnemonics(help()).join(" | ").toStdString(), "") << topic;
      // No page is wider than the window at its usual size.
      EXPECT_EQ(help().findChild<ManualBrowser*>()->horizontalScrollBar()->maximum(), 0) << topic;
    }
  }
}

}  // namespace
}  // namespace vantage
