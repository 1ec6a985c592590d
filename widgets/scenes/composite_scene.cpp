#include "scenes/composite_scene.h"

#include <QCoreApplication>
#include <utility>

#include "scenes/model_scene.h"

namespace vantage {
namespace {

// A marker is so large, of the largest side of what is shown.
constexpr double kMarkerSize = 0.014;

struct Text {
  Q_DECLARE_TR_FUNCTIONS(CompositeScene)
};

QColor colourOf(PlaceWord word) {
  return toColour(placeColour(word).value_or(Rgb{}));
}

}  // namespace

Rgb objectColour(const Theme& theme) {
  return toRgb(theme.surface);
}

Rgb standSurfaceColour(const Theme& theme) {
  return theme.dark ? Rgb{0x5C, 0x9F, 0xD6} : Rgb{0x86, 0xB4, 0xDB};
}

KeyLegend placesLegend(const Theme& theme) {
  return {Text::tr("Object and stand"),
          {{toColour(objectColour(theme)), Text::tr("object")},
           {toColour(standSurfaceColour(theme)), Text::tr("stand")},
           {colourOf(PlaceWord::OnIt), Text::tr("on each other")},
           {colourOf(PlaceWord::Conflict), Text::tr("contradicted")},
           {colourOf(PlaceWord::Missing), Text::tr("expected, not seen")}}};
}

CompositeScene::CompositeScene() : object_(scene_), stand_(scene_), markers_(scene_), theme_(&lightTheme()) {
  setTheme(lightTheme());
}

void CompositeScene::set(std::shared_ptr<const ModelGeometry> object, std::shared_ptr<const ModelGeometry> stand) {
  objectShown_ = std::move(object);
  standShown_ = std::move(stand);
  places_.reset();
  updateWords();
  setMarkers(marked_);
}

void CompositeScene::setPose(const Pose& T_object_stand, std::shared_ptr<const PosePlaces> places) {
  places_ = std::move(places);
  stand_.setPose(T_object_stand);
  updateWords();
}

void CompositeScene::updateWords() {
  object_.set(objectShown_, places_ ? places_->reference : std::vector<PlaceWord>());
  stand_.set(standShown_, places_ ? places_->moved : std::vector<PlaceWord>());
}

void CompositeScene::setMarkers(const std::vector<Vec3>& places) {
  marked_ = places;
  markers_.set(places, kMarkerSize * box().size().maxCoeff());
}

void CompositeScene::setTheme(const Theme& theme) {
  theme_ = &theme;
  scene_.setTheme(theme);
  object_.setColour(objectColour(theme));
  stand_.setColour(standSurfaceColour(theme));
  markers_.setTheme(theme);
}

void CompositeScene::setMoving(bool moving) {
  object_.setMoving(moving);
  stand_.setMoving(moving);
  scene_.setMoving(moving);
}

BoundingBox CompositeScene::box() const {
  if (isEmpty()) return {Vec3(-50.0, -50.0, 0.0), Vec3(50.0, 50.0, 60.0)};
  BoundingBox box = objectShown_ ? object_.box() : stand_.box();
  if (!standShown_) return box;
  const BoundingBox other = stand_.box();
  box.extend(other.min);
  box.extend(other.max);
  return box;
}

Camera CompositeScene::camera(CameraPreset preset, double aspect) const {
  return presetCamera(preset, box(), scene_.camera(), std::nullopt, aspect);
}

Overlay CompositeScene::overlay() const {
  Overlay overlay;
  if (!title_.isEmpty()) overlay.notes << title_;
  if (objectShown_ && standShown_) overlay.legends.emplace_back(placesLegend(*theme_));
  return overlay;
}

std::optional<Vec3> CompositeScene::pick(const SightLine& line) const {
  const auto onObject = object_.meets(line.origin, line.direction);
  const auto onStand = stand_.meets(line.origin, line.direction);
  if (!onStand) return onObject;
  if (object_.geometry() == nullptr) return onStand;
  // Both are shown: in coordinates of the scene, which are the object's.
  const Vec3 other = stand_.toScene(*onStand);
  if (!onObject) return other;
  return (*onObject - line.origin).squaredNorm() <= (other - line.origin).squaredNorm() ? *onObject : other;
}

}  // namespace vantage
