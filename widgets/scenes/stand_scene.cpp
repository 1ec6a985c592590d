#include "scenes/stand_scene.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace vantage {
namespace {

// How much of the table is seen around the object, as a share of the object's width.
constexpr double kTableAround = 0.1;

BoundingBox boxOf(const std::vector<Vec3>& points, const Pose& moved) {
  BoundingBox box{moved * points.front(), moved * points.front()};
  for (const Vec3& point : points) box.extend(moved * point);
  return box;
}

}  // namespace

StandScene::StandScene() : turntable_(scene_), model_(scene_) {
  setTheme(lightTheme());
}

void StandScene::set(std::shared_ptr<const ModelGeometry> geometry, const ScannerProfile* profile) {
  geometry_ = std::move(geometry);
  turntable_.set(geometry_ ? profile : nullptr);
  model_.set(geometry_, ModelColouring::Plain, {});
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
  if (!geometry_ || geometry_->model->mesh.vertices.empty())
    return {Vec3(-100.0, -100.0, 0.0), Vec3(100.0, 100.0, 60.0)};
  BoundingBox box = boxOf(geometry_->model->mesh.vertices, T_table_object_);
  const double around = kTableAround * std::max(box.size().x(), box.size().y());
  box.extend(Vec3(box.min.x() - around, box.min.y() - around, 0.0));
  box.extend(Vec3(box.max.x() + around, box.max.y() + around, 0.0));
  return box;
}

}  // namespace vantage
