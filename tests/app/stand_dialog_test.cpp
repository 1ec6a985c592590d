// How the stands lie in each other, in a window that works at once and is drawn without a display.
#include "stands/stand_dialog.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "acquisition/stand_composites.h"
#include "app/turned_session.h"
#include "report/warnings.h"
#include "report_pictures.h"
#include "screenshots/painted_text.h"
#include "screenshots/screenshot.h"
#include "session_controller.h"
#include "stands/picked_points.h"
#include "stands/point_picker.h"
#include "stands/pose_chooser.h"
#include "stands/pose_words.h"
#include "stands/stand_inspector.h"
#include "support/meshes.h"
#include "views/composite_view.h"
#include "window_theme.h"

namespace vantage {
namespace {

// Balls about a ball: it lies in itself in four ways.
Mesh cross() {
  Mesh mesh = testing::makeSphere(28, 22, {0, 0, 40});
  for (const double side : {-1.0, 1.0}) {
    mesh = testing::joined(mesh, testing::makeSphere(18, 18, {side * 36, 0, 40}));
    mesh = testing::joined(mesh, testing::makeSphere(12, 16, {0, side * 32, 40}));
  }
  return mesh;
}

// A session made once for all tests.
struct Turned {
  Mesh object;
  Pose T_table_object;
  QString path;
};

class Sessions : public ::testing::Environment {
 public:
  static const Turned& cross() { return at(0, vantage::cross(), 2); }
  static const Turned& odd() { return at(1, testing::smallObject(), 2); }

 private:
  static const Turned& at(std::size_t index, const Mesh& object, std::size_t face) {
    static const QTemporaryDir folder;
    static Turned made[2];
    Turned& turned = made[index];
    if (turned.path.isEmpty()) {
      turned = {object, testing::lyingOn(object, face), folder.filePath(QStringLiteral("%1.vantage").arg(index))};
      testing::writeTurnedSession(turned.path.toStdString(), turned.object, turned.T_table_object, 8);
    }
    return turned;
  }
};

class StandDialogTest : public ::testing::Test {
 protected:
  // The dialog on a copy of a session.
  void open(const Turned& turned, const QSize& size = {1000, 660}, bool dark = false) {
    truth_ = turned.T_table_object.inverse();
    const QString copy = folder_.filePath("session.vantage");
    ASSERT_TRUE(QFile::copy(turned.path, copy));
    QObject::connect(&controller_, &SessionController::failed,
                     [](const QString& what) { ADD_FAILURE() << what.toStdString(); });
    controller_.open(copy);
    ASSERT_TRUE(controller_.now());
    ASSERT_EQ(controller_.permissions().whyNotCompareStands(), "");
    const Theme& theme = dark ? darkTheme() : lightTheme();
    applyTheme(*qApp, theme);
    dialog_ = std::make_unique<StandDialog>(controller_, jobs_, StandLook{testing::testSurfaces(), theme}, 1);
    dialog_->resize(size);
    dialog_->show();
    settle();
    ASSERT_NE(dialog_->inspector().stand().comparison, nullptr) << complaint().toStdString();
  }

  static void settle() {
    for (int i = 0; i < 6; ++i) QCoreApplication::processEvents();
  }
  void click(const char* name) {
    auto* button = dialog_->findChild<QPushButton*>(name);
    ASSERT_NE(button, nullptr) << name;
    ASSERT_TRUE(button->isEnabled()) << name << ": " << button->toolTip().toStdString();
    QTest::mouseClick(button, Qt::LeftButton);
    settle();
  }
  [[nodiscard]] QString text(const char* label) const { return dialog_->findChild<QLabel*>(label)->text(); }
  [[nodiscard]] QString verdict() const { return text("standVerdict"); }
  [[nodiscard]] QString complaint() const { return text("standComplaint"); }
  [[nodiscard]] QListWidget& list() { return *dialog_->findChild<QListWidget*>("poses"); }
  [[nodiscard]] const Stand& stand() const { return controller_.now()->stands[1]; }

  // Looked at by people: kept where VANTAGE_SCREENSHOTS says, else beside the other screenshots.
  void lookAt(const QString& name) {
    settle();
    const QImage image = dialog_->grab().toImage();
    const QString folder = qEnvironmentVariable("VANTAGE_SCREENSHOTS", QStringLiteral(VANTAGE_SCREENSHOT_DIR));
    QDir().mkpath(folder);
    image.save(folder + "/stands_" + name + ".png");
    EXPECT_TRUE(testing::isNotBlank(image)) << name.toStdString();
    const auto texts = testing::paintedText(*dialog_);
    EXPECT_EQ(testing::cutOff(texts).join(" | ").toStdString(), "") << name.toStdString();
    for (const auto* label : dialog_->findChildren<QLabel*>()) {
      if (!label->isVisible() || label->text().isEmpty() || !label->wordWrap()) continue;
      EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
    }
    for (const auto* button : dialog_->findChildren<QAbstractButton*>()) {
      if (!button->isVisible() || button->isEnabled()) continue;
      EXPECT_FALSE(button->toolTip().isEmpty()) << button->objectName().toStdString();
    }
  }

  // Where a place of a scene is in a view.
  static QPoint pixelOf(const CompositeView& view, const Vec3& place) {
    const Camera& camera = view.camera();
    const Vec3 d = place - camera.eye;
    const double scale = 0.5 * view.height() / std::tan(0.5 * camera.viewAngle) / d.dot(camera.forward());
    const Vec3 up = camera.right().cross(camera.forward());
    return {static_cast<int>(std::lround(0.5 * view.width() + scale * d.dot(camera.right()))),
            static_cast<int>(std::lround(0.5 * view.height() - scale * d.dot(up)))};
  }
  // Whether a click there meets a place of a surface.
  static bool isInSight(const CompositeView& view, const CompositeModel& model, const Vec3& place) {
    const SightLine line = sightLine(view.camera(), pixelOf(view, place), view.size());
    const auto hit = model.caster().intersect(line.origin, line.direction);
    return hit && (line.origin + hit->distance * line.direction - place).norm() < 2.0;
  }
  // Clicks the same places, far from each other, on both. They are seen from the same side of the object.
  void pickPairs(std::size_t count) {
    CompositeView& object = dialog_->picker().view(PickSide::Object);
    CompositeView& lying = dialog_->picker().view(PickSide::Stand);
    const Pose T_table_object = truth_.inverse();
    Camera camera = object.camera();
    const Vec3 middle = dialog_->inspector().stand().comparison->composite.centroid();
    camera.eye = T_table_object * camera.eye;
    camera.up = T_table_object.linear() * camera.up;
    camera.target = T_table_object * camera.target;
    ASSERT_LT((camera.target - middle).norm(), 40.0);
    lying.setCamera(camera);
    const StandComparison& both = *dialog_->inspector().stand().comparison;
    std::vector<Vec3> places;
    while (places.size() < count) {
      std::optional<Vec3> best;
      double farthest = 0.0;
      for (const std::uint32_t i : both.object.points(PointLevel::Medium)) {
        const Vec3& p = both.object.surface().point(i);
        if (!isInSight(object, both.object, p) || !isInSight(lying, both.composite, T_table_object * p)) continue;
        double distance = 1e3;
        for (const Vec3& other : places) distance = std::min(distance, (p - other).norm());
        if (distance > farthest) farthest = distance, best = p;
      }
      ASSERT_TRUE(best) << "no place is in sight in both views";
      places.push_back(*best);
      QTest::mouseClick(&object, Qt::LeftButton, {}, pixelOf(object, *best));
      QTest::mouseClick(&lying, Qt::LeftButton, {}, pixelOf(lying, T_table_object * *best));
      settle();
    }
  }

  QTemporaryDir folder_;
  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, ""};
  std::unique_ptr<StandDialog> dialog_;
  Pose truth_ = Pose::Identity();
};

TEST_F(StandDialogTest, OfASymmetricObjectShowsItsPosesAndUsesTheOneThatIsChosen) {
  open(Sessions::cross());
  EXPECT_TRUE(verdict().contains("Stand 1 has not been aligned yet")) << verdict().toStdString();
  lookAt("before");
  const std::size_t steps = controller_.present().moments().size();
  click("searchPoses");
  ASSERT_TRUE(stand().alignment);
  EXPECT_EQ(controller_.present().moments().size(), steps + 1);
  ASSERT_EQ(stand().alignment->verdict, AlignmentVerdict::Ambiguous) << verdict().toStdString();
  EXPECT_FALSE(stand().T_object_table);
  EXPECT_TRUE(verdict().contains("is not in place")) << verdict().toStdString();
  ASSERT_EQ(list().count(), static_cast<int>(stand().alignment->candidates.size()));
  ASSERT_GT(list().count(), 1);
  EXPECT_EQ(dialog_->poses().current(), 0);
  lookAt("ambiguous");
  // Every pose has its picture, and shows what speaks for it.
  for (const PoseLook& look : dialog_->inspector().looks()) {
    ASSERT_NE(look.places, nullptr);
    EXPECT_TRUE(testing::isNotBlank(look.picture));
  }
  EXPECT_TRUE(testing::showsColour(dialog_->grab().toImage(), QColor(0x1F, 0xA6, 0x7A), 0.01, 60));
  list().setCurrentRow(1);
  lookAt("ambiguous_second");
  click("usePose");
  ASSERT_TRUE(stand().T_object_table);
  EXPECT_EQ(stand().alignment->used, 1);
  EXPECT_TRUE(verdict().contains("is in place")) << verdict().toStdString();
  EXPECT_TRUE(list().item(1)->text().contains("in use"));
  for (const char* name : {"usePose", "searchPoses", "pickPoints"})
    EXPECT_FALSE(dialog_->findChild<QPushButton*>(name)->isEnabled()) << name;
  lookAt("in_place");
  controller_.undo();
  EXPECT_FALSE(stand().T_object_table);
  EXPECT_TRUE(dialog_->findChild<QPushButton*>("usePose")->isEnabled());
}

TEST_F(StandDialogTest, APoseThatSomethingSpeaksAgainstIsUsedAllTheSameAndSaidSo) {
  open(Sessions::odd());
  click("searchPoses");
  // Where the search was sure the stand is in place: back to before.
  if (stand().T_object_table) controller_.undo();
  StandAlignment doubtful;
  doubtful.verdict = AlignmentVerdict::Failed;
  doubtful.reason = AlignmentReason::Contradiction;
  doubtful.value = 0.08;
  StandPose wrong;
  wrong.T_object_stand = Pose(Eigen::Translation3d(0, 0, 6)) * truth_;
  wrong.conflict = 0.08;
  doubtful.candidates = {wrong};
  auto* chooser = &dialog_->poses();
  chooser->setAlignment(std::make_shared<const StandAlignment>(doubtful));
  dialog_->inspector().lookAt({wrong.T_object_stand}, lightTheme());
  settle();
  EXPECT_EQ(dialog_->findChild<QPushButton*>("usePose")->text(), "&Use it all the same");
  EXPECT_TRUE(testing::showsColour(dialog_->grab().toImage(), QColor(0xC8, 0x1E, 0x2A), 0.003, 60));
  lookAt("contradicted");
  std::optional<bool> despite;
  QObject::connect(chooser, &PoseChooser::useRequested, [&](int, bool asked) { despite = asked; });
  QObject::disconnect(chooser, &PoseChooser::useRequested, dialog_.get(), nullptr);
  click("usePose");
  EXPECT_EQ(despite, true);
}

TEST_F(StandDialogTest, PointsThatArePickedOnBothAreWhereAnAlignmentBegins) {
  open(Sessions::odd());
  click("pickPoints");
  EXPECT_TRUE(dialog_->picker().isVisible());
  EXPECT_FALSE(dialog_->findChild<QPushButton*>("alignPicked")->isEnabled());
  EXPECT_FALSE(dialog_->findChild<QPushButton*>("removePoint")->isEnabled());
  pickPairs(4);
  ASSERT_EQ(dialog_->picker().points().pairs().size(), 4U);
  lookAt("picks");
  click("removePoint");
  EXPECT_EQ(dialog_->picker().points().pairs().size(), 3U);
  const std::size_t steps = controller_.present().moments().size();
  click("alignPicked");
  EXPECT_EQ(controller_.present().moments().size(), steps + 1);
  ASSERT_TRUE(stand().alignment) << text("pickComplaint").toStdString();
  EXPECT_TRUE(stand().alignment->picked);
  EXPECT_FALSE(dialog_->picker().isVisible());
  lookAt("picked_verdict");
  ASSERT_FALSE(stand().alignment->candidates.empty());
  const Pose off = truth_.inverse() * stand().alignment->candidates[0].T_object_stand;
  EXPECT_LT(Eigen::AngleAxisd(off.linear()).angle(), radians(2.0)) << verdict().toStdString();
  EXPECT_LT(off.translation().norm(), 2.0) << verdict().toStdString();
}

TEST_F(StandDialogTest, PointsOnALineAreRefusedBeforeAStepIsBegun) {
  open(Sessions::odd());
  click("pickPoints");
  const StandComparison& both = *dialog_->inspector().stand().comparison;
  const Vec3 p = both.object.surface().point(both.object.points(PointLevel::Coarse)[0]);
  const Vec3 q = both.composite.surface().point(both.composite.points(PointLevel::Coarse)[0]);
  for (int i = 0; i < 3; ++i) {
    emit dialog_->picker().view(PickSide::Object).surfacePicked(p);
    emit dialog_->picker().view(PickSide::Stand).surfacePicked(q);
  }
  const std::size_t steps = controller_.present().moments().size();
  click("alignPicked");
  EXPECT_EQ(controller_.present().moments().size(), steps);
  EXPECT_TRUE(text("pickComplaint").contains("on a line")) << text("pickComplaint").toStdString();
  EXPECT_TRUE(dialog_->picker().isVisible());
}

TEST_F(StandDialogTest, EscapeGoesBackFromPickingAndThenCloses) {
  open(Sessions::odd());
  click("pickPoints");
  QTest::keyClick(dialog_.get(), Qt::Key_Escape);
  EXPECT_FALSE(dialog_->picker().isVisible());
  EXPECT_TRUE(dialog_->isVisible());
  QTest::keyClick(dialog_.get(), Qt::Key_Escape);
  EXPECT_FALSE(dialog_->isVisible());
}

TEST_F(StandDialogTest, FitsASmallScreenInBothThemes) {
  open(Sessions::odd(), {900, 600}, true);
  EXPECT_LE(dialog_->minimumSizeHint().width(), 1000);
  EXPECT_LE(dialog_->minimumSizeHint().height(), 640);
  lookAt("small_dark");
  click("pickPoints");
  lookAt("small_dark_picks");
}

TEST_F(StandDialogTest, IsOfferedOnlyWhereAStandIsNotInPlace) {
  EXPECT_FALSE(controller_.permissions().whyNotCompareStands().isEmpty());
  open(Sessions::odd());
  EXPECT_EQ(controller_.permissions().whyNotCompareStands(), "");
  controller_.change(PlaceStand{1, truth_});
  EXPECT_FALSE(controller_.permissions().whyNotCompareStands().isEmpty());
}

TEST_F(StandDialogTest, TheReportShowsHowTheObjectStood) {
  open(Sessions::odd());
  const std::vector<ReportPicture> pictures = standPictures(*controller_.now());
  ASSERT_EQ(pictures.size(), 2U);
  for (const ReportPicture& picture : pictures) {
    const QImage image = QImage::fromData(QByteArray::fromStdString(picture.png));
    EXPECT_TRUE(testing::isNotBlank(image));
    EXPECT_TRUE(testing::showsColour(image, lightTheme().table, 0.02, 90));
  }
  EXPECT_NE(pictures[0].png, pictures[1].png);
}

TEST(PickedPoints, ComeInPairsWhicheverSideIsClickedFirst) {
  PickedPoints points;
  EXPECT_TRUE(points.isEmpty());
  EXPECT_FALSE(points.awaited());
  points.pick(PickSide::Stand, Vec3(1, 0, 0));
  EXPECT_EQ(points.awaited(), PickSide::Object);
  EXPECT_TRUE(points.pairs().empty());
  points.pick(PickSide::Stand, Vec3(2, 0, 0));  // taken again
  EXPECT_EQ(points.on(PickSide::Stand).size(), 1U);
  points.pick(PickSide::Object, Vec3(3, 0, 0));
  EXPECT_FALSE(points.awaited());
  ASSERT_EQ(points.pairs().size(), 1U);
  EXPECT_EQ(points.pairs()[0].reference, Vec3(3, 0, 0));
  EXPECT_EQ(points.pairs()[0].moved, Vec3(2, 0, 0));
  points.pick(PickSide::Object, Vec3(4, 0, 0));
  EXPECT_EQ(points.awaited(), PickSide::Stand);
  points.removeLast();
  EXPECT_EQ(points.pairs().size(), 1U);
  points.removeLast();
  EXPECT_TRUE(points.isEmpty());
  points.removeLast();
  EXPECT_TRUE(points.isEmpty());
}

TEST(PoseWords, SayWhatCameOfAnAlignmentAndWhatToDo) {
  EXPECT_TRUE(verdictText(2, nullptr, false).contains("Stand 2 has not been aligned yet"));
  StandAlignment alignment;
  alignment.verdict = AlignmentVerdict::Ambiguous;
  alignment.reason = AlignmentReason::SeveralPoses;
  alignment.value = 2.0;
  EXPECT_TRUE(verdictText(1, &alignment, false).contains("2 poses are possible"));
  EXPECT_TRUE(verdictText(1, &alignment, false).contains("use the right one"));
  alignment.sameSurface = true;
  EXPECT_TRUE(verdictText(1, &alignment, false).contains("no difference"));
  alignment.choice = PoseChoice::Despite;
  EXPECT_TRUE(verdictText(1, &alignment, true).contains("although something speaks against it"));
  StandPose pose;
  pose.overlap = 0.456;
  pose.conflict = 0.01;
  pose.table = 0.02;
  EXPECT_TRUE(poseFigures(pose).contains("45.6 %"));
  EXPECT_TRUE(poseFigures(pose).contains("3.0 % contradicted"));
  EXPECT_EQ(poseTitle(0, pose), "Pose 1, unlikely");
}

}  // namespace
}  // namespace vantage
