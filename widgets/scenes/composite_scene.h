#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "composites/pose_places.h"
#include "layers/composite_layer.h"
#include "layers/marker_layer.h"
#include "look/legend.h"

namespace vantage {

/// The object and the composite of a stand over each other in a pose, or one of them alone; with numbered places.
class CompositeScene {
 public:
  CompositeScene();

  [[nodiscard]] Scene& scene() { return scene_; }

  /// What is shown; null leaves one out.
  void set(std::shared_ptr<const ModelGeometry> object, std::shared_ptr<const ModelGeometry> stand);
  /// Where the stand's composite lies, and what its vertices (moved) and the object's (reference) are to each other
  /// then; null while nobody knows.
  void setPose(const Pose& T_object_stand, std::shared_ptr<const PosePlaces> places);
  /// Numbered, in coordinates of the scene.
  void setMarkers(const std::vector<Vec3>& places);
  void setTitle(const QString& title) { title_ = title; }
  void setTheme(const Theme& theme);
  void setMoving(bool moving);

  [[nodiscard]] bool isEmpty() const { return object_.geometry() == nullptr && stand_.geometry() == nullptr; }
  [[nodiscard]] BoundingBox box() const;
  [[nodiscard]] Camera camera(CameraPreset preset, double aspect) const;
  [[nodiscard]] Overlay overlay() const;
  /// Where a line meets a surface first: of one composite alone in its own coordinates.
  [[nodiscard]] std::optional<Vec3> pick(const SightLine& line) const;

 private:
  void updateWords();

  Scene scene_;
  CompositeLayer object_;
  CompositeLayer stand_;
  MarkerLayer markers_;
  std::shared_ptr<const ModelGeometry> objectShown_;
  std::shared_ptr<const ModelGeometry> standShown_;
  std::shared_ptr<const PosePlaces> places_;
  std::vector<Vec3> marked_;
  QString title_;
  const Theme* theme_;
};

/// The colours of object and stand where nothing is known of their places.
[[nodiscard]] Rgb objectColour(const Theme& theme);
[[nodiscard]] Rgb standSurfaceColour(const Theme& theme);

/// What the colours of two composites over each other mean.
[[nodiscard]] KeyLegend placesLegend(const Theme& theme);

}  // namespace vantage
