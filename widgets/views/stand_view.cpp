#include "views/stand_view.h"

#include <utility>

#include "scenes/model_scene.h"
#include "scenes/stand_scene.h"

namespace vantage {

// Pictures that are being taken.
struct StandView::Session {
  int number = 0;
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
  ++asked_;
  scene_->set(geometry, profile);
  redraw();
}

void StandView::showStand(const Pose& T_object_table) {
  shown_ = T_object_table;
  moved_ = false;
  scene_->setStand(T_object_table);
  lookFrom(CameraPreset::Oblique);
}

void StandView::setTheme(const Theme& theme) {
  scene_->setTheme(theme);
  SceneView::setTheme(theme);
}

void StandView::takeStands(std::vector<Pose> T_object_table, const Taken& taken) {
  takeNext(std::make_shared<Session>(Session{++asked_, std::move(T_object_table), {}, taken}));
}

// The scene has one pose at a time: the next picture is begun when the last is there.
void StandView::takeNext(const std::shared_ptr<Session>& session) {
  if (session->number != asked_) return;
  if (session->pictures.size() == session->stands.size()) {
    scene_->setStand(shown_);
    redraw();
    return session->taken(session->pictures);
  }
  scene_->setStand(session->stands[session->pictures.size()]);
  takePictures({CameraPreset::Oblique}, [this, session](const std::vector<QImage>& pictures) {
    session->pictures.push_back(pictures.front());
    takeNext(session);
  });
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
