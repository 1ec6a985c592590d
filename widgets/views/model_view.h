#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "layers/model_options.h"
#include "layers/view_snapshot.h"
#include "scenes/tool_notes.h"
#include "views/background_work.h"
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
  /// Projects in parallel, and says so in the view.
  void showParallel(bool parallel);
  /// From now on clicks, and Enter for the middle of the view, pick places on the surface to measure between; or not
  /// any more. Either forgets the places that were picked. A third place is the first of the next two.
  void setMeasuring(bool measuring);
  [[nodiscard]] const std::vector<Vec3>& measured() const { return tools_.measured; }
  /// What there is to look at.
  [[nodiscard]] BoundingBox modelBox() const;
  /// What the cut of the options cuts out of the model; nothing while that is computed, without a cut or a model.
  [[nodiscard]] const std::optional<PlaneSection>& cutOut() const { return tools_.section; }

  /// Waits until the model is ready and shown. For tests and pictures.
  void finishLoading();

 signals:
  void patchPicked(std::uint32_t patch);       ///< index into the plan's void patches
  void surfacePicked(std::uint32_t triangle);  ///< of the model
  void nothingPicked();
  void loadingChanged(bool loading);
  void measuredChanged();
  void cutOutChanged();

 protected:
  [[nodiscard]] Camera cameraFor(CameraPreset preset, double aspect) const override;
  void picked(const SightLine& line) override;
  void hovered(const SightLine& line) override;
  void hoverLeft() override;
  void movingChanged(bool moving) override;
  [[nodiscard]] Vec3 centreOf(const SightLine& line) const override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void show(const SharedSnapshot& snapshot, const std::shared_ptr<const ModelGeometry>& geometry);
  void refresh();
  void measureAt(const SightLine& line);
  void computeCutOut();

  std::unique_ptr<ModelScene> scene_;
  std::unique_ptr<GeometryLoader> loader_;
  bool fittedToModel_ = false;
  ViewTools tools_;
  BackgroundWork cutting_;
};

}  // namespace vantage
