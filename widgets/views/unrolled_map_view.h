#pragma once

#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "layers/cell_field.h"
#include "look/theme.h"

namespace vantage {

/// The surface of positional space unrolled: azimuth to the right, height upward. The mouse or the arrow keys point at
/// a cell; a click or Return picks it.
class UnrolledMapView final : public QWidget {
  Q_OBJECT

 public:
  explicit UnrolledMapView(QWidget* parent = nullptr);

  void setSnapshot(const SharedSnapshot& snapshot);
  void setOptions(const PositionalViewOptions& options);
  [[nodiscard]] const PositionalViewOptions& options() const { return options_; }
  void highlightCells(const std::vector<std::uint32_t>& cells);
  /// The cell pointed at, also from another view; unset for none.
  void pointAt(const std::optional<vantage::MapCell>& cell);
  void setTheme(const Theme& theme);

  [[nodiscard]] QSize sizeHint() const override { return {560, 260}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {260, 150}; }

 signals:
  void cellHovered(const std::optional<vantage::MapCell>& cell);  ///< unset when it leaves
  void cellPicked(const vantage::MapCell& cell);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  void moveTo(const std::optional<MapCell>& cell);  // points, and tells other views

  SharedSnapshot snapshot_;
  PositionalViewOptions options_;
  std::optional<CellField> field_;
  std::vector<std::uint32_t> highlighted_;
  std::optional<MapCell> pointed_;
  const Theme* theme_;
};

}  // namespace vantage
