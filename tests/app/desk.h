#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QLineEdit>
#include <QSettings>
#include <QSpinBox>
#include <memory>

#include "main_window.h"
#include "screenshots/screenshot.h"

namespace vantage::testing {

/// A window that works at once, before the mug and a folder of its own.
class Desk {
 public:
  Desk(const QSize& size, bool dark) {
    QDir(folder()).removeRecursively();
    QSettings().remove(QStringLiteral("recentSessions"));
    Preferences preferences;
    preferences.theme = dark ? 1 : 0;
    window_ = std::make_unique<MainWindow>(
        WindowParts{controller_, jobs_, testSurfaces(), QStringLiteral(VANTAGE_RESOURCES)}, preferences);
    window_->resize(size);
    window_->show();
    window_->findChild<QSpinBox*>("max_views")->setValue(2);
    window_->findChild<QLineEdit*>("folder")->setText(folder());
    QObject::connect(&controller_, &SessionController::failed,
                     [this](const QString& what) { EXPECT_TRUE(mayFail_) << what.toStdString(); });
    settle();
  }
  ~Desk() { QDir(folder()).removeRecursively(); }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  /// To the next page.
  void next() {
    window_->wizard().goOn();
    settle();
  }
  /// The picture of the window as it is, kept beside the other screenshots.
  QImage picture(const QString& name) {
    window_->views().model().view().finishLoading();
    settle();
    QImage image = window_->grab().toImage();
    QDir().mkpath(QStringLiteral(VANTAGE_SCREENSHOT_DIR));
    const QString scale = image.devicePixelRatio() > 1.0 ? QStringLiteral("_x2") : QString();
    image.save(QStringLiteral(VANTAGE_SCREENSHOT_DIR) + "/window_" + name + scale + ".png");
    return image;
  }
  /// Something is to fail from now on.
  void letFail() { mayFail_ = true; }
  SessionController& controller() { return controller_; }
  MainWindow& window() { return *window_; }

  /// What waits to be done is done.
  static void settle() {
    for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
  }
  /// The same in every run: it is written on the pages. Tests at another scale may run beside these.
  static QString folder() {
    return QDir::temp().filePath(QStringLiteral("vantage-pages-%1").arg(qApp->devicePixelRatio()));
  }

 private:
  bool mayFail_ = false;
  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, QDir::temp().filePath("vantage-pages-cache").toStdString()};
  std::unique_ptr<MainWindow> window_;
};

}  // namespace vantage::testing
