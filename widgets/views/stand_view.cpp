#include "views/stand_view.h"

#include <utility>

#include "scenes/model_scene.h"
#include "scenes/stand_scene.h"

namespace vantage {

// Pictures that are being taken.
struct StandView::Taking {
  std::vector<Pose> stands;
  std::vector<QImage> pictures;
  Taken taken;
};

StandView::StandView(const SurfaceMaker& surfaces, QWidget* parent)
    : SceneView(parent), scene_(std::make_unique<StandScene>()) {
  setAccessibleName(tr("The object as it would stand"));
  attach(scene_->scene(), surfaces);
  lookFrom(CameraPreset::Oblique);
}

StandView::~StandView() {
  detach();
}

void StandView::setModel(const std::shared_ptr<const ModelGeometry>& geometry, const ScannerProfile* profile) {
  taking_.reset();
  scene_->set(geometry, profile);
  redraw();
}

void StandView::showStand(const Pose& T_object_table) {
  shown_ = T_object_table;
  moved_ = false;
  if (taking_) return;
  scene_->setStand(T_object_table);
  lookFrom(CameraPreset::Oblique);
}

void StandView::setTheme(const Theme& theme) {
  scene_->setTheme(theme);
  SceneView::setTheme(theme);
}

void StandView::takeStands(std::vector<Pose> T_object_table, const Taken& taken) {
  taking_ = std::make_shared<Taking>(Taking{std::move(T_object_table), {}, taken});
  takeNext();
}

// The scene has one pose at a time: the next picture is begun when the last is there.
void StandView::takeNext() {
  if (taking_->pictures.size() == taking_->stands.size()) return finishTaking();
  scene_->setStand(taking_->stands[taking_->pictures.size()]);
  takePictures({CameraPreset::Oblique}, [this, taking = taking_](const std::vector<QImage>& pictures) {
    if (taking != taking_) return;
    taking_->pictures.push_back(pictures.front());
    takeNext();
  });
}

void StandView::finishTaking() {
  const auto taking = std::exchange(taking_, nullptr);
  showStand(shown_);
  taking->taken(taking->pictures);
}

Camera StandView::cameraFor(CameraPreset preset, double aspect) const {
  return presetCamera(preset, scene_->box(), scene_->scene().camera(), {}, aspect);
}

void StandView::picked(const SightLine& /*line*/) {}
void StandView::hovered(const SightLine& /*line*/) {}
void StandView::hoverLeft() {}

void StandView::movingChanged(bool moving) {
  moved_ = true;
  scene_->setMoving(moving);
}

void StandView::resizeEvent(QResizeEvent* event) {
  SceneView::resizeEvent(event);
  if (!moved_) lookFrom(CameraPreset::Oblique);
}

Vec3 StandView::centreOf(const SightLine& /*line*/) const {
  return scene_->box().centre();
}

}  // namespace vantage
