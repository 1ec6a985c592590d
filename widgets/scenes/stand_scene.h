#pragma once

#include <memory>

#include "geometry/measures.h"
#include "layers/model_layer.h"
#include "layers/turntable_layer.h"

namespace vantage {

/// The model as it would stand on the turntable after it was turned over, without a widget. The scene is in the frame
/// of the table.
class StandScene {
 public:
  StandScene();

  [[nodiscard]] Scene& scene() { return scene_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// @param geometry of the model; null for none
  /// @param profile whose table it stands on; null for none
  void set(std::shared_ptr<const ModelGeometry> geometry, const ScannerProfile* profile);
  void setStand(const Pose& T_object_table);
  void setTheme(const Theme& theme);
  void setMoving(bool moving);

  /// The model as it stands, with a little of the table around it.
  [[nodiscard]] BoundingBox box() const;

 private:
  Scene scene_;
  TurntableLayer turntable_;
  ModelLayer model_;
  std::shared_ptr<const ModelGeometry> geometry_;
  Pose T_table_object_ = Pose::Identity();
};

}  // namespace vantage
