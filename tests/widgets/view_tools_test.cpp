// The tools of the model view without a picture: parallel projection, cut, measuring.
#include <gtest/gtest.h>

#include <numbers>

#include "measuring/plane_section.h"
#include "scenes/model_scene.h"
#include "scenes/tool_notes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

constexpr QSizeF kPicture(800.0, 600.0);

Camera onto(double distance) {
  Camera camera;
  camera.eye = {distance, 0.0, 0.0};
  camera.parallel = true;
  return camera;
}

// How far a line passes the point, across the line.
double passes(const SightLine& line, const Vec3& point) {
  return (point - line.origin).cross(line.direction).norm();
}

TEST(ParallelProjection, LinesAreParallelAndAsFarApartAtTheTargetAsInPerspective) {
  const Camera parallel = onto(200.0);
  Camera perspective = parallel;
  perspective.parallel = false;
  for (const QPointF& point : {QPointF(400, 300), QPointF(0, 0), QPointF(650, 480)}) {
    const SightLine line = sightLine(parallel, point, kPicture);
    EXPECT_LT((line.direction - parallel.forward()).norm(), 1e-12);
    const SightLine other = sightLine(perspective, point, kPicture);
    const Vec3 atTarget = other.origin - other.origin.x() / other.direction.x() * other.direction;
    EXPECT_LT(passes(line, atTarget), 1e-6);
  }
}

TEST(ParallelProjection, LinesBeginBeforeWhatIsNearerThanTheEye) {
  const Camera near = onto(10.0);
  EXPECT_GT(sightLine(near, {400, 300}, kPicture).origin.x(), 1000.0);
}

TEST(Section, TakesAwayWhatIsBeforeItsPlane) {
  Section section{2, 5.0, false};
  EXPECT_TRUE(section.hides({0, 0, 5.1}));
  EXPECT_FALSE(section.hides({0, 0, 4.9}));
  section.flipped = true;
  EXPECT_FALSE(section.hides({0, 0, 5.1}));
  EXPECT_TRUE(section.hides({0, 0, 4.9}));
  EXPECT_DOUBLE_EQ(section.inside({{-1, -1, -1}, {1, 1, 1}}).at, 1.0);
}

// A ball of radius 10 about the origin.
class CutModel : public ::testing::Test {
 protected:
  CutModel() {
    auto model = std::make_shared<Model>();
    model->mesh = testing::makeSphere(10.0, 48);
    scene_.set(nullptr, prepareModelGeometry(model));
  }
  void cut(const std::optional<Section>& section) {
    ModelViewOptions options = scene_.options();
    options.section = section;
    scene_.setOptions(options);
  }
  [[nodiscard]] Vec3 pickedFromAbove() const {
    const auto pick = scene_.pick({Vec3(2, 0, 500), -Vec3::UnitZ()});
    return pick ? pick->point : Vec3(0, 0, 1e9);
  }

  ModelScene scene_;
};

TEST_F(CutModel, IsPickedWhereItIsShown) {
  const double top = std::sqrt(100.0 - 4.0);
  EXPECT_NEAR(pickedFromAbove().z(), top, 0.1);
  cut(Section{2, 0.0, false});
  EXPECT_NEAR(pickedFromAbove().z(), -top, 0.1) << "through what is cut away";
  cut(Section{2, 0.0, true});
  EXPECT_NEAR(pickedFromAbove().z(), top, 0.1);
  cut(Section{0, 0.0, false});
  EXPECT_EQ(pickedFromAbove().z(), 1e9) << "nothing is left there";
  cut({});
  EXPECT_NEAR(pickedFromAbove().z(), top, 0.1);
}

TEST_F(CutModel, TheOutlineIsTheCircleThatItIs) {
  const PlaneSection outline = sectionOf(scene_.geometry()->model->mesh, Section{2, 6.0, false}.plane());
  ASSERT_TRUE(outline.area);
  EXPECT_NEAR(outline.length, 2.0 * std::numbers::pi * 8.0, 0.3);
  EXPECT_NEAR(*outline.area, std::numbers::pi * 64.0, 2.0);
  // The other side of the same plane has the same outline.
  const PlaneSection other = sectionOf(scene_.geometry()->model->mesh, Section{2, 6.0, true}.plane());
  EXPECT_NEAR(other.length, outline.length, 1e-6);
  EXPECT_NEAR(other.area.value(), *outline.area, 1e-6);
}

TEST(ToolNotes, SayEveryToolThatIsOn) {
  ModelViewOptions options;
  ViewTools tools;
  EXPECT_TRUE(toolNotes(options, tools).isEmpty());
  options.section = Section{0, 12.0, false};
  options.style = SurfaceStyle::Wireframe;
  options.backFaces = true;
  tools.parallel = true;
  tools.section = PlaneSection{{SectionLine{}}, 25.13, 50.27};
  const QStringList expected{"Clipped: shown is what has x ≤ 12.0 mm",
                             "The outline is closed, 25.1 mm long, and encloses 50.3 mm².", "As a wireframe",
                             "Back faces are red", "In parallel projection"};
  EXPECT_EQ(toolNotes(options, tools).join('\n').toStdString(), expected.join('\n').toStdString());
}

TEST(ToolNotes, AnOutlineThatIsOpenHasNoArea) {
  EXPECT_EQ(sectionText({{SectionLine{}}, 10.0, {}}).toStdString(), "The outline is open, 10.0 mm long.");
  EXPECT_EQ(sectionText({}).toStdString(), "The plane cuts nothing.");
  EXPECT_EQ(sectionPlaceText({1, -3.3, true}).toStdString(), "y ≥ -3.3 mm");
}

TEST(ToolNotes, ADistanceIsSaidWithItsParts) {
  EXPECT_EQ(distanceText({1, 2, 3}, {4, -2, 15}).toStdString(), "13.00 mm (along x 3.00, y 4.00, z 12.00)");
  ViewTools tools;
  tools.measuring = true;
  EXPECT_TRUE(toolNotes({}, tools).front().startsWith("Place 1: click the surface"));
  tools.measured = {{0, 0, 0}};
  EXPECT_TRUE(toolNotes({}, tools).front().startsWith("Place 2: click the surface"));
  tools.measured.emplace_back(0, 0, 5);
  EXPECT_EQ(toolNotes({}, tools).front().toStdString(), "1 to 2: 5.00 mm (along x 0.00, y 0.00, z 5.00)");
}

}  // namespace
}  // namespace vantage
