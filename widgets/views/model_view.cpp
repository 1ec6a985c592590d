#include "views/model_view.h"

#include <QKeyEvent>

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
  const bool isSame = geometry && scene_->geometry() != nullptr && scene_->geometry()->model == geometry->model;
  scene_->set(snapshot, geometry);
  // What there is to look at changes with the set-up until there is a model, and once more with the first one.
  if (snapshot && !fittedToModel_) lookFrom(CameraPreset::Oblique);
  fittedToModel_ = geometry != nullptr;
  // Places on another model are none on this one.
  if (!isSame && !tools_.measured.empty()) setMeasuring(tools_.measuring);
  computeCutOut();
  refresh();
  emit loadingChanged(false);
}

void ModelView::refresh() {
  Overlay overlay = scene_->overlay();
  overlay.notes << toolNotes(scene_->options(), tools_);
  setOverlay(overlay);
  redraw();
}

void ModelView::setOptions(const ModelViewOptions& options) {
  if (options == scene_->options()) return;
  const bool cutsElsewhere = options.section != scene_->options().section;
  scene_->setOptions(options);
  if (cutsElsewhere) computeCutOut();
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
  cutting_.finish();
}

void ModelView::showParallel(bool parallel) {
  tools_.parallel = parallel;
  setParallel(parallel);
  refresh();
}

void ModelView::setMeasuring(bool measuring) {
  tools_.measuring = measuring;
  tools_.measured.clear();
  scene_->setMeasured({});
  refresh();
  emit measuredChanged();
}

void ModelView::measureAt(const SightLine& line) {
  const auto pick = scene_->pickSurface(line);
  if (!pick) return;
  if (tools_.measured.size() == 2) tools_.measured.clear();
  tools_.measured.push_back(pick->point);
  scene_->setMeasured(tools_.measured);
  refresh();
  emit measuredChanged();
}

BoundingBox ModelView::modelBox() const {
  return scene_->box();
}

// Beside the UI thread: of a million triangles it takes a while, and the plane is moved by a slider.
void ModelView::computeCutOut() {
  cutting_.cancel();
  tools_.section.reset();
  const std::optional<Section> section = scene_->options().section;
  const std::shared_ptr<const Model> model = scene_->geometry() != nullptr ? scene_->geometry()->model : nullptr;
  if (section && model)
    cutting_.start(
        [this, plane = section->plane(), model](const Progress& progress, const BackgroundWork::Deliver& deliver) {
          deliver([this, cut = sectionOf(model->mesh, plane, progress)] {
            tools_.section = cut;
            refresh();
            emit cutOutChanged();
          });
        },
        [this](const QString& why) {
          setOverlay({{tr("The cut cannot be computed: %1").arg(why)}, {}});
        });
  emit cutOutChanged();
}

void ModelView::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!tools_.measuring || !enter) return SceneView::keyPressEvent(event);
  measureAt(lineAt(QRectF(rect()).center()));
}

void ModelView::picked(const SightLine& line) {
  if (tools_.measuring) return measureAt(line);
  const auto pick = scene_->pick(line);
  if (!pick)
    emit nothingPicked();
  else if (pick->patch)
    emit patchPicked(*pick->patch);
  else
    emit surfacePicked(*pick->triangle);
}

void ModelView::hovered(const SightLine& line) {
  if (tools_.measuring) return setCursor(scene_->pickSurface(line) ? Qt::CrossCursor : Qt::ArrowCursor);
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
