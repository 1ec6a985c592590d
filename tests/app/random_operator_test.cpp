// Somebody who clicks and types whatever comes to hand while scans run: the window goes on answering, and nothing that
// was scanned is lost.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QTemporaryDir>
#include <QTest>
#include <random>

#include "app/operator.h"

namespace vantage {
namespace {

constexpr int kActions = 400;
constexpr int kLongestBlock = 500;  // [ms] beyond which somebody takes the window for dead
constexpr std::uint32_t kSeed = 17;

// A dialog that waits for an answer gets none.
class DialogCloser {
 public:
  DialogCloser() {
    timer_.setInterval(150);
    QObject::connect(&timer_, &QTimer::timeout, [] {
      if (QWidget* dialog = QApplication::activeModalWidget()) dialog->close();
      if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    });
    timer_.start();
  }

 private:
  QTimer timer_;
};

class RandomOperator {
 public:
  explicit RandomOperator(testing::Operator& hands) : hands_(hands) {}

  void act() {
    if (chance_(random_) < 60)
      click();
    else
      press();
    QTest::qWait(static_cast<int>(random_() % 60));
  }

 private:
  void click() {
    QList<QAbstractButton*> buttons;
    for (auto* button : hands_.window().findChildren<QAbstractButton*>())
      if (button->isVisible() && button->isEnabled()) buttons << button;
    if (buttons.isEmpty()) return;
    QAbstractButton* button = buttons[static_cast<qsizetype>(random_() % static_cast<unsigned>(buttons.size()))];
    QTest::mouseClick(button, Qt::LeftButton);
  }
  void press() {
    struct Key {
      Qt::Key key;
      Qt::KeyboardModifiers modifiers;
    };
    static constexpr std::array<Key, 17> kKeys{{{Qt::Key_F5, Qt::NoModifier},
                                                {Qt::Key_F6, Qt::NoModifier},
                                                {Qt::Key_F7, Qt::NoModifier},
                                                {Qt::Key_F5, Qt::ShiftModifier},
                                                {Qt::Key_Escape, Qt::NoModifier},
                                                {Qt::Key_Tab, Qt::NoModifier},
                                                {Qt::Key_Tab, Qt::ShiftModifier},
                                                {Qt::Key_Space, Qt::NoModifier},
                                                {Qt::Key_Return, Qt::NoModifier},
                                                {Qt::Key_Left, Qt::NoModifier},
                                                {Qt::Key_Down, Qt::NoModifier},
                                                {Qt::Key_Right, Qt::AltModifier},
                                                {Qt::Key_Left, Qt::AltModifier},
                                                {Qt::Key_Z, Qt::ControlModifier},
                                                {Qt::Key_Y, Qt::ControlModifier},
                                                {Qt::Key_1, Qt::ControlModifier},
                                                {Qt::Key_B, Qt::ControlModifier}}};
    const Key& key = kKeys[random_() % kKeys.size()];
    QWidget* focused = hands_.window().focusWidget();
    QTest::keyClick(focused != nullptr ? focused : &hands_.window(), key.key, key.modifiers);
  }

  testing::Operator& hands_;
  std::mt19937 random_{kSeed};
  std::uniform_int_distribution<int> chance_{0, 99};
};

TEST(RandomOperator, FindsAWindowThatAnswersWhateverIsDone) {
  QTemporaryDir folder;
  testing::Operator hands(folder.filePath("window"), 5);
  const DialogCloser closer;
  RandomOperator random(hands);
  testing::Watchdog watchdog;
  for (int i = 0; i < kActions; ++i) random.act();
  RecordProperty("longest_block_ms", static_cast<int>(watchdog.longest()));
  EXPECT_LE(watchdog.longest(), kLongestBlock);
  if (!hands.controller().idle()) hands.controller().stop();
  EXPECT_TRUE(hands.waitUntilIdle());
}

}  // namespace
}  // namespace vantage
