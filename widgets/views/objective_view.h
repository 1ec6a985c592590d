#pragma once

#include <QWidget>

#include "charts/objective_chart.h"
#include "layers/view_snapshot.h"

namespace vantage {

/// The objective over all positions, as a dial that matches the turntable or as bars. The mouse or the arrow keys point
/// at a position; a click or Return picks it.
class ObjectiveView final : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectiveView(QWidget* parent = nullptr);

  void setSnapshot(const SharedSnapshot& snapshot);
  void setChartStyle(ObjectiveStyle style);
  [[nodiscard]] ObjectiveStyle chartStyle() const { return style_; }
  /// The position that is marked as asked about; unset for none.
  void examine(std::optional<int> position);
  void setTheme(const Theme& theme);

  [[nodiscard]] QSize sizeHint() const override { return {420, 360}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 200}; }

 signals:
  void positionPicked(int position);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void pointAt(std::optional<int> position);

  ObjectiveChartData data_;
  ObjectiveStyle style_ = ObjectiveStyle::Dial;
  std::optional<int> hovered_;
  std::optional<int> examined_;
  const Theme* theme_;
};

}  // namespace vantage
