#pragma once

#include <QPointer>
#include <QScrollArea>

namespace vantage {

/// A page that scrolls where it does not fit, and never by itself: a button that cannot be used any more gives up the
/// keyboard without the page moving under the mouse, and has it again when it can be used again.
class PageScroll final : public QScrollArea {
  Q_OBJECT

 public:
  explicit PageScroll(QWidget* page, QWidget* parent = nullptr);

  bool eventFilter(QObject* watched, QEvent* event) override;

 protected:
  bool focusNextPrevChild(bool next) override;

 private:
  void waitFor(QWidget* widget);

  QPointer<QWidget> disabled_;  ///< had the keyboard when it was disabled
};

}  // namespace vantage
