#include "scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geometry/measures.h"
#include "integration/manifold.h"
#include "scanner/profile.h"
#include "scanner/ray_patterns.h"
#include "support/simulation.h"

namespace vantage::testing {

View lookDown(const Window& window, const Height& height, const Pose& T_object_scanner) {
  constexpr double kAltitude = 100.0;
  std::vector<RangingRay> rays;
  RangeImage image;
  for (int r = 0; r < window.rows; ++r) {
    for (int c = 0; c < window.columns; ++c) {
      const double x = window.x + (window.mirrored ? window.columns - 1 - c : c);
      const double y = window.y + r;
      rays.push_back({Vec3(x, y, kAltitude), -Vec3::UnitZ()});
      image.range.push_back(static_cast<float>(kAltitude - height(x, y)));
    }
  }
  image.rays = std::make_shared<RayGrid>(window.rows, window.columns, std::move(rays), std::vector<Vec3>(), 0);
  image.T_table_scanner = T_object_scanner;
  View view;
  view.mesh = std::make_shared<const ViewMesh>(triangulate(image, TriangulationOptions()));
  view.image = std::make_shared<const RangeImage>(std::move(image));
  view.T_object_scanner = T_object_scanner;
  return view;
}

std::vector<View> scanFrom(const Mesh& object, const std::vector<Direction>& directions, double noise) {
  auto profile = std::make_shared<ScannerProfile>();
  profile->rays = std::make_shared<const RayGrid>(
      makeRays(Pinhole{Vec3(300, 0, 0), Vec3::Zero(), 90, 90, radians(19.0), radians(19.0)}, ReceiverOffsets{}));
  profile->noise.rangeSigma = noise;
  for (const Direction& d : directions) {
    Pose pose = Pose::Identity();
    pose.rotate(Eigen::AngleAxisd(d.azimuth, Vec3::UnitZ()));
    pose.rotate(Eigen::AngleAxisd(-d.elevation, Vec3::UnitY()));
    profile->workspace.poses.push_back(pose);
  }
  const Rig rig = simulation(object, profile);
  std::vector<View> views;
  for (int i = 0; i < static_cast<int>(directions.size()); ++i) {
    View view;
    view.image = std::make_shared<const RangeImage>(scanFrom(rig, i, Progress()));
    view.mesh = std::make_shared<const ViewMesh>(triangulate(*view.image, TriangulationOptions()));
    view.T_object_scanner = view.image->T_table_scanner;
    views.push_back(std::move(view));
  }
  return views;
}

std::vector<Direction> around(int count) {
  std::vector<Direction> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) directions.push_back({2.0 * kPi * i / count, 0.0});
  return directions;
}

Model modelOf(const Mesh& mesh) {
  Model model;
  model.mesh = mesh;
  model.confidence.assign(mesh.vertices.size(), 1.0F);
  model.vertexView.assign(mesh.vertices.size(), 0);
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) model.vertexSample.push_back(v);
  model.triangleView.assign(mesh.triangles.size(), 0);
  return model;
}

long eulerCharacteristic(const Mesh& mesh) {
  std::set<std::uint32_t> vertices;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      vertices.insert(t[k]);
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  }
  return static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(mesh.triangles.size());
}

std::size_t countBowTies(const Mesh& mesh) {
  const ModelEditor editor(modelOf(mesh));
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < editor.vertexCount(); ++v) count += isSingleFan(editor, v) ? 0 : 1;
  return count;
}

Height flat(double z) {
  return [z](double, double) { return z; };
}

void expectDisc(const Mesh& mesh) {
  const MeshMeasures m = measure(mesh);
  EXPECT_EQ(m.components, 1U);
  EXPECT_EQ(m.boundaryLoops, 1U);
  EXPECT_EQ(m.nonManifoldEdges, 0U);
  EXPECT_EQ(eulerCharacteristic(mesh), 1);
  EXPECT_EQ(countBowTies(mesh), 0U);
}

}  // namespace vantage::testing
