#include "layers/ranging_rays_layer.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "vtk/poly_data.h"

namespace vantage {
namespace {

// Rays drawn along either side of the grid: enough to see the fan, few enough to see through it.
constexpr int kColumns = 9;
constexpr int kRows = 4;
constexpr double kRayWidth = 1.0;
constexpr double kHeadWidth = 3.0;
constexpr double kRayOpacity = 0.45;
constexpr double kReceiverSize = 7.0;  // [mm]

using Segment = std::array<Vec3, 2>;

int spread(int k, int chosen, int count) {
  return static_cast<int>(std::lround(static_cast<double>(k) * (count - 1) / (chosen - 1)));
}

// Where a ray leaves the viewing volume; unset when it misses it.
std::optional<double> farSide(const ViewingVolume& volume, const Vec3& origin, const Vec3& direction) {
  const double a = direction.head<2>().squaredNorm();
  const double b = origin.head<2>().dot(direction.head<2>());
  const double c = origin.head<2>().squaredNorm() - volume.radius * volume.radius;
  const double discriminant = b * b - a * c;
  if (a < 1e-12 || discriminant < 0.0) return std::nullopt;
  double reach = (-b + std::sqrt(discriminant)) / a;
  // Rays that slope end on the lid or the table.
  const double lid = direction.z() > 0.0 ? volume.height : 0.0;
  if (std::abs(direction.z()) > 1e-9) reach = std::min(reach, (lid - origin.z()) / direction.z());
  if (reach <= 0.0) return std::nullopt;
  return reach;
}

// A small octahedron about a place.
void addMarker(Mesh& mesh, const Vec3& centre, double size) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) mesh.vertices.push_back(centre + sign * size * Vec3::Unit(axis));
  for (std::uint32_t x = 0; x < 2; ++x)
    for (std::uint32_t y = 2; y < 4; ++y)
      for (std::uint32_t z = 4; z < 6; ++z) {
        const bool even = (x + y + z) % 2 == 0;
        mesh.triangles.push_back({first + x, first + (even ? y : z), first + (even ? z : y)});
      }
}

}  // namespace

struct RangingRaysLayer::Drawing {
  const ScannerProfile& profile;
  Pose T_object_scanner;
  // Distance at which a ray meets surface; unset when it meets none.
  std::function<std::optional<double>(std::size_t ray, const Vec3& origin, const Vec3& direction)> meets;
};

RangingRaysLayer::RangingRaysLayer(Scene& scene)
    : scene_(scene), rays_(makeActor()), head_(makeActor()), receivers_(makeActor()) {
  scene.addLines(*rays_, kRayWidth);
  scene.addLines(*head_, kHeadWidth);
  scene.add(*receivers_);
  setUnlit(*rays_);
  setUnlit(*head_);
  rays_->GetProperty()->SetOpacity(kRayOpacity);
  clear();
}

void RangingRaysLayer::clear() {
  scene_.change([this] {
    for (vtkActor* actor : {rays_.Get(), head_.Get(), receivers_.Get()}) {
      setData(*actor, nullptr);
      actor->SetVisibility(false);
    }
  });
}

void RangingRaysLayer::setColour(const QColor& colour) {
  scene_.change([this, colour] {
    for (vtkActor* actor : {rays_.Get(), head_.Get(), receivers_.Get()}) vantage::setColour(*actor, toRgb(colour));
  });
}

void RangingRaysLayer::showView(const ScannerProfile& profile, const View& view) {
  const RangeImage& image = *view.image;
  if (image.rays->size() != profile.rays->size()) return clear();
  draw({profile, view.T_object_scanner, [&](std::size_t ray, const Vec3&, const Vec3&) -> std::optional<double> {
          if (!image.valid(ray)) return std::nullopt;
          return static_cast<double>(image.range[ray]);
        }});
}

void RangingRaysLayer::showPosition(const ScannerProfile& profile, int position, const RayCaster* model) {
  if (position < 0 || position >= static_cast<int>(profile.workspace.size())) return clear();
  draw({profile, profile.workspace.poses[static_cast<std::size_t>(position)],
        [&](std::size_t, const Vec3& origin, const Vec3& direction) -> std::optional<double> {
          if (model == nullptr) return std::nullopt;
          const auto hit = model->intersect(origin, direction, profile.minRange, profile.maxRange);
          if (!hit) return std::nullopt;
          return hit->distance;
        }});
}

void RangingRaysLayer::draw(const Drawing& drawing) {
  const RayGrid& grid = *drawing.profile.rays;
  std::vector<Segment> rays;
  std::vector<Segment> head;
  Mesh receivers;
  const Pose& pose = drawing.T_object_scanner;
  for (int i = 0; i < kRows; ++i) {
    for (int k = 0; k < kColumns; ++k) {
      const std::size_t index = grid.index(spread(i, kRows, grid.rows()), spread(k, kColumns, grid.columns()));
      const Vec3 origin = pose * grid.ray(index).origin;
      const Vec3 direction = pose.linear() * grid.ray(index).direction;
      const auto end = drawing.meets(index, origin, direction);
      const auto reach = end ? end : farSide(drawing.profile.viewingVolume, origin, direction);
      if (reach) rays.push_back({origin, origin + *reach * direction});
      if (i > 0)
        head.push_back(
            {pose * grid.ray(grid.index(spread(i - 1, kRows, grid.rows()), spread(k, kColumns, grid.columns()))).origin,
             origin});
      if (k > 0)
        head.push_back(
            {pose * grid.ray(grid.index(spread(i, kRows, grid.rows()), spread(k - 1, kColumns, grid.columns()))).origin,
             origin});
    }
  }
  const std::size_t middle = grid.index(grid.rows() / 2, grid.columns() / 2);
  const Vec3 target =
      pose * Vec3(grid.ray(middle).origin + grid.ray(middle).origin.norm() * grid.ray(middle).direction);
  for (const Vec3& receiver : grid.receivers(middle)) {
    addMarker(receivers, pose * receiver, kReceiverSize);
    rays.push_back({pose * receiver, target});
  }
  scene_.change([this, rays = std::move(rays), head = std::move(head), receivers = std::move(receivers)] {
    setData(*rays_, toSegments(rays));
    setData(*head_, toSegments(head));
    setData(*receivers_, toPolyData(receivers, false));
    for (vtkActor* actor : {rays_.Get(), head_.Get(), receivers_.Get()}) actor->SetVisibility(true);
  });
}

}  // namespace vantage
