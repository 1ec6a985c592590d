#include "report/evaluation.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

EvaluationOptions fewSamples() {
  EvaluationOptions options;
  options.samples = 4000;
  return options;
}

TEST(Evaluation, FindsTheObjectItselfCompleteAndExact) {
  const Mesh object = testing::smallObject();
  const Evaluation e = evaluate(object, object, *testing::smallProfile(), fewSamples(), Progress());
  EXPECT_GT(e.scannableShare, 0.5);
  EXPECT_LT(e.scannableShare, 1.0);  // the undersides look down
  EXPECT_EQ(e.coverage, 1.0);
  EXPECT_LT(e.rms, 1e-4);
  EXPECT_EQ(e.falseSurface, 0.0);
}

TEST(Evaluation, MissesTheHalfThatIsNotThere) {
  const Mesh object = testing::makeSphere(40, 40, {0, 0, 50});
  Mesh half = object;
  std::erase_if(half.triangles, [&](const Triangle& t) { return triangleCentre(object, t).y() < 0.0; });
  const Evaluation e = evaluate(half, object, *testing::smallProfile(), fewSamples(), Progress());
  EXPECT_NEAR(e.coverage, 0.5, 0.03);
}

TEST(Evaluation, CountsSurfaceThatTheObjectDoesNotHave) {
  const Mesh object = testing::makeSphere(40, 40, {0, 0, 50});
  const Mesh extra = testing::makeSphere(20, 20, {70, 0, 50});  // a quarter of the object's area, 10 mm away from it
  const Evaluation e =
      evaluate(testing::joined(object, extra), object, *testing::smallProfile(), fewSamples(), Progress());
  EXPECT_NEAR(e.falseSurface, 0.2, 0.02);
}

TEST(Evaluation, NeedsTriangles) {
  EXPECT_THROW(static_cast<void>(evaluate(Mesh{}, testing::smallObject(), *testing::smallProfile(), {}, Progress())),
               InvalidInput);
}

}  // namespace
}  // namespace vantage
