#pragma once

#include <QPolygonF>
#include <QWidget>
#include <cstdint>

namespace vantage {

enum class DrawnShape : std::uint8_t { Lasso, Rectangle };

/// Lies over a view and lets the operator draw a closed line on it: with the left button held, or by keys: arrows move
/// a cross, space sets a corner, backspace takes it back, Enter closes the line. All other buttons and keys go to the
/// view below, so that it can be turned meanwhile. Esc ends it.
class RegionDrawing final : public QWidget {
  Q_OBJECT

 public:
  /// Hidden until it begins. @param view that it lies over, and that owns it
  explicit RegionDrawing(QWidget& view);

  void begin(DrawnShape shape);
  void end();
  /// What was drawn goes; the next can be drawn.
  void clear();
  /// The corners, in coordinates of the view; empty before a line is closed.
  [[nodiscard]] const QPolygonF& drawn() const { return drawn_; }

 signals:
  void closed();     ///< a line was closed that covers something
  void cancelled();  ///< by Esc

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void follow(const QRectF& before, const QRectF& now);
  void close();
  void reach(const QPointF& point);
  void moveCross(const QPointF& by);

  DrawnShape shape_ = DrawnShape::Lasso;
  QPolygonF line_;   // that is being drawn
  QPolygonF drawn_;  // that was closed
  QPointF cross_;    // of the keyboard
  bool usesKeys_ = false;
  bool pressed_ = false;
};

}  // namespace vantage
