#pragma once

#include <QListWidget>

#include "look/theme.h"
#include "session_controller.h"

namespace vantage {

class StandStrip;

/// The moments of a session from left to right; clicking one shows the session as it was then. Moments that were undone
/// are struck out until something new is done. Once the object was turned over, a strip above them says which are of
/// which stand.
class TimeLine final : public QListWidget {
  Q_OBJECT

 public:
  explicit TimeLine(SessionController& controller, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override { return {600, 78 + stripHeight()}; }
  void setTheme(const Theme& theme);
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 74 + stripHeight()}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] int stripHeight() const;
  void placeStrip();
  void refresh();
  void mark();

  SessionController& controller_;
  StandStrip* stands_;
  const Theme* theme_ = &lightTheme();
};

}  // namespace vantage
