#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "layers/cell_field.h"
#include "views/scene_view.h"

namespace vantage {

class GeometryLoader;
class GeometryStore;
class PositionalScene;
struct ModelGeometry;

/// Positional space: its surface about the model with one of the images on it. The half toward the eye is seen through.
class PositionalSpaceView final : public SceneView {
  Q_OBJECT

 public:
  /// @param store shared with other views that draw the same models; null for one of its own
  explicit PositionalSpaceView(const SurfaceMaker& surfaces, QWidget* parent = nullptr,
                               std::shared_ptr<GeometryStore> store = nullptr);
  ~PositionalSpaceView() override;

  void setSnapshot(const SharedSnapshot& snapshot);
  void setOptions(const PositionalViewOptions& options);
  [[nodiscard]] const PositionalViewOptions& options() const;
  /// Cells of the surface that are outlined, row * columns + column.
  void highlightCells(const std::vector<std::uint32_t>& cells);
  void setTheme(const Theme& theme) override;
  /// The cell pointed at, also from another view; unset for none.
  void pointAt(const std::optional<vantage::MapCell>& cell);
  void finishLoading();

 signals:
  void cellHovered(const std::optional<vantage::MapCell>& cell);  ///< unset when it leaves
  void cellPicked(const vantage::MapCell& cell);

 protected:
  [[nodiscard]] Camera cameraFor(CameraPreset preset, double aspect) const override;
  void picked(const SightLine& line) override;
  void hovered(const SightLine& line) override;
  void hoverLeft() override;
  void movingChanged(bool moving) override;
  [[nodiscard]] Vec3 centreOf(const SightLine& line) const override;

 private:
  void show(const SharedSnapshot& snapshot, const std::shared_ptr<const ModelGeometry>& geometry);
  void refresh();

  std::unique_ptr<PositionalScene> scene_;
  std::unique_ptr<GeometryLoader> loader_;
  bool fitted_ = false;
};

}  // namespace vantage
