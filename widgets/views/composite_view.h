#pragma once

#include <memory>
#include <vector>

#include "composites/pose_places.h"
#include "views/scene_view.h"

namespace vantage {

class CompositeScene;
struct ModelGeometry;

/// The object and the composite of a stand over each other, or one of them alone to pick places on.
class CompositeView final : public SceneView {
  Q_OBJECT

 public:
  /// @param name for assistive technology
  CompositeView(const SurfaceMaker& surfaces, const QString& name, QWidget* parent = nullptr);
  ~CompositeView() override;

  /// What is shown, whole in sight; null leaves one out.
  void showSurfaces(const std::shared_ptr<const ModelGeometry>& object,
                    const std::shared_ptr<const ModelGeometry>& stand);
  /// @param places null while nobody knows
  void setPose(const Pose& T_object_stand, const std::shared_ptr<const PosePlaces>& places);
  void setMarkers(const std::vector<Vec3>& places);
  void setTitle(const QString& title);
  void setTheme(const Theme& theme) override;

 signals:
  void surfacePicked(const vantage::Vec3& place);  ///< see CompositeScene::pick

 protected:
  [[nodiscard]] Camera cameraFor(CameraPreset preset, double aspect) const override;
  void picked(const SightLine& line) override;
  void hovered(const SightLine& line) override;
  void hoverLeft() override;
  void movingChanged(bool moving) override;
  [[nodiscard]] Vec3 centreOf(const SightLine& line) const override;

 private:
  void refresh();

  std::unique_ptr<CompositeScene> scene_;
};

}  // namespace vantage
