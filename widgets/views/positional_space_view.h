#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "layers/cell_field.h"
#include "views/scene_view.h"

namespace vantage {

class PositionalScene;

/// Positional space: its surface about the model with one of the images on it. The half toward the eye is seen through.
class PositionalSpaceView final : public SceneView {
  Q_OBJECT

 public:
  explicit PositionalSpaceView(const SurfaceMaker& surfaces, QWidget* parent = nullptr);
  ~PositionalSpaceView() override;

  void setSnapshot(const SharedSnapshot& snapshot);
  void setOptions(const PositionalViewOptions& options);
  [[nodiscard]] const PositionalViewOptions& options() const;
  /// Cells of the surface that are outlined, row * columns + column.
  void highlightCells(const std::vector<std::uint32_t>& cells);
  void setTheme(const Theme& theme) override;
  void lookFrom(CameraPreset preset) override;

 signals:
  void cellHovered(int row, int column);  ///< -1, -1 when it leaves
  void cellPicked(int row, int column);

 protected:
  void picked(const SightLine& line) override;
  void hovered(const SightLine& line) override;
  void movingChanged(bool moving) override;
  [[nodiscard]] Vec3 centreOf(const SightLine& line) const override;

 private:
  std::unique_ptr<PositionalScene> scene_;
  bool fitted_ = false;
};

}  // namespace vantage
