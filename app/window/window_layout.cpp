#include "window/window_layout.h"

#include <QMainWindow>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "window/fitting.h"

namespace vantage {
namespace {

constexpr int kLayoutVersion = 1;
// Of the docks on the left and on the right at first [px].
constexpr int kGuideWidth = 340;
constexpr int kSideWidth = 350;
constexpr double kMostShare = 0.28;  // of the window's width, each

}  // namespace

WindowLayout::WindowLayout(QMainWindow& window, QDockWidget& guide, const QList<QDockWidget*>& docks)
    : window_(window),
      guide_(guide),
      docks_(docks),
      sides_(new SideDocks(window, docks.first(4))),
      usual_(window.saveState(kLayoutVersion)) {}

void WindowLayout::restore() {
  const QSettings file;
  window_.restoreGeometry(file.value(QStringLiteral("window/geometry")).toByteArray());
  isLaidOut_ = window_.restoreState(file.value(QStringLiteral("window/layout")).toByteArray(), kLayoutVersion);
  fitsScreen_ = true;
  fitToScreen(window_);
}

void WindowLayout::keep() {
  QSettings file;
  file.setValue(QStringLiteral("window/geometry"), window_.saveGeometry());
  sides_->expand();
  file.setValue(QStringLiteral("window/layout"), window_.saveState(kLayoutVersion));
}

void WindowLayout::reset() {
  sides_->expand();
  window_.restoreState(usual_, kLayoutVersion);
  layOut();
  sides_->arrange();
}

void WindowLayout::shown() {
  if (!std::exchange(isLaidOut_, true)) layOut();
  QMetaObject::invokeMethod(
      &window_,
      [this] {
        setLeastSize();
        if (fitsScreen_ && !window_.isMaximized() && !window_.isFullScreen()) fitToScreen(window_);
      },
      Qt::QueuedConnection);
}

void WindowLayout::setLeastSize() {
  window_.setMinimumWidth(sides_->leastWidth());
  sides_->arrange();
}

// As wide as they are meant to be.
void WindowLayout::layOut() {
  const int most = static_cast<int>(kMostShare * window_.width());
  window_.resizeDocks({&guide_, docks_[0]}, {std::min(kGuideWidth, most), std::min(kSideWidth, most)}, Qt::Horizontal);
  window_.resizeDocks({docks_[0], docks_[3]}, {300, 340}, Qt::Vertical);
  window_.resizeDocks({docks_[4]}, {96}, Qt::Vertical);
}

}  // namespace vantage
