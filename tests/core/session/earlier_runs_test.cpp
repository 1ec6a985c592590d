#include <gtest/gtest.h>

#include <optional>

#include "acquisition/apply_command.h"
#include "earlier_versions.h"
#include "geometry/measures.h"
#include "positional_space/scanner_images.h"
#include "session/session_blobs.h"

namespace vantage {
namespace {

using testing::earlierSession;
using testing::earlierTools;
using testing::EarlierVersions;
using testing::lastModelOf;
using testing::textsOf;

// How far poses may lie from those that a program of another time found with the same options [mm and rad].
constexpr double kSamePose = 0.01;

void expectSameModel(const Model& model, const Model& then, const std::string& what) {
  const auto triangles = static_cast<double>(then.mesh.triangles.size());
  EXPECT_NEAR(static_cast<double>(model.mesh.triangles.size()), triangles, 0.01 * triangles) << what;
  EXPECT_NEAR(area(model.mesh), area(then.mesh), 0.002 * area(then.mesh)) << what;
}

void expectSamePlan(const Plan& plan, const Plan& then, const std::string& what) {
  EXPECT_EQ(plan.outcome, then.outcome) << what;
  EXPECT_EQ(plan.position, then.position) << what;
}

// Every model of these files was made by the program of its time. What its commands mean has not changed: the engine
// comes to the same views and plans, and to the same surface as near as registration has become another.
TEST_F(EarlierVersions, TheirCommandsStillLeadToTheSameModels) {
  for (const std::string name : {"schema_2_ended", "schema_2_steered", "schema_2_imported"}) {
    const Session session = Session::open(earlierSession(name), SessionAccess::Read);
    std::optional<ScannerImages> images;
    if (session.profile()) images = computeScannerImages(*session.profile());
    const CommandInput input{[&](std::int64_t number) { return session.scan(number); }, images ? &*images : nullptr};
    AcquisitionState state;
    state.profile = session.profile();
    for (std::size_t i = 0; i < session.history().size(); ++i) {
      state = applyCommand(state, session.history().entry(i).command, input, {});
      const auto then = session.state(i);
      ASSERT_EQ(state.scans.size(), then->scans.size()) << name << " " << i;
      EXPECT_EQ(state.termination, then->termination) << name << " " << i;
      EXPECT_EQ(state.chosenPosition, then->chosenPosition) << name << " " << i;
      ASSERT_EQ(state.model == nullptr, then->model == nullptr) << name << " " << i;
      const std::string what = name + " " + std::to_string(i);
      if (state.model) expectSameModel(*state.model, *then->model, what);
      ASSERT_EQ(state.plan == nullptr, then->plan == nullptr) << name << " " << i;
      if (state.plan) expectSamePlan(*state.plan, *then->plan, what);
      for (std::size_t k = 0; k < state.scans.size(); ++k) {
        EXPECT_EQ(state.scans[k].status, then->scans[k].status) << name << " " << i;
        const Eigen::Matrix4d away =
            state.scans[k].view.T_object_scanner.matrix() - then->scans[k].view.T_object_scanner.matrix();
        EXPECT_LT(away.cwiseAbs().maxCoeff(), kSamePose) << what << " " << k;
      }
    }
  }
}

// Takes out what was undone, with the scan that it had taken.
void cutOffUndone(const std::string& path) {
  Database database(path, Database::Mode::Write);
  const std::string cursor = textsOf(database, "SELECT value FROM meta WHERE key = 'cursor'").at(0);
  for (const char* table : {"view WHERE step", "record WHERE step", "plan WHERE step", "model WHERE step",
                            "event WHERE step", "step WHERE id"})
    database.run(std::string("DELETE FROM ") + table + " > " + cursor);
  database.run("DELETE FROM scan WHERE id NOT IN (SELECT scan FROM view)");
  database.run("UPDATE meta SET value = '" + cursor + "' WHERE key = 'tip'");
}

// The last model of each file is what the program of its time came to from the state that holds, with the same scanner
// and seed.
TEST_F(EarlierVersions, GoOnToWhatTheProgramOfTheirTimeCameTo) {
  for (const std::string name : {"schema_2_taken_over", "schema_2_ended"}) {
    const Model expected = modelFromBlob(lastModelOf(earlierSession(name)), name);
    const std::string path = copyOf(name);
    cutOffUndone(path);
    Session session = Session::open(path, SessionAccess::Write);
    ASSERT_EQ(countScans(*session.state(), ScanStatus::In), 2U) << name;
    Acquisition acquisition(session, earlierTools(session));
    if (session.state()->termination != Termination::Running) acquisition.carryOut(Finish{Termination::Running});
    EXPECT_EQ(acquisition.runUntilTheEnd(), Termination::MaxViews) << name;
    expectSameModel(*session.state()->model, expected, name);
    EXPECT_EQ(session.scanCount(), 3) << name;
  }
}

TEST_F(EarlierVersions, TheFirstVersionGoesOnAsTheSecondWentOnWithIt) {
  Session session = Session::open(copyOf("schema_1"), SessionAccess::Write);
  Acquisition acquisition(session, earlierTools(session));
  EXPECT_EQ(acquisition.runUntilTheEnd(), Termination::MaxViews);
  const auto then = lastModelOf(earlierSession("schema_2_taken_over"));
  expectSameModel(*session.state()->model, modelFromBlob(then, "schema_2_taken_over"), "schema_1");
}

TEST_F(EarlierVersions, OneThatIsSteeredGoesOnFromTheChosenPosition) {
  Session session = Session::open(copyOf("schema_2_steered"), SessionAccess::Write);
  Acquisition acquisition(session, earlierTools(session));
  acquisition.scanNext();
  ASSERT_EQ(session.state()->scans.size(), 4U);
  EXPECT_EQ(session.state()->scans[3].station().position, 5);
  EXPECT_FALSE(session.state()->chosenPosition);
  acquisition.carryOut(TakeBackView{0});
  EXPECT_EQ(session.state()->scans[0].status, ScanStatus::In);
}

TEST_F(EarlierVersions, ModelsThatWereLostAreMadeAgain) {
  const std::string path = copyOf("schema_2_ended");
  Database(path, Database::Mode::Write).run("DELETE FROM model");
  const Session session = Session::open(path, SessionAccess::Read);
  expectSameModel(*session.state(5)->model, modelFromBlob(lastModelOf(earlierSession("schema_2_ended")), "ended"),
                  "schema_2_ended");
}

}  // namespace
}  // namespace vantage
