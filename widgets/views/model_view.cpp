#include "views/model_view.h"

#include "scenes/model_scene.h"
#include "views/geometry_loader.h"

namespace vantage {

ModelView::ModelView(const SurfaceMaker& surfaces, QWidget* parent, std::shared_ptr<GeometryStore> store)
    : SceneView(parent),
      scene_(std::make_unique<ModelScene>()),
      loader_(std::make_unique<GeometryLoader>(std::move(store))) {
  setAccessibleName(tr("Model"));
  attach(scene_->scene(), surfaces);
  lookFrom(CameraPreset::Oblique);
}

ModelView::~ModelView() {
  detach();
}

void ModelView::setSnapshot(const SharedSnapshot& snapshot) {
  const std::shared_ptr<const Model> model = snapshot && snapshot->state ? snapshot->state->model : nullptr;
  const bool loads = model && (scene_->geometry() == nullptr || scene_->geometry()->model != model);
  if (loads) emit loadingChanged(true);
  loader_->load(
      snapshot ? snapshot->state : nullptr, [this, snapshot](const auto& geometry) { show(snapshot, geometry); },
      [this](const QString& why) {
        setOverlay({{tr("The model cannot be shown: %1").arg(why)}, {}});
        emit loadingChanged(false);
      });
}

void ModelView::show(const SharedSnapshot& snapshot, const std::shared_ptr<const ModelGeometry>& geometry) {
  scene_->set(snapshot, geometry);
  // What there is to look at changes with the set-up until there is a model, and once more with the first one.
  if (snapshot && !fittedToModel_) lookFrom(CameraPreset::Oblique);
  fittedToModel_ = geometry != nullptr;
  refresh();
  emit loadingChanged(false);
}

void ModelView::refresh() {
  setOverlay(scene_->overlay());
  redraw();
}

void ModelView::setOptions(const ModelViewOptions& options) {
  if (options == scene_->options()) return;
  scene_->setOptions(options);
  refresh();
}

const ModelViewOptions& ModelView::options() const {
  return scene_->options();
}

void ModelView::examine(std::optional<int> position) {
  scene_->examine(position);
  refresh();
}

void ModelView::markView(std::optional<std::uint32_t> view) {
  scene_->markView(view);
  refresh();
}

void ModelView::highlight(const std::vector<std::uint32_t>& patches) {
  scene_->highlight(patches);
  redraw();
}

void ModelView::markErasure(const std::shared_ptr<const Mesh>& part) {
  scene_->markErasure(part);
  refresh();
}

void ModelView::setTheme(const Theme& theme) {
  scene_->setTheme(theme);
  SceneView::setTheme(theme);
  refresh();
}

Camera ModelView::cameraFor(CameraPreset preset, double aspect) const {
  return scene_->camera(preset, aspect);
}

void ModelView::finishLoading() {
  loader_->finish();
}

void ModelView::picked(const SightLine& line) {
  const auto pick = scene_->pick(line);
  if (!pick)
    emit nothingPicked();
  else if (pick->patch)
    emit patchPicked(*pick->patch);
  else
    emit surfacePicked(*pick->triangle);
}

void ModelView::hovered(const SightLine& line) {
  const auto pick = scene_->pick(line);
  setCursor(pick && pick->patch ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void ModelView::hoverLeft() {
  unsetCursor();
}

void ModelView::movingChanged(bool moving) {
  scene_->setMoving(moving);
}

Vec3 ModelView::centreOf(const SightLine& line) const {
  const auto pick = scene_->pick(line);
  return pick ? pick->point : camera().target;
}

}  // namespace vantage
