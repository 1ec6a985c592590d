#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "layers/model_layer.h"
#include "layers/positional_layer.h"
#include "look/legend.h"

namespace vantage {

/// Everything that the view of positional space draws, without a widget.
class PositionalScene {
 public:
  PositionalScene();

  [[nodiscard]] Scene& scene() { return scene_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// @param geometry of the snapshot's model, drawn inside; null for none
  void set(SharedSnapshot snapshot, std::shared_ptr<const ModelGeometry> geometry);
  void setOptions(const PositionalViewOptions& options);
  [[nodiscard]] const PositionalViewOptions& options() const { return options_; }
  void setTheme(const Theme& theme);
  void setMoving(bool moving) {
    model_.setMoving(moving);
    scene_.setMoving(moving);
  }
  void highlightCells(const std::vector<std::uint32_t>& cells);
  /// The cell that is described in the overlay; unset for none.
  void pointAt(const std::optional<MapCell>& cell);

  [[nodiscard]] const SharedSnapshot& snapshot() const { return snapshot_; }
  [[nodiscard]] const std::optional<CellField>& field() const { return field_; }
  [[nodiscard]] BoundingBox box() const;
  [[nodiscard]] Camera camera(CameraPreset preset, double aspect) const;
  [[nodiscard]] Overlay overlay() const;
  [[nodiscard]] std::optional<MapCell> pick(const SightLine& line) const { return layer_.pick(line); }

 private:
  void update();
  void outline();

  Scene scene_;
  ModelLayer model_;
  PositionalLayer layer_;
  SharedSnapshot snapshot_;
  std::shared_ptr<const ModelGeometry> geometry_;
  PositionalViewOptions options_;
  std::optional<CellField> field_;
  std::optional<MapCell> pointed_;
  std::vector<std::uint32_t> highlighted_;
};

}  // namespace vantage
