#include "scanner/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "geometry/measures.h"
#include "scanner/ray_patterns.h"

namespace vantage {
namespace {

// Parallel rays along -x from x = 300, 1 mm apart in y and z.
RayGrid parallelRays() {
  return makeRays(LinearStripe{Vec3(300, 0, 150), 40, 41, 41, 40}, {});
}

// The range image of a surface given as the distance along each ray; NaN where there is none.
RangeImage imageOf(const RayGrid& rays, const std::function<double(const RangingRay&)>& distance) {
  RangeImage image;
  image.rays = std::make_shared<const RayGrid>(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) image.range.push_back(static_cast<float>(distance(rays.ray(i))));
  return image;
}

double toPlane(const RangingRay& ray, const Vec3& point, const Vec3& normal) {
  return (point - ray.origin).dot(normal) / ray.direction.dot(normal);
}

double toSphere(const RangingRay& ray, const Vec3& centre, double radius) {
  const Vec3 o = ray.origin - centre;
  const double b = o.dot(ray.direction);
  const double root = b * b - o.squaredNorm() + radius * radius;
  return root < 0.0 ? std::nan("") : -b - std::sqrt(root);
}

RangeImage planeImage(const RayGrid& rays, double leanDegrees) {
  const double lean = radians(leanDegrees);
  return imageOf(rays, [&](const RangingRay& ray) {
    return toPlane(ray, Vec3(0, 0, 150), Vec3(std::cos(lean), std::sin(lean), 0));
  });
}

TEST(Triangulation, APlaneFacingTheScannerBecomesAFullGrid) {
  const ViewMesh view = triangulate(planeImage(parallelRays(), 0.0), {});
  EXPECT_EQ(view.mesh.vertices.size(), 41U * 41U);
  EXPECT_EQ(view.mesh.triangles.size(), 2U * 40U * 40U);
  EXPECT_NEAR(area(view.mesh), 1600.0, 1e-3);
  EXPECT_NEAR(view.spacing, 1.0, 1e-6);
  for (const Vec3& n : view.normals) EXPECT_TRUE(n.isApprox(Vec3(1, 0, 0), 1e-6));
  for (const float c : view.confidence) EXPECT_NEAR(c, 1.0F, 1e-6F);
  EXPECT_EQ(std::count(view.onBoundary.begin(), view.onBoundary.end(), 1), 160);
}

TEST(Triangulation, ConfidenceIsTheCosineOfTheLean) {
  for (const double lean : {20.0, 45.0, 58.0}) {
    const ViewMesh view = triangulate(planeImage(parallelRays(), lean), {});
    ASSERT_FALSE(view.mesh.empty()) << lean;
    for (const float c : view.confidence) EXPECT_NEAR(c, std::cos(radians(lean)), 1e-3);
    EXPECT_NEAR(area(view.mesh), 1600.0 / std::cos(radians(lean)), 0.1);
  }
}

TEST(Triangulation, SteepSurfaceSurvivesUpToTheBreakdownAngleAndNotFarBeyond) {
  EXPECT_EQ(triangulate(planeImage(parallelRays(), 60.0), {}).mesh.triangles.size(), 3200U);
  EXPECT_EQ(triangulate(planeImage(parallelRays(), 69.0), {}).mesh.triangles.size(), 0U);
  const TriangulationOptions shallow{.breakdownAngle = radians(40.0), .angleSlack = radians(2.0)};
  EXPECT_EQ(triangulate(planeImage(parallelRays(), 39.0), shallow).mesh.triangles.size(), 3200U);
  EXPECT_EQ(triangulate(planeImage(parallelRays(), 43.0), shallow).mesh.triangles.size(), 0U);
}

TEST(Triangulation, AStepIsCutAndAShallowOneIsNot) {
  auto stepImage = [](double height) {
    return imageOf(parallelRays(),
                   [&](const RangingRay& ray) { return ray.origin.y() < -0.5 ? 200.0 : 200.0 - height; });
  };
  const MeshMeasures cut = measure(triangulate(stepImage(10.0), {}).mesh);
  EXPECT_EQ(cut.components, 2U);
  EXPECT_EQ(cut.triangles, 2U * 40U * 39U);
  EXPECT_EQ(cut.boundaryLoops, 2U);
  EXPECT_EQ(measure(triangulate(stepImage(1.0), {}).mesh).components, 1U);
}

TEST(Triangulation, ASphereLiesOnItselfAndItsNormalsPointOutward) {
  const Vec3 centre(0, 0, 150);
  const RayGrid rays = makeRays(RotatingStripe{Vec3(300, 0, 150), 150, 150, 200, radians(30)}, {});
  const ViewMesh view =
      triangulate(imageOf(rays, [&](const RangingRay& ray) { return toSphere(ray, centre, 50.0); }), {});
  ASSERT_GT(view.mesh.triangles.size(), 5000U);
  for (std::size_t v = 0; v < view.normals.size(); ++v) {
    const Vec3 outward = (view.mesh.vertices[v] - centre) / 50.0;
    EXPECT_NEAR(outward.norm(), 1.0, 1e-6);
    EXPECT_GT(view.normals[v].dot(outward), 0.99);
    EXPECT_NEAR(view.confidence[v], -outward.dot(rays.ray(view.sample[v]).direction), 0.05);
  }
  const MeshMeasures m = measure(view.mesh);
  EXPECT_EQ(m.nonManifoldEdges, 0U);
  EXPECT_EQ(m.components, 1U);
  // Steeper than the breakdown angle plus slack is gone: a cap of 68 degrees at most.
  for (const Vec3& p : view.mesh.vertices)
    EXPECT_GT((p - centre).normalized().x(), std::cos(radians(60.0 + 8.0 + 12.0)));
}

// The same rays with rows or columns reversed, or rows and columns exchanged.
RayGrid reordered(const RayGrid& rays, bool flipRows, bool flipColumns, bool transpose) {
  std::vector<RangingRay> result;
  const int rows = transpose ? rays.columns() : rays.rows();
  const int columns = transpose ? rays.rows() : rays.columns();
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      int r = transpose ? j : i;
      int c = transpose ? i : j;
      if (flipRows) r = rays.rows() - 1 - r;
      if (flipColumns) c = rays.columns() - 1 - c;
      result.push_back(rays.ray(rays.index(r, c)));
    }
  }
  return {rows, columns, std::move(result), {}, 0};
}

TEST(Triangulation, FacesTheScannerWhateverTheOrderOfTheGrid) {
  const std::vector<RayGrid> grids{
      parallelRays(), makeRays(RotatingStripe{Vec3(300, 0, 150), 100, 30, 40, radians(20)}, {}),
      makeRays(Pinhole{Vec3(300, 0, 250), Vec3(0, 0, 150), 30, 40, radians(20), radians(20)}, {})};
  for (const RayGrid& grid : grids) {
    const std::size_t expected = triangulate(planeImage(grid, 10.0), {}).mesh.triangles.size();
    EXPECT_GT(expected, 1000U);
    for (int order = 0; order < 8; ++order) {
      const RayGrid rays = reordered(grid, (order & 1) != 0, (order & 2) != 0, (order & 4) != 0);
      const ViewMesh view = triangulate(planeImage(rays, 10.0), {});
      EXPECT_EQ(view.mesh.triangles.size(), expected) << "order " << order;
      for (const Triangle& t : view.mesh.triangles)
        ASSERT_GT(triangleNormal(view.mesh, t).x(), 0.9) << "order " << order;
    }
  }
}

TEST(Triangulation, RaysThatCrossInFrontOfTheSurfaceStillGiveItsFront) {
  std::vector<RangingRay> rays;  // all through the point (200, 0, 150)
  for (int r = 0; r < 20; ++r)
    for (int c = 0; c < 20; ++c) {
      const Vec3 origin(300, c - 9.5, 140.5 + r);
      rays.push_back({origin, (Vec3(200, 0, 150) - origin).normalized()});
    }
  const ViewMesh view = triangulate(planeImage(RayGrid(20, 20, std::move(rays), {}, 0), 0.0), {});
  EXPECT_EQ(view.mesh.triangles.size(), 2U * 19U * 19U);
  for (const Triangle& t : view.mesh.triangles) EXPECT_GT(triangleNormal(view.mesh, t).x(), 0.99);
}

TEST(Triangulation, AMissingSampleTakesOnlyItsTriangles) {
  RangeImage image = planeImage(parallelRays(), 0.0);
  const std::size_t hole = image.rays->index(20, 20);
  image.range[hole] = kNoSample;
  const ViewMesh view = triangulate(image, {});
  // Of its four squares one triangle each survives, cut along the other diagonal.
  EXPECT_EQ(view.mesh.triangles.size(), 3200U - 4U);
  EXPECT_EQ(view.vertexOfSample[hole], kNoIndex);
  EXPECT_EQ(measure(view.mesh).boundaryLoops, 2U);
}

TEST(Triangulation, SamplesAndVerticesNameEachOther) {
  RangeImage image = planeImage(parallelRays(), 30.0);
  for (std::size_t i = 0; i < image.range.size(); i += 3) image.range[i] = kNoSample;
  const ViewMesh view = triangulate(image, {});
  ASSERT_FALSE(view.mesh.empty());
  std::size_t used = 0;
  for (std::size_t i = 0; i < view.vertexOfSample.size(); ++i) {
    if (view.vertexOfSample[i] == kNoIndex) continue;
    ++used;
    EXPECT_EQ(view.sample[view.vertexOfSample[i]], i);
    EXPECT_EQ(view.mesh.vertices[view.vertexOfSample[i]], image.point(i));
  }
  EXPECT_EQ(used, view.mesh.vertices.size());
  for (const auto* values : {&view.sample}) EXPECT_TRUE(std::is_sorted(values->begin(), values->end()));
}

TEST(Triangulation, NothingMeasuredIsAnEmptyMesh) {
  const ViewMesh view = triangulate(imageOf(parallelRays(), [](const RangingRay&) { return std::nan(""); }), {});
  EXPECT_TRUE(view.mesh.empty());
  EXPECT_TRUE(view.mesh.vertices.empty());
  EXPECT_EQ(view.spacing, 0.0);
}

TEST(Triangulation, RefusesARangeImageThatIsNone) {
  EXPECT_THROW(static_cast<void>(triangulate(RangeImage{}, {})), InvalidInput);
}

}  // namespace
}  // namespace vantage
