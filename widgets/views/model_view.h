#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "layers/model_options.h"
#include "layers/view_snapshot.h"
#include "views/scene_view.h"

namespace vantage {

class GeometryLoader;
class GeometryStore;
class ModelScene;
struct ModelGeometry;

/// The model, its void patches, the scanner's rays and the turntable. A large model is made ready beside the UI thread;
/// until then the view shows what it showed before. While the camera moves, a large model is drawn decimated.
class ModelView final : public SceneView {
  Q_OBJECT

 public:
  /// @param store shared with other views that draw the same models; null for one of its own
  explicit ModelView(const SurfaceMaker& surfaces, QWidget* parent = nullptr,
                     std::shared_ptr<GeometryStore> store = nullptr);
  ~ModelView() override;

  void setSnapshot(const SharedSnapshot& snapshot);
  void setOptions(const ModelViewOptions& options);
  [[nodiscard]] const ModelViewOptions& options() const;
  /// A position whose rays are shown in place of those of the proposed view.
  void examine(std::optional<int> position);
  /// Patches that are lit up.
  /// Lights up what a view of the model brought, until another moment is shown; nothing lights up nothing.
  void markView(std::optional<std::uint32_t> view);
  void highlight(const std::vector<std::uint32_t>& patches);
  /// Marks a part of the model that is about to be erased, until another moment is shown; null marks nothing.
  void markErasure(const std::shared_ptr<const Mesh>& part);
  void setTheme(const Theme& theme) override;

  /// Waits until the model is ready and shown. For tests and pictures.
  void finishLoading();

 signals:
  void patchPicked(std::uint32_t patch);       ///< index into the plan's void patches
  void surfacePicked(std::uint32_t triangle);  ///< of the model
  void nothingPicked();
  void loadingChanged(bool loading);

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

  std::unique_ptr<ModelScene> scene_;
  std::unique_ptr<GeometryLoader> loader_;
  bool fittedToModel_ = false;
};

}  // namespace vantage
