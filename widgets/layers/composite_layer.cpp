#include "layers/composite_layer.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>

#include <utility>

namespace vantage {
namespace {

Rgb colourOf(PlaceWord word, const Rgb& plain) {
  return placeColour(word).value_or(plain);
}

void place(vtkActor& actor, const Pose& T) {
  const auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) matrix->SetElement(r, c, T.matrix()(r, c));
  actor.SetUserMatrix(matrix);
}

}  // namespace

std::optional<Rgb> placeColour(PlaceWord word) {
  switch (word) {
    case PlaceWord::OnIt:
      return Rgb{0x1F, 0xA6, 0x7A};
    case PlaceWord::Conflict:
    case PlaceWord::Table:
      return Rgb{0xC8, 0x1E, 0x2A};
    case PlaceWord::Missing:
      return Rgb{0xE6, 0xA0, 0x10};
    case PlaceWord::Nothing:
      break;
  }
  return std::nullopt;
}

CompositeLayer::CompositeLayer(Scene& scene) : scene_(scene), surface_(makeActor()), coarse_(makeActor()) {
  scene.add(*surface_);
  scene.add(*coarse_);
  update();
}

void CompositeLayer::set(std::shared_ptr<const ModelGeometry> geometry, std::vector<PlaceWord> words) {
  geometry_ = std::move(geometry);
  words_ = std::move(words);
  paint();
  update();
}

void CompositeLayer::setColour(const Rgb& colour) {
  colour_ = colour;
  paint();
}

// The plain colour is painted, too: where a surface has colours its actor's own counts for nothing.
void CompositeLayer::paint() {
  if (!geometry_)
    return scene_.change([this] {
      setData(*surface_, nullptr);
      setData(*coarse_, nullptr);
    });
  const std::size_t count = geometry_->model->mesh.vertices.size();
  std::vector<Rgb> fine(count, colour_);
  for (std::size_t v = 0; v < words_.size() && v < count; ++v) fine[v] = colourOf(words_[v], colour_);
  std::vector<Rgb> coarse;
  for (const std::uint32_t v : geometry_->coarseVertex) coarse.push_back(fine[v]);
  scene_.change([this, shown = geometry_, fine = std::move(fine), coarse = std::move(coarse)] {
    setData(*surface_, withPointColours(*shown->surface, fine));
    setData(*coarse_, shown->coarse ? withPointColours(*shown->coarse, coarse).Get() : nullptr);
  });
}

void CompositeLayer::setPose(const Pose& T_scene_composite) {
  T_scene_composite_ = T_scene_composite;
  scene_.change([this, T = T_scene_composite] {
    place(*surface_, T);
    place(*coarse_, T);
  });
}

void CompositeLayer::setMoving(bool moving) {
  moving_ = moving;
  update();
}

void CompositeLayer::update() {
  const bool useCoarse = moving_ && geometry_ && geometry_->coarse != nullptr;
  const bool fine = geometry_ && !useCoarse;
  scene_.change([this, fine, useCoarse] {
    surface_->SetVisibility(fine);
    coarse_->SetVisibility(useCoarse);
  });
}

BoundingBox CompositeLayer::box() const {
  const std::vector<Vec3>& vertices = geometry_->model->mesh.vertices;
  if (vertices.empty()) return geometry_->box;
  const Vec3 first = T_scene_composite_ * vertices.front();
  BoundingBox box{first, first};
  for (const Vec3& v : vertices) box.extend(T_scene_composite_ * v);
  return box;
}

std::optional<Vec3> CompositeLayer::meets(const Vec3& origin, const Vec3& direction) const {
  if (!geometry_ || !geometry_->caster) return std::nullopt;
  const Pose T_composite_scene = T_scene_composite_.inverse();
  const Vec3 from = T_composite_scene * origin;
  const Vec3 along = T_composite_scene.linear() * direction;
  const auto hit = geometry_->caster->intersect(from, along);
  if (!hit) return std::nullopt;
  return from + hit->distance * along;
}

}  // namespace vantage
