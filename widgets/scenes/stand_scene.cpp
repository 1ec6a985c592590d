#include "scenes/stand_scene.h"

#include <algorithm>
#include <utility>

namespace vantage {
namespace {

// How much of the table is seen around the object, as a share of the object's width.
constexpr double kTableAround = 0.15;

BoundingBox boxOf(const BoundingBox& box, const Pose& moved) {
  BoundingBox all{moved * box.min, moved * box.min};
  for (int corner = 0; corner < 8; ++corner)
    all.extend(moved * Vec3((corner & 1) != 0 ? box.max.x() : box.min.x(),
                            (corner & 2) != 0 ? box.max.y() : box.min.y(),
                            (corner & 4) != 0 ? box.max.z() : box.min.z()));
  return all;
}

}  // namespace

StandScene::StandScene() : turntable_(scene_), model_(scene_) {
  setTheme(lightTheme());
}

void StandScene::set(std::shared_ptr<const ModelGeometry> geometry, const ScannerProfile* profile) {
  geometry_ = std::move(geometry);
  turntable_.set(geometry_ ? profile : nullptr);
  model_.set(geometry_, ModelColouring::Plain, 0);
}

void StandScene::setStand(const Pose& T_object_table) {
  T_table_object_ = T_object_table.inverse();
  model_.setPose(T_table_object_);
}

void StandScene::setTheme(const Theme& theme) {
  scene_.setTheme(theme);
  turntable_.setTheme(theme);
  model_.setTheme(theme);
}

void StandScene::setMoving(bool moving) {
  model_.setMoving(moving);
  scene_.setMoving(moving);
}

BoundingBox StandScene::box() const {
  if (!geometry_) return {Vec3(-100.0, -100.0, 0.0), Vec3(100.0, 100.0, 60.0)};
  BoundingBox box = boxOf(geometry_->box, T_table_object_);
  const double around = kTableAround * std::max(box.size().x(), box.size().y());
  box.extend(Vec3(box.min.x() - around, box.min.y() - around, 0.0));
  box.extend(Vec3(box.max.x() + around, box.max.y() + around, 0.0));
  return box;
}

}  // namespace vantage
