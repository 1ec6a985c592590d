#include "session_controller.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <fstream>

#include "charts/objective_chart.h"
#include "ending_text.h"
#include "io/mesh_writer.h"
#include "position_inspector.h"
#include "report/areas_known.h"
#include "report/wording.h"
#include "support/scenes/small_scene.h"
#include "wording.h"

namespace vantage {
namespace {

// A controller that works at once, before a small object and a coarse scanner in a folder of their own.
class SessionControllerTest : public ::testing::Test {
 protected:
  SessionControllerTest() {
    std::ofstream(path("scanner.json").toStdString()) << testing::smallProfileSource().text;
    exportMesh(testing::smallObject(), path("object.ply").toStdString());
    controller_ = make();
    QObject::connect(controller_.get(), &SessionController::failed, [this](const QString& what) { failure_ = what; });
  }

  std::unique_ptr<SessionController> make() { return std::make_unique<SessionController>(jobs_, ""); }

  [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }

  [[nodiscard]] SetUpChoice choice(int maxViews = 3) const {
    SetUpChoice choice;
    choice.scanner = path("scanner.json").toStdString();
    choice.folder = path("out").toStdString();
    choice.settings.simulation.object = path("object.ply").toStdString();
    choice.settings.maxViews = maxViews;
    return choice;
  }

  void prepare(int maxViews = 3) {
    controller_->setChoice(choice(maxViews));
    controller_->prepare();
  }

  // A scan from the far side of the first one, which shares no surface with it.
  void failAScan() {
    prepare(5);
    controller_->step();
    controller_->choosePosition(kFarSide);
    controller_->step();
    ASSERT_EQ(controller_->now()->scans.back().status, ScanStatus::Rejected);
  }

  // A session of recorded scans without a scanner, as the command line imports them.
  [[nodiscard]] QString importedSession() const {
    static_cast<void>(testing::importSmallScans(path("imported.vantage").toStdString()));
    return path("imported.vantage");
  }

  static constexpr int kFarSide = 12;

  static QByteArray bytesOf(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  QTemporaryDir folder_;
  SynchronousJobRunner jobs_;
  std::unique_ptr<SessionController> controller_;
  QString failure_;
};

TEST_F(SessionControllerTest, PreparesAndChecksTheSetUp) {
  prepare();
  ASSERT_TRUE(controller_->setUp());
  EXPECT_TRUE(controller_->setUp()->object->insideVolume);
  EXPECT_GT(controller_->setUp()->object->height, 50.0);
  EXPECT_FALSE(controller_->hasSession());
}

TEST_F(SessionControllerTest, KeepsWhatIsPreparedWhenNothingWasChanged) {
  prepare();
  const SharedSetUp before = controller_->setUp();
  controller_->setChoice(choice());
  EXPECT_EQ(controller_->setUp(), before);
  controller_->setChoice(choice(4));
  EXPECT_FALSE(controller_->setUp());
}

TEST_F(SessionControllerTest, SaysWhatIsWrongWithAFile) {
  SetUpChoice broken = choice();
  broken.settings.simulation.object = path("nothing.ply").toStdString();
  controller_->setChoice(broken);
  controller_->prepare();
  EXPECT_TRUE(failure_.contains("nothing.ply"));
  EXPECT_TRUE(controller_->idle());
}

TEST_F(SessionControllerTest, TestTurnKeepsNothing) {
  prepare();
  controller_->testTurn();
  ASSERT_TRUE(controller_->testScans().turnResult());
  EXPECT_NEAR(controller_->testScans().turnResult()->expected, radians(30.0), 1e-9);
  EXPECT_FALSE(controller_->hasSession());
}

TEST_F(SessionControllerTest, RunsToTheEndAndTellsSo) {
  prepare();
  QSignalSpy ended(controller_.get(), &SessionController::runEnded);
  controller_->run();
  EXPECT_TRUE(failure_.isEmpty()) << failure_.toStdString();
  EXPECT_EQ(ended.count(), 1);
  ASSERT_TRUE(controller_->now());
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 3U);
  EXPECT_EQ(controller_->now()->termination, Termination::MaxViews);
  EXPECT_EQ(controller_->present().moments().size(), 4U);  // the set-up and three scans
}

TEST_F(SessionControllerTest, StepsLeadToTheSameModelAsARun) {
  prepare();
  for (int i = 0; i < 3; ++i) controller_->step();
  controller_->exportModel(path("steps.stl"));
  controller_->close();
  prepare();
  controller_->run();
  controller_->exportModel(path("run.stl"));
  ASSERT_FALSE(bytesOf(path("run.stl")).isEmpty());
  EXPECT_EQ(bytesOf(path("run.stl")), bytesOf(path("steps.stl")));
}

TEST_F(SessionControllerTest, WhatCannotBePrintedIsNotWrittenAndSaysWhy) {
  prepare();
  controller_->step();
  QSignalSpy refused(controller_.get(), &SessionController::printRefused);
  QSignalSpy made(controller_.get(), &SessionController::madeReady);
  controller_->exportFinished(path("open.stl"), {});
  ASSERT_EQ(refused.count(), 1);
  EXPECT_TRUE(refused[0][0].toString().contains(QStringLiteral("opening")));
  EXPECT_FALSE(QFile::exists(path("open.stl")));
  HandOver how;
  how.finishing.close.emplace();
  how.onlyPrintable = false;
  controller_->exportFinished(path("closed.3mf"), how);
  EXPECT_TRUE(failure_.isEmpty()) << failure_.toStdString();
  ASSERT_EQ(made.count(), 1);
  EXPECT_TRUE(made[0][0].toString().contains(QStringLiteral("invented")));
  EXPECT_FALSE(bytesOf(path("closed.3mf")).isEmpty());
}

TEST_F(SessionControllerTest, UndoAndRedoMoveThroughTheScans) {
  prepare();
  controller_->step();
  controller_->step();
  const SharedState two = controller_->now();
  controller_->undo();
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 1U);
  EXPECT_TRUE(controller_->present().moments().back().undone);
  controller_->redo();
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 2U);
  EXPECT_EQ(controller_->now()->scans.back().station().position, two->scans.back().station().position);
  EXPECT_FALSE(controller_->permissions().whyNotRedo().isEmpty());
}

TEST_F(SessionControllerTest, TheOperatorMayChooseAnotherPosition) {
  prepare();
  controller_->step();
  const int proposed = controller_->present().nextPosition().value();
  const int other = (proposed + 2) % 24;
  controller_->choosePosition(other);
  EXPECT_EQ(controller_->present().nextPosition(), other);
  controller_->choosePosition({});
  EXPECT_EQ(controller_->present().nextPosition(), proposed);
  controller_->choosePosition(other);
  controller_->step();
  EXPECT_EQ(controller_->now()->scans.back().station().position, other);
}

TEST_F(SessionControllerTest, ShowsAnEarlierMomentWithoutChangingNow) {
  prepare();
  controller_->run();
  controller_->showMoment(1);
  EXPECT_FALSE(controller_->showsNow());
  EXPECT_EQ(countScans(*controller_->shown(), ScanStatus::In), 1U);
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 3U);
  controller_->showNow();
  EXPECT_EQ(controller_->shown(), controller_->now());
}

TEST_F(SessionControllerTest, LeavesAViewOutAndTakesItBack) {
  prepare();
  controller_->run();
  const std::int64_t scan = controller_->now()->scans[1].number;
  controller_->leaveOut(scan);
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 2U);
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::LeftOut), 1U);
  controller_->takeBack(scan);
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 3U);
}

TEST_F(SessionControllerTest, ASessionReopensAtItsPageWithEveryScan) {
  prepare();
  controller_->step();
  controller_->step();
  controller_->rememberPage("review");
  const QString session = controller_->sessionPath();
  controller_ = nullptr;

  controller_ = make();
  controller_->open(session);
  ASSERT_TRUE(controller_->hasSession());
  EXPECT_EQ(controller_->page(), "review");
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 2U);
  controller_->step();
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 3U);
}

TEST_F(SessionControllerTest, ASessionThatIsReopenedHasItsObjectOnTheTable) {
  prepare();
  const ObjectOnTable before = *controller_->setUp()->object;
  controller_->step();
  const QString session = controller_->sessionPath();
  controller_ = make();
  controller_->open(session);
  ASSERT_TRUE(controller_->setUp()->object);
  const ObjectOnTable& after = *controller_->setUp()->object;
  EXPECT_GT(after.radius, 40.0);
  EXPECT_EQ(after.radius, before.radius);
  EXPECT_EQ(after.height, before.height);
  EXPECT_EQ(after.lowest, before.lowest);
  EXPECT_TRUE(after.insideVolume);
  controller_->testTurn();
  EXPECT_TRUE(controller_->testScans().turnResult());
}

TEST_F(SessionControllerTest, ASessionOfRecordedScansHasNothingToScanWithAndSaysSo) {
  const std::string profile = path("scanner.json").toStdString();
  for (const bool withProfile : {false, true}) {
    const QString session = path(withProfile ? "positions.vantage" : "free.vantage");
    std::optional<ProfileSource> source;
    if (withProfile) source = readProfileSource(profile);
    static_cast<void>(Session::create(session.toStdString(), {source, {}, nullptr}));
    controller_ = make();
    controller_->open(session);
    ASSERT_TRUE(controller_->hasSession());
    EXPECT_FALSE(controller_->setUp()->devices);
    EXPECT_TRUE(controller_->permissions().whyNotScan().contains("recorded"))
        << controller_->permissions().whyNotScan().toStdString();
    EXPECT_TRUE(controller_->permissions().whyNotTestTurn().contains("recorded"));
    EXPECT_FALSE(controller_->permissions().whyNotRun().isEmpty());
    controller_->step();
    controller_->testTurn();
    EXPECT_FALSE(controller_->testScans().turnResult());
    EXPECT_TRUE(controller_->now()->scans.empty());
  }
}

TEST_F(SessionControllerTest, ASessionThatNoWindowHasHadOpensWhereItsStateLeads) {
  prepare();
  controller_->step();
  const QString session = controller_->sessionPath();
  for (const char* page : {"acquire", "review"}) {
    controller_ = make();
    controller_->open(session);
    EXPECT_EQ(controller_->page(), page);
    controller_->run();
  }
}

TEST_F(SessionControllerTest, CancellingAStepLeavesNoTrace) {
  prepare();
  controller_->step();
  const auto stop = QObject::connect(&jobs_, &JobRunner::progressed, [this](int job, double, const QString& step) {
    if (step == "integrate") jobs_.cancel(job);
  });
  controller_->step();
  QObject::disconnect(stop);
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 1U);
  EXPECT_TRUE(controller_->idle());
  controller_->step();
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 2U);
}

TEST_F(SessionControllerTest, PauseEndsARunAfterTheStepThatIsUnderWay) {
  prepare();
  const auto pause = QObject::connect(&jobs_, &JobRunner::progressed, [this](int, double, const QString& step) {
    if (step == "choose") controller_->pause();
  });
  controller_->run();
  QObject::disconnect(pause);
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 1U);
  EXPECT_EQ(controller_->now()->termination, Termination::Running);
}

TEST_F(SessionControllerTest, AdvisesWhichWayToTurnTheTable) {
  prepare();
  controller_->step();
  const int at = controller_->now()->scans.back().station().position.value();
  const auto advice = controller_->turnTo((at + 1) % 24);
  ASSERT_TRUE(advice);
  EXPECT_NEAR(advice->turn.angle, -radians(15.0), 1e-9);
  EXPECT_NEAR(std::remainder(advice->to - advice->from, 2 * kPi), radians(15.0), 1e-9);
  EXPECT_FALSE(controller_->turnTo(99));
}

TEST_F(SessionControllerTest, WritesTheReport) {
  prepare();
  controller_->step();
  controller_->writeReport(path("report.html"), [](const AcquisitionState&) { return HtmlReportOptions{}; });
  EXPECT_TRUE(bytesOf(path("report.html")).contains("</html>"));
}

TEST_F(SessionControllerTest, TheTableStandsWhereTheLastScanWasTakenWhateverBecameOfIt) {
  failAScan();
  EXPECT_EQ(controller_->present().tablePosition(), kFarSide);
  EXPECT_NEAR(controller_->turnTo(kFarSide + 1)->turn.angle, -radians(15.0), 1e-9);
  controller_->undo();
  EXPECT_EQ(controller_->present().tablePosition(), kFarSide);
  EXPECT_NEAR(controller_->turnTo(kFarSide)->turn.angle, 0.0, 1e-9);
}

TEST_F(SessionControllerTest, ALeftOutViewDoesNotMoveTheTable) {
  prepare();
  controller_->step();
  controller_->step();
  const auto table = controller_->present().tablePosition();
  ASSERT_NE(table, 0);
  controller_->leaveOut(controller_->now()->scans.back().number);
  EXPECT_EQ(controller_->present().tablePosition(), table);
}

TEST_F(SessionControllerTest, AssistedNothingRunsByItself) {
  prepare();
  controller_->setMode(Mode::Assisted);
  QSignalSpy refused(controller_.get(), &SessionController::refused);
  controller_->run();
  EXPECT_FALSE(controller_->hasSession());
  ASSERT_EQ(refused.count(), 1);
  EXPECT_EQ(refused[0][0].toString(), controller_->permissions().whyNotRun());
  controller_->step();
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 1U);
}

TEST_F(SessionControllerTest, TheModeIsKeptInTheSession) {
  prepare();
  controller_->setMode(Mode::Assisted);
  controller_->step();
  const QString session = controller_->sessionPath();
  controller_ = nullptr;
  controller_ = make();
  controller_->open(session);
  EXPECT_EQ(controller_->mode(), Mode::Assisted);
}

TEST_F(SessionControllerTest, EndingHereSaysWhoEndedItAndWhatAFurtherViewWouldShow) {
  prepare();
  controller_->step();
  const int proposed = controller_->present().nextPosition().value();
  controller_->endHere();
  const QString ending = endingText(*controller_->now());
  EXPECT_TRUE(ending.startsWith("Ended by you. Position " + QString::number(proposed) + " would still show "))
      << ending.toStdString();
  EXPECT_EQ(controller_->present().moments().back().text, ending);
  controller_->writeReport(path("report.html"), [](const AcquisitionState&) { return HtmlReportOptions{}; });
  const QByteArray report = bytesOf(path("report.html"));
  EXPECT_TRUE(report.contains("Ended by the operator. A view from position " + QByteArray::number(proposed)));
  EXPECT_FALSE(report.contains("no position would show more"));
}

TEST_F(SessionControllerTest, GoesOnAfterAnEndThatTheOperatorWanted) {
  prepare();
  controller_->step();
  const int proposed = controller_->present().nextPosition().value();
  controller_->endHere();
  EXPECT_FALSE(controller_->present().nextPosition());
  EXPECT_EQ(controller_->present().furtherPosition(), proposed);
  EXPECT_EQ(controller_->permissions().whyNotRun(), "");
  controller_->step();
  EXPECT_EQ(controller_->now()->scans.back().station().position, proposed);
}

TEST_F(SessionControllerTest, GoesOnBeyondTheGreatestNumberOfViews) {
  prepare(2);
  controller_->run();
  ASSERT_EQ(controller_->now()->termination, Termination::MaxViews);
  EXPECT_TRUE(endingText(*controller_->now()).contains("would still show"));
  EXPECT_TRUE(controller_->permissions().whyNotRun().contains("Allow more"));
  const auto further = controller_->present().furtherPosition();
  controller_->allowMoreViews(1);
  EXPECT_EQ(controller_->present().nextPosition(), further);
  controller_->run();
  EXPECT_EQ(countScans(*controller_->now(), ScanStatus::In), 3U);
}

TEST_F(SessionControllerTest, AFailedScanIsTold) {
  failAScan();
  const QString told = failedScanText(*controller_->now());
  const RegistrationResult& registration = controller_->now()->scans.back().record.registration;
  EXPECT_TRUE(told.contains("from position 12 did not fit: " + translated(phraseOf(registration.finding))));
  EXPECT_TRUE(told.contains("take position 12 once more"));
  EXPECT_TRUE(controller_->present().moments().back().text.contains("did not fit"));
}

// What the panes take their next position from: the page, the views, the answer to why.
TEST_F(SessionControllerTest, AfterAFailedScanEverybodySpeaksOfTheSameNextPosition) {
  failAScan();
  const SharedState now = controller_->now();
  const auto next = controller_->present().nextPosition();
  ASSERT_TRUE(next);
  EXPECT_EQ(makeSnapshot(now)->next, next);
  EXPECT_EQ(objectiveChartData(*makeSnapshot(now)).chosen, next);
  EXPECT_EQ(controller_->present().proposedPosition(), next);
  EXPECT_EQ(roleOf(*now, *next), *next == now->plan->position ? PositionRole::Proposed : PositionRole::AfterFailure);
  EXPECT_EQ(roleOf(*now, kFarSide), PositionRole::Failed);
  controller_->step();
  EXPECT_EQ(controller_->now()->scans.back().station().position, next);
}

TEST_F(SessionControllerTest, EverybodySpeaksOfThePositionThatTheOperatorTook) {
  prepare();
  controller_->step();
  const int proposed = controller_->present().nextPosition().value();
  const int mine = (proposed + 2) % 24;
  controller_->choosePosition(mine);
  const SharedState now = controller_->now();
  const ObjectiveChartData chart = objectiveChartData(*makeSnapshot(now));
  EXPECT_EQ(chart.chosen, mine);
  EXPECT_TRUE(chart.operatorsChoice);
  EXPECT_EQ(roleOf(*now, mine), PositionRole::OperatorsChoice);
  EXPECT_NE(roleOf(*now, proposed), PositionRole::OperatorsChoice);
  EXPECT_EQ(controller_->present().proposedPosition(), proposed);
}

TEST_F(SessionControllerTest, RecordedScansAreShownAsWhatTheyAre) {
  controller_->open(importedSession());
  ASSERT_TRUE(controller_->hasSession()) << failure_.toStdString();
  EXPECT_EQ(controller_->page(), "review");
  EXPECT_TRUE(endingText(*controller_->now()).startsWith("Recorded scans, put together."));
  EXPECT_FALSE(controller_->present().nextPosition());
  EXPECT_FALSE(controller_->present().furtherPosition());
  EXPECT_FALSE(controller_->present().tablePosition());
  EXPECT_TRUE(controller_->permissions().whyNot(ChoosePosition{0}).startsWith("These are recorded scans"));
  EXPECT_FALSE(controller_->permissions().whyNotScan().isEmpty());
  EXPECT_TRUE(objectiveChartData(*makeSnapshot(controller_->now())).recorded);
  for (const KeptScan& scan : controller_->now()->scans) EXPECT_FALSE(areasKnown(scan.record));
}

TEST_F(SessionControllerTest, WhatCannotBeDoneIsRefusedAloud) {
  QSignalSpy refused(controller_.get(), &SessionController::refused);
  controller_->run();
  controller_->step();
  controller_->pause();
  controller_->stop();
  controller_->undo();
  controller_->redo();
  controller_->endHere();
  controller_->choosePosition(1);
  controller_->leaveOut(1);
  controller_->takeBack(1);
  controller_->allowMoreViews(1);
  controller_->testTurn();
  controller_->exportModel(path("none.stl"));
  EXPECT_EQ(refused.count(), 13);
  for (const auto& why : refused) EXPECT_TRUE(why[0].toString().endsWith('.')) << why[0].toString().toStdString();
}

}  // namespace
}  // namespace vantage
