#include "stand_desk.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <fstream>

#include "acquisition/stand_composites.h"
#include "io/mesh_writer.h"
#include "stand_text.h"
#include "support/scenes/small_scene.h"
#include "wizard/object_figures.h"

namespace vantage {
namespace {

// A desk that works at once, before the small object and a coarse scanner.
class StandDeskTest : public ::testing::Test {
 protected:
  StandDeskTest() {
    std::ofstream(path("scanner.json").toStdString()) << testing::smallProfileSource().text;
    exportMesh(testing::smallObject(), path("object.ply").toStdString());
    SetUpChoice choice;
    choice.scanner = path("scanner.json").toStdString();
    choice.folder = path("out").toStdString();
    choice.settings.simulation.object = path("object.ply").toStdString();
    choice.settings.maxViews = 5;
    controller_.setChoice(choice);
    controller_.prepare();
  }

  void scan(int times) {
    for (int i = 0; i < times; ++i) controller_.step();
  }
  void turnOver() {
    desk_.look();
    ASSERT_TRUE(desk_.prospect());
    ASSERT_FALSE(desk_.prospect()->outlook.sides.empty());
    desk_.turnOnto(desk_.prospect()->outlook.sides.front().down);
    ASSERT_EQ(desk_.stand(), 1);
  }
  [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }
  [[nodiscard]] QByteArray exported() {
    controller_.exportModel(path("model.stl"));
    QFile file(path("model.stl"));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  QTemporaryDir folder_;
  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, ""};
  StandDesk desk_{controller_, jobs_};
};

TEST_F(StandDeskTest, FindsSidesOfWhatThereIsNow) {
  EXPECT_FALSE(desk_.whyNotTurn().isEmpty()) << "nothing was scanned";
  desk_.look();
  EXPECT_FALSE(desk_.prospect());
  scan(3);
  EXPECT_EQ(desk_.whyNotTurn().toStdString(), "");
  QSignalSpy changed(&desk_, &StandDesk::prospectChanged);
  desk_.look();
  const auto prospect = desk_.prospect();
  ASSERT_TRUE(prospect);
  EXPECT_GE(changed.count(), 1);
  ASSERT_FALSE(prospect->outlook.sides.empty());
  EXPECT_TRUE(prospect->worthAnother());
  EXPECT_EQ(prospect->geometry->model, controller_.now()->model);
  desk_.look();
  EXPECT_EQ(desk_.prospect(), prospect) << "it is known";
  scan(1);
  EXPECT_FALSE(desk_.prospect()) << "of an earlier state";
}

TEST_F(StandDeskTest, TurningOverSetsTheObjectAside) {
  scan(3);
  const QByteArray object = exported();
  ASSERT_FALSE(object.isEmpty());
  EXPECT_TRUE(ownModelText(*controller_.now()).isEmpty());
  QSignalSpy turned(&desk_, &StandDesk::turned);
  turnOver();
  EXPECT_EQ(turned.count(), 1);
  EXPECT_TRUE(desk_.isOpen());
  EXPECT_TRUE(desk_.sentence().startsWith("Stand 1 is a model of its own"));
  EXPECT_TRUE(hasAnyModel(controller_.now()));
  EXPECT_EQ(exported(), object);
  scan(1);
  EXPECT_EQ(controller_.now()->scans.back().station().stand, 1);
  EXPECT_EQ(ownModelText(*controller_.now()).toStdString(), "Stand 1, not put together with the object yet");
  EXPECT_EQ(exported(), object) << "the model that is exported is the object's";
  EXPECT_EQ(desk_.whyNotAlign().toStdString(), "");
}

TEST_F(StandDeskTest, GoesBackToOneStandAndForthAgain) {
  scan(3);
  EXPECT_FALSE(desk_.whyNotGoBack().isEmpty());
  const SharedState before = controller_.now();
  turnOver();
  scan(2);
  EXPECT_EQ(desk_.whyNotGoBack().toStdString(), "");
  desk_.goBack();
  EXPECT_EQ(desk_.stand(), 0);
  EXPECT_EQ(controller_.now()->scans.size(), before->scans.size());
  EXPECT_TRUE(desk_.sentence().isEmpty());
  for (int i = 0; i < 3; ++i) controller_.redo();
  EXPECT_EQ(desk_.stand(), 1);
  EXPECT_EQ(countScans(*controller_.now(), ScanStatus::In), 2U);
}

TEST_F(StandDeskTest, AlignsByItselfFromTheThirdViewOn) {
  scan(5);
  turnOver();
  QSignalSpy tried(&controller_, &SessionController::standTried);
  scan(2);
  EXPECT_EQ(tried.count(), 0);
  controller_.run();
  EXPECT_GE(tried.count(), 1);
  const AcquisitionState& now = *controller_.now();
  ASSERT_TRUE(now.stands[1].alignment) << "what came of it is recorded at the end at the latest";
  EXPECT_EQ(desk_.isOpen(), !now.stands[1].T_object_table);
  EXPECT_EQ(desk_.sentence(), standSentence(now.stands, 1));
  EXPECT_EQ(desk_.isOpen(), standRoleOf(now.stands, 1) == StandRole::NotAligned);
}

}  // namespace
}  // namespace vantage
