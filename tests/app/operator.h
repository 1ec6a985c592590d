#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDeadlineTimer>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <ctime>
#include <fstream>

#include "main_window.h"

namespace vantage::testing {

inline constexpr int kPatience = 200000;  ///< [ms] for a whole acquisition on a busy machine

/// Lets the window work until something holds. As a program does it sleeps until an event comes: QTest::qWaitFor naps
/// between events, which a watchdog would take for a window that does not answer.
template <typename Condition>
bool waitFor(const Condition& holds) {
  const QDeadlineTimer patience(kPatience);
  QTimer look;
  look.start(20);
  while (!holds() && !patience.hasExpired()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  return holds();
}

/// The window as main makes it, and the hands of an operator.
class Operator {
 public:
  Operator(const QString& folder, int views) {
    window_.resize(1280, 800);
    window_.show();
    window_.findChild<QSpinBox*>("max_views")->setValue(views);
    window_.findChild<QLineEdit*>("folder")->setText(folder);
  }

  // Clicks a button that is in sight and enabled.
  void click(const char* name) {
    for (auto* button : window_.findChildren<QAbstractButton*>(name)) {
      if (!button->isVisible()) continue;
      ASSERT_TRUE(waitFor([&] { return button->isEnabled(); })) << name;
      QTest::mouseClick(button, Qt::LeftButton);
      ++clicks_;
      return;
    }
    FAIL() << "no button " << name << " in sight";
  }

  [[nodiscard]] bool waitForPage(const char* key) {
    return waitFor([&] { return window_.wizard().page().key() == key; });
  }
  [[nodiscard]] bool waitUntilIdle() {
    return waitFor([&] { return controller_.idle(); });
  }

  [[nodiscard]] int clicks() const { return clicks_; }
  SessionController& controller() { return controller_; }
  MainWindow& window() { return window_; }

 private:
  ThreadedJobRunner jobs_{machineThreads()};
  SessionController controller_{jobs_, QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString()};
  MainWindow window_{{controller_, jobs_, glSurfaces(), QStringLiteral(VANTAGE_RESOURCES)}, Preferences{}};
  int clicks_ = 0;
};

/// Measures how long this program takes for something: by the clock, or by what it computed meanwhile where other
/// programs kept it from computing, yet no less than a tenth of the clock.
class Stopwatch {
 public:
  Stopwatch() { clock_.start(); }
  [[nodiscard]] qint64 milliseconds() const {
    const qint64 clock = clock_.elapsed();
    const auto computed = static_cast<qint64>(1000.0 * static_cast<double>(std::clock() - computed_) / CLOCKS_PER_SEC);
    return std::min(clock, std::max(computed, clock / 10));
  }

 private:
  QElapsedTimer clock_;
  std::clock_t computed_ = std::clock();
};

/// How long this thread has been ready to go on and got no processor [ms]; 0 where the system does not tell.
[[nodiscard]] inline qint64 keptFromComputing() {
  std::ifstream file("/proc/thread-self/schedstat");
  qint64 computed = 0;
  qint64 kept = 0;
  file >> computed >> kept;
  return kept / 1'000'000;
}

/// Measures the longest time that the event loop did not come round, without that in which others had the processors:
/// what is left it computed, or waited for something.
class Watchdog {
 public:
  Watchdog() {
    timer_.setInterval(5);
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, [this] { look(); });
    clock_.start();
    timer_.start();
  }
  /// [ms]
  [[nodiscard]] qint64 longest() const { return longest_; }

 private:
  void look() {
    const qint64 kept = keptFromComputing();
    longest_ = std::max(longest_, clock_.restart() - (kept - kept_));
    kept_ = kept;
  }

  QTimer timer_;
  QElapsedTimer clock_;
  qint64 kept_ = keptFromComputing();
  qint64 longest_ = 0;
};

}  // namespace vantage::testing
