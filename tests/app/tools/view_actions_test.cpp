// The tools of the model view in the whole window: by their buttons and keys, and what the pictures show.
#include "docks/view_actions.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "app/desk.h"
#include "app/window_checks.h"

namespace vantage {
namespace {

using testing::Desk;

// The sample mug after two scans.
class ViewActionsTest : public ::testing::TestWithParam<bool> {
 protected:
  ViewActionsTest() : desk_({1280, 800}, GetParam()), view_(desk_.window().views().model().view()) {
    desk_.next();
    desk_.next();
    desk_.controller().step();
    desk_.controller().step();
    view_.finishLoading();
    Desk::settle();
  }
  void press(const char* icon) {
    auto* button = desk_.window().findChild<QToolButton*>(QStringLiteral("tool_") + icon);
    ASSERT_NE(button, nullptr) << icon;
    button->click();
    view_.finishLoading();
    Desk::settle();
  }
  QImage picture(const QString& name) {
    desk_.picture(QStringLiteral("view_%1_%2").arg(name, QLatin1String(GetParam() ? "dark" : "light")));
    EXPECT_EQ(testing::clipped(desk_.window()).join(" | ").toStdString(), "") << name.toStdString();
    EXPECT_EQ(testing::beyondTheKeyboard(desk_.window()).join(" | ").toStdString(), "") << name.toStdString();
    EXPECT_EQ(testing::unexplained(desk_.window()).join(" | ").toStdString(), "") << name.toStdString();
    return view_.grab().toImage();
  }
  [[nodiscard]] QString said() const { return view_.accessibleDescription(); }
  // Clicks where the surface is, as seen from the camera: near the middle of the view, to the side by a share of it.
  void clickBeside(double share) {
    const QPoint place(static_cast<int>((0.5 + share) * view_.width()), view_.height() / 2);
    QTest::mouseClick(&view_, Qt::LeftButton, {}, place);
    Desk::settle();
  }
  static double redShare(const QImage& image) {
    int red = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor c = image.pixelColor(x, y);
        red += c.red() > 70 && c.red() > 2.5 * c.green() && c.red() > 2.2 * c.blue() ? 1 : 0;
      }
    return static_cast<double>(red) / (image.width() * image.height());
  }
  static double changedShare(const QImage& a, const QImage& b) {
    EXPECT_EQ(a.size(), b.size());
    if (a.size() != b.size()) return 0.0;
    int changed = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) changed += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return static_cast<double>(changed) / (a.width() * a.height());
  }

  Desk desk_;
  ModelView& view_;
};
INSTANTIATE_TEST_SUITE_P(In, ViewActionsTest, ::testing::Bool(),
                         [](const auto& p) { return std::string(p.param ? "dark" : "light"); });

TEST_P(ViewActionsTest, TheSurfaceIsDrawnAsEdgesOrCornersAndNeverAsBoth) {
  const QImage filled = picture("filled");
  press("wireframe");
  EXPECT_EQ(view_.options().style, SurfaceStyle::Wireframe);
  EXPECT_TRUE(said().contains("As a wireframe"));
  EXPECT_GT(changedShare(filled, picture("wireframe")), 0.005);
  press("points");
  EXPECT_EQ(view_.options().style, SurfaceStyle::Points);
  EXPECT_FALSE(said().contains("As a wireframe"));
  EXPECT_TRUE(said().contains("As points"));
  EXPECT_GT(changedShare(filled, picture("points")), 0.005);
  press("points");
  EXPECT_EQ(view_.options().style, SurfaceStyle::Filled);
  EXPECT_LT(changedShare(filled, picture("filled_again")), 0.001);
}

TEST_P(ViewActionsTest, BackFacesAreRedWhateverTheSurfaceIsColouredBy) {
  desk_.window().findChild<QComboBox*>("colouring")->setCurrentText("View");
  // From behind: what the scanner saw is seen from its inside.
  Camera behind = view_.camera();
  const Vec3 away = behind.eye - behind.target;
  behind.eye = behind.target + Vec3(-away.x(), -away.y(), away.z());
  view_.setCamera(behind);
  const double before = redShare(picture("view_colours"));
  press("back_faces");
  EXPECT_TRUE(said().contains("Back faces are red"));
  EXPECT_GT(redShare(picture("back_faces")), before + 0.002);
}

TEST_P(ViewActionsTest, TheProjectionIsParallelUntilItIsNotAnyMore) {
  const QImage before = picture("perspective");
  press("orthographic");
  EXPECT_TRUE(view_.camera().parallel);
  EXPECT_TRUE(said().contains("In parallel projection"));
  EXPECT_GT(changedShare(before, picture("parallel")), 0.005);
  view_.lookFrom(CameraPreset::Front);
  EXPECT_TRUE(view_.camera().parallel) << "from every side";
  picture("parallel_front");
  press("orthographic");
  EXPECT_FALSE(view_.camera().parallel);
}

TEST_P(ViewActionsTest, ACutIsPlacedByKeysAndSaysWhatItLeavesAndCuts) {
  auto* bar = desk_.window().findChild<QWidget*>("sectionBar");
  EXPECT_FALSE(bar->isVisible());
  press("section");
  ASSERT_TRUE(bar->isVisible());
  ASSERT_TRUE(view_.options().section);
  EXPECT_NEAR(view_.options().section->at, view_.modelBox().centre().x(), 0.06);
  EXPECT_TRUE(said().contains("Clipped: shown is what has x ≤ ")) << said().toStdString();
  ASSERT_TRUE(view_.cutOut());
  EXPECT_TRUE(said().contains(sectionText(*view_.cutOut())));
  EXPECT_GT(view_.cutOut()->length, 1.0);
  const QImage cut = picture("cut");
  auto* slider = bar->findChild<QSlider*>();
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Home);
  EXPECT_NEAR(view_.options().section->at, view_.modelBox().min.x(), 0.11);
  EXPECT_GT(changedShare(cut, picture("cut_away")), 0.02) << "nearly nothing is left";
  bar->findChild<QCheckBox*>()->setChecked(true);
  view_.finishLoading();
  EXPECT_TRUE(said().contains("x ≥ "));
  bar->findChild<QComboBox*>()->setCurrentIndex(2);
  view_.finishLoading();
  EXPECT_TRUE(said().contains("z ≥ "));
  EXPECT_NEAR(view_.options().section->at, view_.modelBox().centre().z(), 0.06);
  picture("cut_z");
  bar->findChild<QDoubleSpinBox*>()->setValue(view_.modelBox().min.z() + 10.0);
  EXPECT_NEAR(view_.options().section->at, view_.modelBox().min.z() + 10.0, 0.06);
  press("section");
  EXPECT_FALSE(view_.options().section);
  EXPECT_FALSE(said().contains("Clipped"));
  EXPECT_FALSE(bar->isVisible());
}

TEST_P(ViewActionsTest, TwoPlacesOnTheSurfaceAreMeasuredByMouseAndByKey) {
  view_.lookFrom(CameraPreset::ScannersEye);
  press("measure");
  auto* told = desk_.window().findChild<QLabel*>("measured");
  ASSERT_TRUE(told->isVisible());
  EXPECT_EQ(told->text(), "Click the first place on the surface.");
  clickBeside(0.0);
  ASSERT_EQ(view_.measured().size(), 1U);
  EXPECT_EQ(told->text(), "Click the second place on the surface.");
  clickBeside(0.04);
  ASSERT_EQ(view_.measured().size(), 2U);
  const QString distance = distanceText(view_.measured()[0], view_.measured()[1]);
  EXPECT_EQ(told->text(), "From 1 to 2: " + distance);
  EXPECT_TRUE(said().contains("1 to 2: " + distance));
  EXPECT_GT((view_.measured()[1] - view_.measured()[0]).norm(), 0.5);
  picture("measured");
  desk_.window().findChild<QPushButton*>("measureAgain")->click();
  EXPECT_TRUE(view_.measured().empty());
  QTest::keyClick(&view_, Qt::Key_Return);
  ASSERT_EQ(view_.measured().size(), 1U) << "Enter takes the middle";
  press("measure");
  EXPECT_TRUE(view_.measured().empty());
  EXPECT_FALSE(told->isVisible());
}

TEST_P(ViewActionsTest, WhatWasMeasuredIsForgottenWithTheModel) {
  view_.lookFrom(CameraPreset::ScannersEye);
  press("measure");
  QTest::keyClick(&view_, Qt::Key_Return);
  ASSERT_EQ(view_.measured().size(), 1U);
  desk_.controller().undo();
  view_.finishLoading();
  Desk::settle();
  EXPECT_TRUE(view_.measured().empty());
}

}  // namespace
}  // namespace vantage
