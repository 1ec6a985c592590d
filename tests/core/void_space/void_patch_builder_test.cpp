#include "void_space/void_patch_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/errors.h"
#include "geometry/ray_caster.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::makePlate;
using testing::makeStep;
using testing::modelOf;
using testing::parallelScanner;
using testing::scanView;

const Vec3 kSphereCentre(0, 0, 50);
constexpr double kSphereRadius = 30.0;

View sphereView() {
  return scanView(testing::makeSphere(kSphereRadius, 180, kSphereCentre), testing::parallelScanner());
}

// Patches of the vertical edges at a place.
std::vector<VoidPatch> patchesAt(const VoidSurface& surface, const Model& model, double x, double y) {
  std::vector<VoidPatch> found;
  for (const VoidPatch& p : surface.patches) {
    const Vec3& a = model.mesh.vertices[p.from];
    const Vec3& b = model.mesh.vertices[p.to];
    const auto there = [&](const Vec3& v) { return std::abs(v.x() - x) < 1e-3 && std::abs(v.y() - y) < 1e-3; };
    if (there(a) && there(b)) found.push_back(p);
  }
  return found;
}

VoidSurface patchesOf(const View& view) {
  return buildVoidPatches(modelOf(view), std::vector<View>{view});
}

TEST(VoidPatches, ClosedModelHasNone) {
  const View view = sphereView();
  Model closed;
  closed.mesh = testing::makeSphere(20, 12);
  closed.confidence.assign(closed.mesh.vertices.size(), 1.0F);
  closed.vertexView.assign(closed.mesh.vertices.size(), 0);
  closed.vertexSample.assign(closed.mesh.vertices.size(), 0);
  closed.triangleView.assign(closed.mesh.triangles.size(), 0);
  const VoidSurface surface = buildVoidPatches(closed, std::vector<View>{view});
  EXPECT_TRUE(surface.patches.empty());
  EXPECT_EQ(surface.bridged, 0U);
}

TEST(VoidPatches, EdgesOfAStepBoundItsShadow) {
  const View view = scanView(makeStep(), parallelScanner());
  const Model model = modelOf(view);
  const VoidSurface surface = buildVoidPatches(model, std::vector<View>{view});

  const std::vector<VoidPatch> outer = patchesAt(surface, model, 20, 0);
  ASSERT_EQ(outer.size(), 60U);
  for (const VoidPatch& p : outer) {
    EXPECT_EQ(p.edgeClass, EdgeClass::OuterJump);
    EXPECT_TRUE(p.normal.isApprox(Vec3(0, 1, 0), 1e-6)) << "toward the light that passed the near plate";
    EXPECT_NEAR(p.centre.x(), 19.5, 1e-3) << "along the ray, behind the near plate";
    EXPECT_FALSE(p.bridged);
  }
  const std::vector<VoidPatch> inner = patchesAt(surface, model, -20, 1);
  ASSERT_EQ(inner.size(), 60U);
  for (const VoidPatch& p : inner) {
    EXPECT_EQ(p.edgeClass, EdgeClass::InnerJump);
    EXPECT_TRUE(p.normal.isApprox(Vec3(0, 1, 0), 1e-6)) << "toward the lit part of the far plate";
    EXPECT_NEAR(p.centre.x(), -19.5, 1e-3) << "along the ray, in front of the far plate";
  }
}

TEST(VoidPatches, RectangleIsAsWideAsTheEdgeAndAsDeepAsTheSpacing) {
  const View view = scanView(makeStep(), parallelScanner());
  const Model model = modelOf(view);
  for (const VoidPatch& p : buildVoidPatches(model, std::vector<View>{view}).patches) {
    const Vec3& from = model.mesh.vertices[p.from];
    const Vec3& to = model.mesh.vertices[p.to];
    EXPECT_EQ(p.corners[0], to);
    EXPECT_EQ(p.corners[1], from);
    EXPECT_NEAR((p.corners[2] - from).norm(), p.depth, 1e-9);
    EXPECT_NEAR((p.corners[2] - from).dot(to - from), 0.0, 1e-9);
    EXPECT_TRUE((p.corners[3] - to).isApprox(p.corners[2] - from, 1e-9));
    EXPECT_TRUE(p.centre.isApprox(0.25 * (p.corners[0] + p.corners[1] + p.corners[2] + p.corners[3]), 1e-9));
    const Vec3 turning = (p.corners[1] - p.corners[0]).cross(p.corners[2] - p.corners[1]).normalized();
    EXPECT_TRUE(turning.isApprox(p.normal, 1e-9)) << "counter-clockwise seen from the free side";
    EXPECT_DOUBLE_EQ(p.width, (to - from).norm());
    EXPECT_NEAR(p.depth, 1.0, 1e-9);
    EXPECT_DOUBLE_EQ(p.weight, p.width * p.depth);
  }
}

TEST(VoidPatches, WeightOfThePaperIsTheAreaOfTheTriangle) {
  const View view = scanView(makeStep(), parallelScanner());
  const Model model = modelOf(view);
  VoidOptions options;
  options.weight = PatchWeight::TriangleArea;
  for (const VoidPatch& p : buildVoidPatches(model, std::vector<View>{view}, options).patches)
    EXPECT_DOUBLE_EQ(p.weight, triangleArea(model.mesh, model.mesh.triangles[p.triangle]));
}

TEST(VoidPatches, CountsAddUp) {
  // Near plate 24 x 60 squares, far plate 23 x 60: vertical ends are 60 edges long, the rest lies on the scanner's rim.
  const VoidSurface surface = patchesOf(scanView(makeStep(), parallelScanner()));
  EXPECT_EQ(surface.count(EdgeClass::OuterJump), 60U);
  EXPECT_EQ(surface.count(EdgeClass::InnerJump), 60U);
  EXPECT_EQ(surface.count(EdgeClass::Regular), 120U);
  EXPECT_EQ(surface.count(EdgeClass::Rim), 2U * (24U + 23U));
  EXPECT_EQ(surface.count(EdgeClass::LineOfSightJump), 0U);
  EXPECT_EQ(surface.bridged, 120U);
  EXPECT_EQ(surface.patches.size(), 334U);
}

TEST(VoidPatches, LimbOfASphereContinuesTheSurface) {
  const View view = sphereView();
  const Model model = modelOf(view);
  const VoidSurface surface = buildVoidPatches(model, std::vector<View>{view});
  ASSERT_GT(surface.patches.size(), 100U);
  double sum = 0.0;
  for (const VoidPatch& p : surface.patches) {
    EXPECT_EQ(p.edgeClass, EdgeClass::Regular);
    const Vec3 middle = 0.5 * (model.mesh.vertices[p.from] + model.mesh.vertices[p.to]);
    const double bend = std::acos(std::min(1.0, p.normal.dot((middle - kSphereCentre).normalized())));
    // The last sample before 60 degrees lies up to a diagonal of the raster inside of the limb, at 54.7 degrees; the
    // patch may bend away as far as 60 there.
    EXPECT_LT(degrees(bend), 12.0);
    sum += bend;
  }
  EXPECT_LT(degrees(sum / static_cast<double>(surface.patches.size())), 5.0);
}

TEST(VoidPatches, LieInFreeSpace) {
  for (const VoidPatch& p : patchesOf(sphereView()).patches)
    for (const Vec3& corner : p.corners)
      EXPECT_GT((corner - kSphereCentre).norm(), kSphereRadius - 0.1) << "a facet's sag and the bend at the limb";

  const RayCaster object(makeStep());
  for (const VoidPatch& p : patchesOf(scanView(makeStep(), parallelScanner())).patches) {
    if (p.edgeClass == EdgeClass::Rim || p.edgeClass == EdgeClass::Regular) continue;
    const Vec3 inFront = p.centre + 0.01 * p.normal;
    EXPECT_FALSE(object.occluded(inFront, inFront + Vec3(200, 0, 0))) << "the light reaches the free side";
    const Vec3 behind = p.centre - 1.01 * p.depth * p.normal;
    EXPECT_TRUE(object.occluded(behind, behind + Vec3(200, 0, 0))) << "the shadow begins within one spacing";
  }
}

// The end y = 10 of a plate at x = 0, seen head-on, and a second view turned by 10 degrees per position.
class TwoViews : public ::testing::Test {
 protected:
  const Mesh plate_ = makePlate(0, -10.5, 10.5);
  const View first_ = scanView(plate_, parallelScanner());
  const Model model_ = modelOf(first_);

  [[nodiscard]] static View blind(const View& view) {
    return testing::without(view, [](const Vec3&) { return true; });
  }
  // The patch half-way up an end of the plate.
  [[nodiscard]] VoidPatch patch(const std::vector<View>& views, double y) const {
    const auto found = patchesAt(buildVoidPatches(model_, views), model_, 0, y);
    EXPECT_EQ(found.size(), 60U);
    return found.at(30);
  }
};

TEST_F(TwoViews, SingleViewBridgesTheWedge) {
  EXPECT_NEAR(degrees(patch({first_}, 10).angle), 240.0, 1e-6);
  EXPECT_TRUE(patch({first_}, 10).bridged);
}

TEST_F(TwoViews, RayThroughFreeSpaceConfirmsTheWedgeAndWidensTheMap) {
  // rho 90 and 130: free up to 240, then up to 130 + 150.
  const VoidPatch merged = patch({first_, blind(scanView(plate_, parallelScanner(), 4))}, 10);
  EXPECT_NEAR(degrees(merged.angle), 280.0, 1e-6);
  EXPECT_FALSE(merged.bridged);
  EXPECT_EQ(merged.edgeClass, EdgeClass::Regular);
  EXPECT_EQ(merged.view, 0U);
}

TEST_F(TwoViews, RayThroughUnknownSpaceIsNotMerged) {
  // rho 100 lies in the wedge from 90 to 120: whether the ray reaches the edge is not known.
  const VoidPatch kept = patch({first_, blind(scanView(plate_, parallelScanner(), 1))}, 10);
  EXPECT_NEAR(degrees(kept.angle), 240.0, 1e-6);
  EXPECT_TRUE(kept.bridged);
}

TEST_F(TwoViews, MergingStopsAtTheFirstRayThroughUnknownSpace) {
  const View inWedge = blind(scanView(plate_, parallelScanner(), 1));
  const View beyond = blind(scanView(plate_, parallelScanner(), 4));
  EXPECT_NEAR(degrees(patch({first_, beyond, inWedge}, 10).angle), 240.0, 1e-6);
}

TEST_F(TwoViews, RayThatMeasuredTheEdgeIsMergedFromAnywhere) {
  // rho 100: free up to 100, then from 130 to 250; with the first view's 120 to 240 a wedge from 100 to 120 is left.
  const VoidPatch merged = patch({first_, scanView(plate_, parallelScanner(), 1)}, 10);
  EXPECT_NEAR(degrees(merged.angle), 250.0, 1e-6);
  EXPECT_TRUE(merged.bridged);
}

TEST_F(TwoViews, RayFromTheOtherSideNarrowsTheWedge) {
  // rho 50 at the end y = -10: free from 80 to 200, which closes the first view's wedge from 90 to 120.
  const VoidPatch merged = patch({first_, blind(scanView(plate_, parallelScanner(), 4))}, -10);
  EXPECT_NEAR(degrees(merged.angle), 240.0, 1e-6);
  EXPECT_FALSE(merged.bridged);
}

TEST(VoidPatches, TurningObjectAndPosesTurnsThePatches) {
  View view = scanView(makeStep(), parallelScanner("[-100, 0, 0]"));
  Model model = modelOf(view);
  const VoidSurface before = buildVoidPatches(model, std::vector<View>{view});
  Pose T = Pose::Identity();
  T.translate(Vec3(12, -7, 3)).rotate(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()));
  view.T_object_scanner = T * view.T_object_scanner;
  model.mesh = transformed(model.mesh, T);
  const VoidSurface after = buildVoidPatches(model, std::vector<View>{view});

  EXPECT_EQ(after.counts, before.counts);
  EXPECT_EQ(after.bridged, before.bridged);
  ASSERT_EQ(after.patches.size(), before.patches.size());
  for (std::size_t i = 0; i < before.patches.size(); ++i) {
    EXPECT_EQ(after.patches[i].edgeClass, before.patches[i].edgeClass);
    EXPECT_NEAR((after.patches[i].centre - T * before.patches[i].centre).norm(), 0.0, 1e-4);
    EXPECT_NEAR((after.patches[i].normal - T.linear() * before.patches[i].normal).norm(), 0.0, 1e-4);
  }
}

TEST(VoidPatches, AnyThreadCountGivesTheSameBytes) {
  const std::vector<View> views{sphereView(),
                                scanView(testing::makeSphere(kSphereRadius, 60, kSphereCentre), parallelScanner(), 3)};
  const Model model = modelOf(views[0]);
  const VoidSurface one = buildVoidPatches(model, views);
  for (const int threads : {2, 5}) {
    const VoidSurface many = buildVoidPatches(model, views, {}, Progress().withThreads(threads));
    ASSERT_EQ(many.patches.size(), one.patches.size());
    for (std::size_t i = 0; i < one.patches.size(); ++i) {
      EXPECT_EQ(many.patches[i].corners, one.patches[i].corners);
      EXPECT_EQ(many.patches[i].normal, one.patches[i].normal);
      EXPECT_EQ(many.patches[i].angle, one.patches[i].angle);
      EXPECT_EQ(many.patches[i].weight, one.patches[i].weight);
      EXPECT_EQ(many.patches[i].edgeClass, one.patches[i].edgeClass);
    }
  }
}

TEST(VoidPatches, SmoothedNormalSparesTheEdgeClassFromASliver) {
  // One vertex beside the near plate's end is pushed forward: its triangles lean, the patches hardly do.
  const View view = scanView(makeStep(), parallelScanner());
  Model model = modelOf(view);
  for (Vec3& v : model.mesh.vertices)
    if ((v - Vec3(20, -1, 50)).norm() < 0.1) v.x() += 0.4;
  const VoidSurface surface = buildVoidPatches(model, std::vector<View>{view});
  EXPECT_EQ(surface.count(EdgeClass::OuterJump), 60U);
  for (const VoidPatch& p : patchesAt(surface, model, 20, 0)) EXPECT_NEAR(p.normal.y(), 1.0, 1e-6);
}

TEST(VoidPatches, EdgeWithoutLengthHasNone) {
  const View view = scanView(makeStep(), parallelScanner());
  Model model = modelOf(view);
  const std::size_t before = buildVoidPatches(model, std::vector<View>{view}).patches.size();
  const VoidPatch some = buildVoidPatches(model, std::vector<View>{view}).patches.front();
  model.mesh.vertices[some.to] = model.mesh.vertices[some.from];
  EXPECT_EQ(buildVoidPatches(model, std::vector<View>{view}).patches.size(), before - 1);
}

TEST(VoidPatches, RefuseTablesThatDoNotFit) {
  const std::vector<View> views{scanView(makeStep(), parallelScanner())};
  const Model good = modelOf(views[0]);
  Model model = good;
  model.vertexSample.pop_back();
  EXPECT_THROW((void)buildVoidPatches(model, views), InvalidInput);
  model = good;
  model.vertexView[3] = 1;
  EXPECT_THROW((void)buildVoidPatches(model, views), InvalidInput);
  model = good;
  model.vertexSample[3] = static_cast<std::uint32_t>(views[0].image->rays->size());
  EXPECT_THROW((void)buildVoidPatches(model, views), InvalidInput);
  model = good;
  model.triangleView.clear();
  EXPECT_THROW((void)buildVoidPatches(model, views), InvalidInput);
  EXPECT_THROW((void)buildVoidPatches(good, std::vector<View>(1)), InvalidInput);
}

TEST(VoidPatches, RefuseABreakdownAngleThatIsNone) {
  const std::vector<View> views{scanView(makeStep(), parallelScanner())};
  for (const double angle : {0.0, -1.0, 0.5 * kPi, std::nan("")}) {
    VoidOptions options;
    options.breakdownAngle = angle;
    EXPECT_THROW((void)buildVoidPatches(modelOf(views[0]), views, options), InvalidInput) << angle;
  }
}

TEST(VoidPatches, StopWhenAsked) {
  const std::vector<View> views{scanView(makeStep(), parallelScanner())};
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)buildVoidPatches(modelOf(views[0]), views, {}, Progress({}, stop.get_token(), 1)), Cancelled);
}

}  // namespace
}  // namespace vantage
