#include "views/positional_space_view.h"

#include "scenes/positional_scene.h"
#include "views/geometry_loader.h"

namespace vantage {

PositionalSpaceView::PositionalSpaceView(const SurfaceMaker& surfaces, QWidget* parent,
                                         std::shared_ptr<GeometryStore> store)
    : SceneView(parent),
      scene_(std::make_unique<PositionalScene>()),
      loader_(std::make_unique<GeometryLoader>(std::move(store))) {
  setAccessibleName(tr("Positional space"));
  attach(scene_->scene(), surfaces);
  lookFrom(CameraPreset::Oblique);
  refresh();
}

PositionalSpaceView::~PositionalSpaceView() {
  detach();
}

void PositionalSpaceView::setSnapshot(const SharedSnapshot& snapshot) {
  loader_->load(
      snapshot ? snapshot->state : nullptr, [this, snapshot](const auto& geometry) { show(snapshot, geometry); },
      [this](const QString& why) {
        setOverlay({{tr("The model cannot be shown: %1").arg(why)}, {}});
      });
}

void PositionalSpaceView::show(const SharedSnapshot& snapshot, const std::shared_ptr<const ModelGeometry>& geometry) {
  scene_->set(snapshot, geometry);
  const bool known = snapshot && snapshot->scannerImages;
  if (!fitted_ && known) lookFrom(CameraPreset::Oblique);
  fitted_ = fitted_ || known;
  refresh();
}

void PositionalSpaceView::refresh() {
  setOverlay(scene_->overlay());
  redraw();
}

void PositionalSpaceView::setOptions(const PositionalViewOptions& options) {
  if (options == scene_->options()) return;
  scene_->setOptions(options);
  refresh();
}

const PositionalViewOptions& PositionalSpaceView::options() const {
  return scene_->options();
}

void PositionalSpaceView::highlightCells(const std::vector<std::uint32_t>& cells) {
  scene_->highlightCells(cells);
  redraw();
}

void PositionalSpaceView::pointAt(const std::optional<MapCell>& cell) {
  scene_->pointAt(cell);
  refresh();
}

void PositionalSpaceView::setTheme(const Theme& theme) {
  scene_->setTheme(theme);
  SceneView::setTheme(theme);
}

Camera PositionalSpaceView::cameraFor(CameraPreset preset, double aspect) const {
  return scene_->camera(preset, aspect);
}

void PositionalSpaceView::finishLoading() {
  loader_->finish();
}

void PositionalSpaceView::picked(const SightLine& line) {
  if (const auto cell = scene_->pick(line)) emit cellPicked(*cell);
}

void PositionalSpaceView::hovered(const SightLine& line) {
  const auto cell = scene_->pick(line);
  pointAt(cell);
  emit cellHovered(cell);
}

void PositionalSpaceView::hoverLeft() {
  pointAt(std::nullopt);
  emit cellHovered(std::nullopt);
}

void PositionalSpaceView::movingChanged(bool moving) {
  scene_->setMoving(moving);
}

Vec3 PositionalSpaceView::centreOf(const SightLine& line) const {
  return scene_->pick(line) ? scene_->box().centre() : camera().target;
}

}  // namespace vantage
