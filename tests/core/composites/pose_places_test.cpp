#include "composites/pose_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>

#include "base/errors.h"
#include "composites/pose_evidence.h"
#include "composites/ray_witness.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

const testing::TwoStands& stands() {
  return testing::oddBodyInTwoStands();
}

AlignmentLimits limits() {
  return limitsOf(stands().reference.scale(), stands().moved.scale());
}

PosePlaces at(const Pose& T) {
  return placesAt(stands().reference, stands().moved, T, limits());
}

// Of the points that evidence is counted on.
double share(const PosePlaces& places, PlaceWord word) {
  std::size_t found = 0;
  std::size_t all = 0;
  const auto count = [&](const CompositeModel& model, const std::vector<PlaceWord>& words) {
    for (const std::uint32_t point : model.points(PointLevel::Fine)) found += words[point] == word ? 1 : 0;
    all += model.points(PointLevel::Fine).size();
  };
  count(stands().reference, places.reference);
  count(stands().moved, places.moved);
  return static_cast<double>(found) / static_cast<double>(all);
}

TEST(PosePlaces, HaveAWordForEveryVertexOfBothModels) {
  const PosePlaces places = at(stands().T_reference_moved);
  EXPECT_EQ(places.reference.size(), stands().reference.composite().model->mesh.vertices.size());
  EXPECT_EQ(places.moved.size(), stands().moved.composite().model->mesh.vertices.size());
}

// What is painted is what was counted: contradictions to the last point, the overlap but for what lies
// on a border of the other, which the evidence leaves out.
TEST(PosePlaces, AreWhatTheEvidenceCounts) {
  for (const Vec3& off : {Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(0, 0, -15)}) {
    Pose T = stands().T_reference_moved;
    T.pretranslate(off);
    const PosePlaces places = at(T);
    const PoseEvidence evidence = evidenceOf(stands().reference, stands().moved, T, limits());
    EXPECT_DOUBLE_EQ(share(places, PlaceWord::Conflict), evidence.conflict) << off.transpose();
    EXPECT_DOUBLE_EQ(share(places, PlaceWord::Table), evidence.table) << off.transpose();
    EXPECT_DOUBLE_EQ(share(places, PlaceWord::Missing), evidence.missing) << off.transpose();
    EXPECT_NEAR(share(places, PlaceWord::OnIt), evidence.overlap, 0.1) << off.transpose();
  }
}

TEST(PosePlaces, TheTruthIsInCommonAndWhatIsAsideIsContradicted) {
  EXPECT_GT(share(at(stands().T_reference_moved), PlaceWord::OnIt), 0.3);
  Pose aside = stands().T_reference_moved;
  aside.pretranslate(Vec3(9, 0, 0));
  EXPECT_GT(share(at(aside), PlaceWord::Conflict), 0.05);
  EXPECT_LT(share(at(aside), PlaceWord::OnIt), share(at(stands().T_reference_moved), PlaceWord::OnIt));
}

TEST(PosePlaces, AreTheSameForAnyNumberOfThreadsAndStop) {
  Pose aside = stands().T_reference_moved;
  aside.pretranslate(Vec3(4, 3, 1));
  const PosePlaces one = at(aside);
  const PosePlaces four = placesAt(stands().reference, stands().moved, aside, limits(), Progress().withThreads(4));
  EXPECT_EQ(one.reference, four.reference);
  EXPECT_EQ(one.moved, four.moved);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(
                   placesAt(stands().reference, stands().moved, aside, limits(), Progress({}, source.get_token(), 2))),
               Cancelled);
}

// A thin wall moved by its thickness: its back comes to lie where its front was, and faces the other way.
TEST(RayWitness, SurfaceThatFacesTheOtherWayDoesNotAgree) {
  const Mesh thin = testing::makeBox(Vec3(-25, -1.5, 0), Vec3(25, 1.5, 60), 12);
  const CompositeModel wall(testing::acquireStand(thin, Pose::Identity(), 8));
  Pose aside = Pose::Identity();
  aside.translate(Vec3(0, 3, 0));
  const AlignmentLimits wallLimits = limitsOf(wall.scale(), wall.scale());
  const RayWitness same(wall, wall, Pose::Identity(), wallLimits);
  RayWitness moved(wall, wall, aside, wallLimits);
  std::size_t backs = 0;
  for (const std::uint32_t point : wall.points(PointLevel::Coarse)) {
    if (wall.surface().normal(point).y() > -0.9) continue;
    ++backs;
    EXPECT_TRUE(same.agrees(point, wallLimits.sampleGate()));
    EXPECT_FALSE(moved.agrees(point, wallLimits.sampleGate()));
    EXPECT_EQ(moved.ask(point), PlaceWord::OnIt);
  }
  EXPECT_GT(backs, 20U);
}

}  // namespace
}  // namespace vantage
