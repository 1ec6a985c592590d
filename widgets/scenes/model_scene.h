#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "layers/measure_layer.h"
#include "layers/model_layer.h"
#include "layers/ranging_rays_layer.h"
#include "layers/set_up_layer.h"
#include "layers/turntable_layer.h"
#include "layers/view_mark_layer.h"
#include "layers/view_snapshot.h"
#include "layers/void_patch_layer.h"
#include "look/legend.h"
#include "vtk/render_surface.h"

namespace vantage {

/// Everything that the model view draws, without a widget.
class ModelScene {
 public:
  ModelScene();

  [[nodiscard]] Scene& scene() { return scene_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// @param geometry of the snapshot's model; null for none
  void set(SharedSnapshot snapshot, std::shared_ptr<const ModelGeometry> geometry);
  void setOptions(const ModelViewOptions& options);
  [[nodiscard]] const ModelViewOptions& options() const { return options_; }
  void setTheme(const Theme& theme);
  void setMoving(bool moving) {
    model_.setMoving(moving);
    scene_.setMoving(moving);
  }
  void examine(std::optional<int> position);
  void highlight(const std::vector<std::uint32_t>& patches);
  /// Lights up what a view of the model brought; nothing lights up nothing. The next snapshot lights up nothing.
  void markView(std::optional<std::uint32_t> view);

  /// Shows places that are measured between: none, one or two.
  void setMeasured(const std::vector<Vec3>& places);
  /// Marks a part of the model that is about to be erased; null marks nothing. The next snapshot marks nothing.
  void markErasure(const std::shared_ptr<const Mesh>& part);

  [[nodiscard]] const SharedSnapshot& snapshot() const { return snapshot_; }
  [[nodiscard]] const ModelGeometry* geometry() const { return geometry_.get(); }

  /// What there is to look at: the model; before there is one, everything.
  [[nodiscard]] BoundingBox box() const;
  /// The model and the table; before the first scan also the viewing volume, what stands in it and the scanner.
  [[nodiscard]] BoundingBox everything() const;
  [[nodiscard]] Camera camera(CameraPreset preset, double aspect) const;
  [[nodiscard]] Overlay overlay() const;

  struct Pick {
    std::optional<std::uint32_t> patch;     ///< void patch, when that is met first
    std::optional<std::uint32_t> triangle;  ///< of the model
    Vec3 point = Vec3::Zero();
  };
  /// What a line meets first; nothing when it misses everything.
  [[nodiscard]] std::optional<Pick> pick(const SightLine& line) const;
  /// Where a line meets the surface as it is shown first, whatever else is before it.
  [[nodiscard]] std::optional<Pick> pickSurface(const SightLine& line) const;

 private:
  void update();
  [[nodiscard]] ModelColouring colouring() const;
  void updateRays();
  /// Before the first scan of a session with a scanner.
  [[nodiscard]] bool isBefore() const;

  Scene scene_;
  TurntableLayer turntable_;
  SetUpLayer setUp_;
  ModelLayer model_;
  ViewMarkLayer viewMark_;
  ViewMarkLayer erasure_;
  VoidPatchLayer voids_;
  RangingRaysLayer currentRays_;
  RangingRaysLayer proposedRays_;
  MeasureLayer measure_;

  SharedSnapshot snapshot_;
  std::shared_ptr<const ModelGeometry> geometry_;
  ModelViewOptions options_;
  std::optional<int> examined_;
  std::optional<std::uint32_t> markedView_;
  bool marksErasure_ = false;
  const Theme* theme_;
};

/// A scene and what is written over it as one picture.
[[nodiscard]] QImage makePicture(Scene& scene, const Overlay& overlay, const Theme& theme, OffscreenWindow& window,
                                 const QSize& size, double pixelRatio);

/// The camera of a preset on a box.
/// @param eye where the scanner stands; unset looks from the front.
[[nodiscard]] Camera presetCamera(CameraPreset preset, const BoundingBox& box, const Camera& now,
                                  const std::optional<Vec3>& eye, double aspect);

/// Where the scanner's light stands at a position; unset when there is no such position.
[[nodiscard]] std::optional<Vec3> scannersEye(const ViewSnapshot* snapshot, std::optional<int> position);

}  // namespace vantage
