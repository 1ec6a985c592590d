#include "large_session.h"

#include <cmath>

#include "support/meshes.h"
#include "support/scenes/journal_pen.h"

namespace vantage::testing {
namespace {

constexpr int kSide = 260;

std::shared_ptr<const RayGrid> parallelRays() {
  std::vector<RangingRay> rays;
  for (int r = 0; r < kSide; ++r)
    for (int c = 0; c < kSide; ++c) rays.push_back({Vec3(0.5 * c, 0.5 * r, 100.0), Vec3(0, 0, -1)});
  return std::make_shared<const RayGrid>(kSide, kSide, std::move(rays), std::vector<Vec3>(), 0);
}

RangeImage wavyWall(const std::shared_ptr<const RayGrid>& rays, int view) {
  RangeImage image;
  image.rays = rays;
  for (std::size_t i = 0; i < rays->size(); ++i) {
    const Vec3& o = rays->ray(i).origin;
    image.range.push_back(static_cast<float>(90.0 + 3.0 * std::sin(0.1 * o.x() + view) + std::cos(0.07 * o.y())));
  }
  return image;
}

std::shared_ptr<const Model> anyModel() {
  auto model = std::make_shared<Model>();
  model->mesh = makeGrid(200, 200, 0.5);
  const std::size_t vertices = model->mesh.vertices.size();
  model->confidence.assign(vertices, 1.0F);
  model->vertexView.assign(vertices, 0);
  model->vertexSample.assign(vertices, 0);
  model->triangleView.assign(model->mesh.triangles.size(), 0);
  return model;
}

}  // namespace

void writeLargeSession(const std::string& path, int views) {
  Session session = Session::create(path, {std::nullopt, {}, nullptr});
  const auto rays = parallelRays();
  AcquisitionState state = *session.state();
  state.model = anyModel();
  for (int i = 0; i < views; ++i) {
    const NumberedScan scan = session.keepScan(wavyWall(rays, i));
    KeptScan kept;
    kept.number = scan.number;
    kept.view.image = scan.image;
    kept.record.samples = rays->size();
    state.scans.push_back(std::move(kept));
    JournalPen::record(session, AddScan{scan.number, {}}, state);
  }
}

}  // namespace vantage::testing
