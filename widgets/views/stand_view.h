#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "geometry/vectors.h"
#include "views/scene_view.h"

namespace vantage {

class StandScene;
struct ModelGeometry;
struct ScannerProfile;

/// The model resting on one of its sides on the turntable.
class StandView final : public SceneView {
  Q_OBJECT

 public:
  explicit StandView(const SurfaceMaker& surfaces, QWidget* parent = nullptr);
  ~StandView() override;

  /// @param geometry, profile as StandScene has them
  void setModel(const std::shared_ptr<const ModelGeometry>& geometry, const ScannerProfile* profile);
  /// Shows how it would stand, all of it in sight; while pictures are taken, after them.
  void showStand(const Pose& T_object_table);
  void setTheme(const Theme& theme) override;
  [[nodiscard]] QSize sizeHint() const override { return {300, 190}; }

  /// Takes a picture of every stand, one after the other, and shows the last one given to showStand again. Handed over
  /// when all are there; not when others were asked for meanwhile, or the view is gone.
  void takeStands(std::vector<Pose> T_object_table, const Taken& taken);

 protected:
  [[nodiscard]] Camera cameraFor(CameraPreset preset, double aspect) const override;
  void picked(const SightLine& line) override;
  void hovered(const SightLine& line) override;
  void hoverLeft() override;
  void movingChanged(bool moving) override;
  [[nodiscard]] Vec3 centreOf(const SightLine& line) const override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Taking;
  void takeNext();
  void finishTaking();

  std::unique_ptr<StandScene> scene_;
  Pose shown_ = Pose::Identity();
  std::shared_ptr<Taking> taking_;  // null while no pictures are taken
  bool moved_ = false;  // by the operator, since showStand
};

}  // namespace vantage
