#include "composites/joint_refinement.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "scenes.h"

namespace vantage {
namespace {

// The views of a composite, each off by a little.
CompositeModel bent(const CompositeModel& straight, unsigned seed) {
  std::vector<Pose> poses;
  Random random(seed);
  for (const View& view : straight.composite().views) {
    poses.push_back(view.T_object_scanner);
    if (poses.size() < 2) continue;
    Vec6 x;
    for (int k = 0; k < 6; ++k) x[k] = (k < 3 ? 0.002 : 0.15) * random.normal();
    poses.back() = motionAbout(straight.centroid(), x) * poses.back();
  }
  return straight.withPoses(poses);
}

TEST(JointRefinement, StraightensACompositeThatWasBent) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  const CompositeModel moved = bent(stands.moved, 3);
  const JointRefinement refined = refineTogether(stands.reference, moved, stands.T_reference_moved, {});
  EXPECT_GT(refined.movedBend, 0.1);
  EXPECT_LT(refined.referenceBend, 0.5 * refined.movedBend);
  EXPECT_TRUE(refined.reference[0].matrix() == stands.reference.composite().views[0].T_object_scanner.matrix());
  double before = 0.0;
  double after = 0.0;
  for (std::size_t v = 0; v < refined.moved.size(); ++v) {
    const Pose truth = stands.T_reference_moved * stands.moved.composite().views[v].T_object_scanner;
    const Pose start = stands.T_reference_moved * moved.composite().views[v].T_object_scanner;
    const OrientedVertices& points = stands.moved.prepared()[v].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& p = points.pointAt(i);
      before += (start * p - truth * p).squaredNorm();
      after += (refined.moved[v] * p - truth * p).squaredNorm();
    }
  }
  EXPECT_LT(after, 0.1 * before);
}

TEST(JointRefinement, TellsOfTiesThatAreStretched) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  const double right = refineTogether(stands.reference, stands.moved, stands.T_reference_moved, {}).tension;
  EXPECT_LT(right, 3.0);
  Composite composite = stands.moved.composite();
  composite.ties[3].T_from_to.pretranslate(Vec3(0, 0, 0.8));
  const double stretched =
      refineTogether(stands.reference, CompositeModel(composite), stands.T_reference_moved, {}).tension;
  EXPECT_GT(stretched, right + 3.0);
}

TEST(JointRefinement, ATieMovesWithItsComposite) {
  PoseTie tie{0, 1, Pose(Eigen::Translation3d(1, 2, 3)), turntablePrior({radians(0.3), 0.3})};
  tie.prior.centre = Vec3(5, 6, 7);
  Pose T = Pose::Identity();
  T.rotate(Eigen::AngleAxisd(1.0, Vec3(1, 2, -1).normalized())).pretranslate(Vec3(10, 20, 30));
  const PoseTie moved = movedTie(tie, T);
  EXPECT_TRUE(moved.T_from_to.isApprox(tie.T_from_to));
  // A small motion costs the same before and after, said in either's coordinates.
  Vec6 x;
  x << 0.001, -0.002, 0.003, 0.1, 0.2, -0.1;
  const Pose motion = motionAbout(tie.prior.centre, x);
  const Vec6 y = motionVector(T * motion * T.inverse(), moved.prior.centre);
  EXPECT_NEAR(y.dot(moved.prior.information * y), x.dot(tie.prior.information * x), 1e-6);
}

}  // namespace
}  // namespace vantage
