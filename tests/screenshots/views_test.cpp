#include <gtest/gtest.h>

#include <QApplication>
#include <QDeadlineTimer>

#include "acquisition/steps.h"
#include "layers/positional_links.h"
#include "look/legend.h"
#include "osmesa/osmesa_window.h"
#include "screenshots/mug_session.h"
#include "screenshots/screenshot.h"
#include "views/model_view.h"
#include "views/objective_view.h"
#include "views/positional_space_view.h"
#include "views/scanner_picture_view.h"
#include "views/threaded_surface.h"
#include "views/unrolled_map_view.h"

namespace vantage::testing {
namespace {

constexpr QSize kSize(420, 320);
constexpr QSize kWide(520, 260);

const Theme& themeNamed(const std::string& name) {
  return name == "dark" ? darkTheme() : lightTheme();
}

// Both themes of every state.
class Views : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] const Theme& theme() const { return themeNamed(GetParam()); }
  [[nodiscard]] std::string named(const std::string& state) const { return state + "_" + GetParam(); }

  [[nodiscard]] QImage model(const SharedSnapshot& snapshot, const ModelViewOptions& options,
                             CameraPreset preset = CameraPreset::Oblique) const {
    ModelView view(testSurfaces());
    view.resize(kSize);
    view.setTheme(theme());
    view.setOptions(options);
    view.setSnapshot(snapshot);
    view.finishLoading();
    view.lookFrom(preset);
    return grab(view, kSize);
  }

  [[nodiscard]] QImage positional(const PositionalViewOptions& options) const {
    PositionalSpaceView view(testSurfaces());
    view.resize(kSize);
    view.setTheme(theme());
    view.setOptions(options);
    view.setSnapshot(mugUnderWay());
    view.finishLoading();
    return grab(view, kSize);
  }

  [[nodiscard]] QImage unrolled(const PositionalViewOptions& options) const {
    UnrolledMapView view;
    view.setTheme(theme());
    view.setOptions(options);
    view.setSnapshot(mugUnderWay());
    view.pointAt(MapCell{6, 20});
    return grab(view, kWide);
  }

  [[nodiscard]] QImage objective(const SharedSnapshot& snapshot, ObjectiveStyle style, const QSize& size) const {
    ObjectiveView view;
    view.setTheme(theme());
    view.setSnapshot(snapshot);
    view.setChartStyle(style);
    return grab(view, size);
  }

  // The title, in the corner where every view has it.
  void expectTitle(const QImage& image, const QString& title) const {
    EXPECT_TRUE(showsText(image.copy(0, 0, image.width(), 40), title, theme().text, 12.0, true));
  }
  void expectLegend(const QImage& image, const QString& text, bool bold) const {
    EXPECT_TRUE(showsText(image, text, theme().text, 12.0, bold));
  }
};

TEST_P(Views, ModelPlainWithVoidByEdgeClass) {
  const QImage image = model(mugUnderWay(), {});
  EXPECT_TRUE(isNotBlank(image));
  expectTitle(image, "Model after 3 views");
  expectLegend(image, "Unseen edges by kind", true);
  EXPECT_TRUE(showsColour(image, theme().boundary, 0.0005, 40));
  EXPECT_TRUE(matchesBaseline(image, named("model_plain")));
}

TEST_P(Views, ModelByConfidence) {
  const QImage image = model(mugUnderWay(), {.colouring = ModelColouring::Confidence, .voidPatches = false});
  expectLegend(image, "Confidence", true);
  EXPECT_TRUE(showsColour(image, toColour(colourAt(ColourMap::Cividis, 0.9)), 0.002, 60));
  EXPECT_TRUE(matchesBaseline(image, named("model_confidence")));
}

TEST_P(Views, ModelByView) {
  const QImage image = model(mugFinished(), {.colouring = ModelColouring::View, .voidPatches = false});
  expectLegend(image, "Surface by view", true);
  EXPECT_TRUE(showsColour(image, toColour(categoryColour(1)), 0.0008, 60));
  EXPECT_TRUE(matchesBaseline(image, named("model_view")));
}

TEST_P(Views, ModelByAge) {
  const QImage image = model(mugFinished(), {.colouring = ModelColouring::Age, .voidPatches = false});
  expectLegend(image, "Surface by age", true);
  EXPECT_TRUE(matchesBaseline(image, named("model_age")));
}

// By themselves, and not where something else is asked for.
TEST_P(Views, ModelInTheColoursOfItsScans) {
  const QImage image = model(paintedMug(), {.voidPatches = false});
  EXPECT_TRUE(showsColour(image, QColor(120, 90, 200), 0.005, 60));
  EXPECT_FALSE(showsText(image, "no colour was measured", theme().text));
  EXPECT_TRUE(isSamePicture(image, model(paintedMug(), {.colouring = ModelColouring::Colours, .voidPatches = false})));
  EXPECT_TRUE(isSamePicture(model(paintedMug(), {.colouring = ModelColouring::Plain, .voidPatches = false}),
                            model(mugFinished(), {.voidPatches = false})));
  EXPECT_TRUE(matchesBaseline(image, named("model_colours")));
}

TEST_P(Views, ModelOfWhichSomeScansSawNoColours) {
  const QImage image = model(paintedMug(8), {.voidPatches = false});
  expectLegend(image, "Surface in its colours", true);
  expectLegend(image, "no colour was measured", false);
  EXPECT_TRUE(matchesBaseline(image, named("model_colours_mixed")));
}

TEST_P(Views, VoidByStateAtTheEndTellsReasons) {
  const QImage image = model(mugFinished(), {.voidColouring = VoidColouring::State, .turntable = false});
  expectLegend(image, "Unseen edges by state", true);
  EXPECT_TRUE(matchesBaseline(image, named("void_state")));
}

TEST_P(Views, RangingRaysOfTheLastAndTheProposedView) {
  const QImage image =
      model(mugUnderWay(), {.voidPatches = false, .currentRays = true, .proposedRays = true}, CameraPreset::Top);
  expectLegend(image, "Ranging rays", true);
  EXPECT_TRUE(showsColour(image, theme().current, 0.0004, 60));
  EXPECT_TRUE(showsColour(image, theme().proposed, 0.0004, 60));
  EXPECT_TRUE(matchesBaseline(image, named("model_rays")));
}

TEST_P(Views, ModelFromTheFrontWithoutTurntable) {
  const QImage image = model(mugFinished(), {.voidPatches = false, .turntable = false}, CameraPreset::Front);
  EXPECT_TRUE(showsColour(image, theme().surface, 0.01, 40));
  EXPECT_TRUE(matchesBaseline(image, named("model_front")));
}

TEST_P(Views, ModelThroughTheScannersEye) {
  const QImage image = model(mugUnderWay(), {}, CameraPreset::ScannersEye);
  EXPECT_TRUE(isNotBlank(image));
  EXPECT_TRUE(matchesBaseline(image, named("model_eye")));
}

TEST_P(Views, NoViewYet) {
  const auto state = std::make_shared<AcquisitionState>();
  state->profile = mugUnderWay()->state->profile;
  const QImage image = model(makeSnapshot(state), {});
  expectTitle(image, "Before the first scan");
  EXPECT_TRUE(showsColour(image, theme().table, 0.1));
  EXPECT_TRUE(matchesBaseline(image, named("model_empty")));
}

TEST_P(Views, PositionalSpaceOfTheVoid) {
  const QImage image = positional({});
  expectTitle(image, "P_v: void");
  expectLegend(image, "Per cell", true);
  EXPECT_TRUE(showsColour(image, toColour(colourAt(ColourMap::Viridis, 0.0)), 0.02, 30));
  EXPECT_TRUE(matchesBaseline(image, named("ps_void")));
}

TEST_P(Views, PositionalSpaceOfTheSeen) {
  const QImage image = positional({.kind = PositionalImageKind::Seen});
  expectTitle(image, "P_s: surface already seen");
  EXPECT_TRUE(matchesBaseline(image, named("ps_seen")));
}

TEST_P(Views, PositionalSpaceOfTheScanner) {
  const int proposed = mugUnderWay()->proposed().value();
  const QImage image = positional({.kind = PositionalImageKind::Scanner, .position = proposed});
  expectTitle(image, QString("P_c: rays of position %1").arg(proposed));
  EXPECT_TRUE(matchesBaseline(image, named("ps_scanner")));
}

TEST_P(Views, PositionalSpaceInOneDirection) {
  const QImage image = positional({.direction = DirectionWindow{0.1, 0.0, 0.1}});
  EXPECT_TRUE(matchesBaseline(image, named("ps_direction")));
}

TEST_P(Views, UnrolledMapOfTheVoid) {
  const QImage image = unrolled({});
  expectTitle(image, "P_v: void");
  EXPECT_TRUE(showsText(image, "180°", theme().mutedText, 11.0));
  EXPECT_TRUE(matchesBaseline(image, named("map_void")));
}

TEST_P(Views, UnrolledMapOfTheSeen) {
  const QImage image = unrolled({.kind = PositionalImageKind::Seen});
  expectTitle(image, "P_s: surface already seen");
  EXPECT_TRUE(matchesBaseline(image, named("map_seen")));
}

TEST_P(Views, UnrolledMapOfTheScanner) {
  const QImage image = unrolled({.kind = PositionalImageKind::Scanner});
  expectTitle(image, "P_c: rays of all positions");
  EXPECT_TRUE(matchesBaseline(image, named("map_scanner")));
}

TEST_P(Views, ObjectiveAsADial) {
  const QImage image = objective(mugUnderWay(), ObjectiveStyle::Dial, kSize);
  expectTitle(image, QString("Next best view: position %1").arg(mugUnderWay()->proposed().value()));
  EXPECT_TRUE(showsText(image, "o_s: overlap", theme().text, 11.0));
  EXPECT_TRUE(showsColour(image, toColour(categoryColour(1)), 0.001));
  EXPECT_TRUE(showsColour(image, theme().threshold, 0.0005, 60));
  EXPECT_TRUE(matchesBaseline(image, named("objective_dial")));
}

TEST_P(Views, ObjectiveAsBars) {
  const QImage image = objective(mugUnderWay(), ObjectiveStyle::Bars, kWide);
  EXPECT_TRUE(showsText(image, "void mm²", theme().mutedText, 10.0));
  EXPECT_TRUE(matchesBaseline(image, named("objective_bars")));
}

TEST_P(Views, ObjectiveAtTheEnd) {
  const QImage image = objective(mugFinished(), ObjectiveStyle::Dial, kSize);
  expectTitle(image, "No next view");
  EXPECT_TRUE(matchesBaseline(image, named("objective_end")));
}

TEST_P(Views, PictureOfTheScanner) {
  const SharedSnapshot snapshot = mugUnderWay();
  ScannerPictureView view;
  view.setTheme(theme());
  const PlanningScene scene(planInputOf(*snapshot->state), snapshot->plan->voids,
                            stepOptionsFor(*snapshot->state).planner, {});
  view.setPicture(
      std::make_shared<const ScannerPicture>(computeScannerPicture(scene, snapshot->proposed().value(), {})),
      "What the scanner would see");
  const QImage image = grab(view, kSize);
  expectTitle(image, "What the scanner would see");
  EXPECT_TRUE(showsColour(image, toColour(categoryColour(1)), 0.001));
  EXPECT_TRUE(matchesBaseline(image, named("scanner_picture")));
}

TEST_P(Views, ViewsWithNothingToShowSaySo) {
  ObjectiveView dial;
  dial.setTheme(theme());
  EXPECT_TRUE(showsText(grab(dial, kSize), "No plan yet", theme().mutedText, 13.0));
  UnrolledMapView map;
  map.setTheme(theme());
  EXPECT_TRUE(showsText(grab(map, kSize), "No plan yet", theme().mutedText, 13.0));
}

INSTANTIATE_TEST_SUITE_P(Themes, Views, ::testing::Values("light", "dark"),
                         [](const auto& suite) { return suite.param; });

TEST(Pictures, StayTheSameOverTwentyRepeats) {
  ModelView first(testSurfaces());
  first.setSnapshot(mugUnderWay());
  first.finishLoading();
  const QImage expected = grab(first, kSize);
  for (int repeat = 0; repeat < 20; ++repeat) {
    ModelView view(testSurfaces());
    view.setSnapshot(mugUnderWay());
    view.finishLoading();
    ASSERT_TRUE(isSamePicture(grab(view, kSize), expected)) << "repeat " << repeat;
  }
}

TEST(Pictures, SeveralViewsAtOnceDoNotDisturbEachOther) {
  ModelView alone(testSurfaces());
  alone.setSnapshot(mugUnderWay());
  alone.finishLoading();
  const QImage expected = grab(alone, kSize);
  PositionalSpaceView other(testSurfaces());
  other.setSnapshot(mugUnderWay());
  other.finishLoading();
  const QImage otherFirst = grab(other, kSize);
  EXPECT_TRUE(isSamePicture(grab(alone, kSize), expected));
  EXPECT_TRUE(isSamePicture(grab(other, kSize), otherFirst));
}

// A picture of a view, however long it takes to draw.
QImage taken(ModelView& view) {
  QImage image;
  view.takePictures({CameraPreset::Front}, [&](const std::vector<QImage>& pictures) { image = pictures.front(); });
  const QDeadlineTimer patience(20000);
  while (image.isNull() && !patience.hasExpired()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 100);
  return image;
}

TEST(Pictures, DrawnOnAThreadOfItsOwnTheyAreTheSame) {
  ModelView here(testSurfaces());
  ModelView beside(threadedSurfaces(std::make_shared<RenderThread>(), osmesaWindows()));
  for (ModelView* view : {&here, &beside}) {
    view->resize(kSize);
    view->setSnapshot(mugUnderWay());
    view->finishLoading();
    QApplication::sendPostedEvents();
  }
  EXPECT_TRUE(isSamePicture(taken(beside), taken(here)));
}

TEST(Pictures, ViewsMayBeChangedAndClosedWhileTheyAreDrawn) {
  const auto thread = std::make_shared<RenderThread>();
  for (int round = 0; round < 10; ++round) {
    ModelView view(threadedSurfaces(thread, osmesaWindows()));
    view.setVisible(true);
    for (int i = 0; i < 3 * round; ++i) {
      view.setSnapshot(i % 3 == 0 ? mugFinished() : mugUnderWay());
      view.setTheme(i % 2 == 0 ? darkTheme() : lightTheme());
      view.setOptions({.colouring = static_cast<ModelColouring>(i % 4), .voidPatches = i % 2 == 0});
      view.highlight({0, 1, 2});
      view.examine(i);
      view.lookFrom(i % 2 == 0 ? CameraPreset::Top : CameraPreset::Front);
      view.resize(200 + 20 * i, 300 - 5 * i);
      QCoreApplication::processEvents();
    }
  }
}

TEST(Pictures, ResizingAndBackGivesTheSamePicture) {
  ModelView view(testSurfaces());
  view.setSnapshot(mugUnderWay());
  view.finishLoading();
  const QImage expected = grab(view, kSize);
  EXPECT_EQ(grab(view, QSize(700, 500)).size(), QSize(700, 500) * view.devicePixelRatio());
  EXPECT_TRUE(isSamePicture(grab(view, kSize), expected));
}

}  // namespace
}  // namespace vantage::testing
