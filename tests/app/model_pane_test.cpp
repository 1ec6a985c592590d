#include "docks/model_pane.h"

#include <gtest/gtest.h>

#include <QComboBox>

namespace vantage {
namespace {

// Snapshots of a state with one view and no model yet: which choices there are follows from the scans.
SharedSnapshot snapshotOf(bool coloured, const std::vector<int>& stands = {0}) {
  RangeImage image;
  image.rays = std::make_shared<const RayGrid>(2, 2, std::vector<RangingRay>(4, {Vec3::Zero(), Vec3::UnitX()}),
                                               std::vector<Vec3>(), 0);
  image.range.assign(4, 100.0F);
  if (coloured) image.colours.assign(4, Colour{1, 2, 3});
  auto state = std::make_shared<AcquisitionState>();
  for (const int stand : stands) {
    image.station.stand = stand;
    KeptScan scan;
    scan.view.image = std::make_shared<const RangeImage>(image);
    state->scans.push_back(scan);
  }
  return makeSnapshot(state);
}

class ModelPaneColours : public ::testing::Test {
 protected:
  ModelPaneColours() : pane_(imageSurfaces([] { return std::unique_ptr<OffscreenWindow>(); }), nullptr) {}

  [[nodiscard]] QComboBox& choice() { return *pane_.findChild<QComboBox*>(QStringLiteral("colouring")); }
  [[nodiscard]] QStringList choices() {
    QStringList texts;
    for (int i = 0; i < choice().count(); ++i) texts << choice().itemText(i);
    return texts;
  }

  ModelPane pane_;
};

TEST_F(ModelPaneColours, AreOfferedWhereTheScansSawSomeAndOnByThemselves) {
  const QStringList without{"Plain", "Confidence", "View", "Age"};
  EXPECT_EQ(choices(), without);
  pane_.setSnapshot(snapshotOf(false));
  EXPECT_EQ(choices(), without);
  EXPECT_EQ(choice().currentText(), "Plain");
  pane_.setSnapshot(snapshotOf(true));
  EXPECT_EQ(choices(), without + QStringList{"Colours"});
  EXPECT_EQ(choice().currentText(), "Colours");
  EXPECT_FALSE(pane_.view().options().colouring);
  pane_.setSnapshot(snapshotOf(false));
  EXPECT_EQ(choices(), without);
  EXPECT_EQ(choice().currentText(), "Plain");
}

TEST_F(ModelPaneColours, StayOffWhereAnotherWasChosen) {
  pane_.setSnapshot(snapshotOf(true));
  choice().setCurrentText("Plain");
  pane_.setSnapshot(snapshotOf(true));
  EXPECT_EQ(choice().currentText(), "Plain");
  EXPECT_EQ(pane_.view().options().colouring, ModelColouring::Plain);
  choice().setCurrentText("Age");
  pane_.setSnapshot(snapshotOf(false));
  EXPECT_EQ(choice().currentText(), "Age");
}

TEST_F(ModelPaneColours, ThatWereChosenComeBack) {
  pane_.setSnapshot(snapshotOf(true));
  choice().setCurrentText("View");
  choice().setCurrentText("Colours");
  pane_.setSnapshot(snapshotOf(false));
  EXPECT_EQ(choice().currentText(), "Plain");
  pane_.setSnapshot(snapshotOf(true));
  EXPECT_EQ(choice().currentText(), "Colours");
  EXPECT_EQ(pane_.view().options().colouring, ModelColouring::Colours);
}

TEST_F(ModelPaneColours, ByStandAreOfferedWhereThereAreSeveral) {
  pane_.setSnapshot(snapshotOf(true, {0, 0}));
  EXPECT_EQ(choice().findText("Stand"), -1);
  pane_.setSnapshot(snapshotOf(false, {0, 0, 1}));
  EXPECT_EQ(choice().currentText(), "Plain");
  choice().setCurrentText("Stand");
  EXPECT_EQ(pane_.view().options().colouring, ModelColouring::Stand);
  pane_.setSnapshot(snapshotOf(true, {0, 1}));
  EXPECT_EQ(choice().currentText(), "Stand");
  pane_.setSnapshot(snapshotOf(true));
  EXPECT_EQ(choice().findText("Stand"), -1);
  choice().setCurrentText("Colours");
  EXPECT_EQ(pane_.view().options().colouring, ModelColouring::Colours);
}

}  // namespace
}  // namespace vantage
