#include "scenes/positional_scene.h"

#include <QCoreApplication>

#include "layers/positional_links.h"
#include "look/figures.h"
#include "scenes/model_scene.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(PositionalSpace)
};

}  // namespace

PositionalScene::PositionalScene() : model_(scene_), layer_(scene_) {
  setTheme(lightTheme());
}

void PositionalScene::set(SharedSnapshot snapshot, std::shared_ptr<const ModelGeometry> geometry) {
  snapshot_ = std::move(snapshot);
  geometry_ = std::move(geometry);
  pointed_.reset();
  highlighted_.clear();
  update();
}

void PositionalScene::setOptions(const PositionalViewOptions& options) {
  options_ = options;
  update();
}

void PositionalScene::setTheme(const Theme& theme) {
  scene_.setTheme(theme);
  model_.setTheme(theme);
  layer_.setTheme(theme);
}

void PositionalScene::highlightCells(const std::vector<std::uint32_t>& cells) {
  highlighted_ = cells;
  outline();
}

void PositionalScene::pointAt(const std::optional<MapCell>& cell) {
  pointed_ = cell;
  outline();
}

void PositionalScene::outline() {
  std::vector<std::uint32_t> cells = highlighted_;
  if (pointed_ && field_) cells.push_back(field_->numberOf(*pointed_));
  layer_.highlight(cells);
}

void PositionalScene::update() {
  field_ = snapshot_ ? cellField(*snapshot_, options_) : std::nullopt;
  const bool known = snapshot_ && snapshot_->scannerImages;
  layer_.set(known ? &snapshot_->scannerImages->grid() : nullptr, field_ ? &*field_ : nullptr);
  model_.set(geometry_, ModelColouring::Plain, {});
  outline();
}

BoundingBox PositionalScene::box() const {
  if (!snapshot_ || !snapshot_->scannerImages)
    return geometry_ ? geometry_->box : BoundingBox{{-100, -100, 0}, {100, 100, 200}};
  const PositionalSpaceShape& shape = snapshot_->scannerImages->grid().shape();
  if (shape.surface == PositionalSpaceSurface::Cylinder)
    return {{-shape.radius, -shape.radius, shape.bottom}, {shape.radius, shape.radius, shape.top}};
  const Vec3 centre(0.0, 0.0, 0.5 * (shape.bottom + shape.top));
  return {centre - Vec3::Constant(shape.radius), centre + Vec3::Constant(shape.radius)};
}

Camera PositionalScene::camera(CameraPreset preset, double aspect) const {
  const std::optional<int> position =
      options_.position ? options_.position : (snapshot_ ? snapshot_->foremost() : std::nullopt);
  return presetCamera(preset, box(), scene_.camera(), scannersEye(snapshot_.get(), position), aspect);
}

Overlay PositionalScene::overlay() const {
  Overlay overlay;
  if (!field_) {
    overlay.notes << (snapshot_ && snapshot_->scannerImages ? Text::tr("No plan yet to show in positional space")
                                                            : Text::tr("No positional space yet"));
    return overlay;
  }
  overlay.notes << field_->title;
  if (options_.direction)
    overlay.notes << Text::tr("in directions %1° aside, %2° up, each ± %3°")
                         .arg(figureText(degrees(options_.direction->phi)),
                              figureText(degrees(options_.direction->psi)),
                              figureText(degrees(options_.direction->halfWidth), 1));
  else
    overlay.notes << Text::tr("summed over all directions");
  if (pointed_) overlay.notes << describeCell(*snapshot_, *field_, *pointed_);
  if (options_.legends)
    overlay.legends.emplace_back(ScaleLegend{Text::tr("Per cell"), field_->unit, 0.0, field_->maximum, field_->map});
  return overlay;
}

}  // namespace vantage
