#include "views/composite_view.h"

#include "scenes/composite_scene.h"

namespace vantage {

CompositeView::CompositeView(const SurfaceMaker& surfaces, const QString& name, QWidget* parent)
    : SceneView(parent), scene_(std::make_unique<CompositeScene>()) {
  setAccessibleName(name);
  attach(scene_->scene(), surfaces);
}

CompositeView::~CompositeView() {
  detach();
}

void CompositeView::showSurfaces(const std::shared_ptr<const ModelGeometry>& object,
                                 const std::shared_ptr<const ModelGeometry>& stand) {
  scene_->set(object, stand);
  lookFrom(CameraPreset::Oblique);
  refresh();
}

void CompositeView::setPose(const Pose& T_object_stand, const std::shared_ptr<const PosePlaces>& places) {
  scene_->setPose(T_object_stand, places);
  refresh();
}

void CompositeView::setMarkers(const std::vector<Vec3>& places) {
  scene_->setMarkers(places);
  redraw();
}

void CompositeView::setTitle(const QString& title) {
  scene_->setTitle(title);
  refresh();
}

void CompositeView::setTheme(const Theme& theme) {
  scene_->setTheme(theme);
  SceneView::setTheme(theme);
  refresh();
}

void CompositeView::refresh() {
  setOverlay(scene_->overlay());
  redraw();
}

Camera CompositeView::cameraFor(CameraPreset preset, double aspect) const {
  return scene_->camera(preset, aspect);
}

void CompositeView::picked(const SightLine& line) {
  if (const auto place = scene_->pick(line)) emit surfacePicked(*place);
}

void CompositeView::hovered(const SightLine& line) {
  setCursor(scene_->pick(line) ? Qt::CrossCursor : Qt::ArrowCursor);
}

void CompositeView::hoverLeft() {
  unsetCursor();
}

void CompositeView::movingChanged(bool moving) {
  scene_->setMoving(moving);
}

Vec3 CompositeView::centreOf(const SightLine& line) const {
  return scene_->pick(line).value_or(camera().target);
}

}  // namespace vantage
