#include "acquisition/session_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "acquisition/session_blobs.h"
#include "base/errors.h"
#include "small_scene.h"

namespace vantage {
namespace {

class SessionFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / (std::string("vantage_session_") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    path_ = (folder_ / "test.vantage").string();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] AcquisitionState saveTwoViews() const {
    AcquisitionSettings settings;
    settings.object = "small";
    settings.maxViews = 2;
    settings.tolerance = 0.3;
    SessionFile session = SessionFile::create(path_, testing::smallProfileSource(), settings);
    return testing::acquireSmallObject(settings, 2, [&](const AcquisitionState& state) { session.save(state); });
  }

  std::filesystem::path folder_;
  std::string path_;
};

TEST_F(SessionFileTest, BringsBackWhatWasSavedBitByBit) {
  const AcquisitionState saved = saveTwoViews();
  const Session loaded = SessionFile::open(path_).load(Progress());
  EXPECT_EQ(loaded.settings.object, "small");
  EXPECT_EQ(loaded.settings.maxViews, 2);
  EXPECT_EQ(loaded.settings.tolerance, 0.3);
  ASSERT_EQ(loaded.state.views.size(), saved.views.size());
  for (std::size_t i = 0; i < saved.views.size(); ++i) {
    EXPECT_EQ(loaded.state.views[i].T_object_scanner.matrix(), saved.views[i].T_object_scanner.matrix());
    EXPECT_EQ(loaded.state.views[i].image->position, saved.views[i].image->position);
    EXPECT_EQ(rangeBlob(loaded.state.views[i].image->range), rangeBlob(saved.views[i].image->range));
    EXPECT_EQ(loaded.state.views[i].mesh->mesh.triangles, saved.views[i].mesh->mesh.triangles);
  }
  EXPECT_EQ(modelBlob(*loaded.state.model), modelBlob(*saved.model));
}

TEST_F(SessionFileTest, PlansTheSameAfterReopening) {
  const AcquisitionState saved = saveTwoViews();
  const Session loaded = SessionFile::open(path_).load(Progress());
  const ScannerImages images = computeScannerImages(*loaded.state.profile);
  const Plan plan = planAfter(loaded.state, images, stepOptionsFor(*loaded.state.profile, loaded.settings), Progress());
  const Plan& before = *saved.records.back().plan;
  EXPECT_EQ(plan.position, before.position);
  for (std::size_t i = 0; i < plan.scores.size(); ++i) EXPECT_EQ(plan.scores[i].voidArea, before.scores[i].voidArea);
}

TEST_F(SessionFileTest, KeepsTheRaysOfRecordedScans) {
  const auto profile = testing::smallProfile();
  SimulatedScanner scanner(testing::smallObject(), profile, {});
  AcquisitionState state;
  View view;
  view.image = std::make_shared<const RangeImage>(scanner.scan(3, Progress()));
  view.mesh = std::make_shared<const ViewMesh>(triangulate(*view.image, {}));
  state.views.push_back(view);
  SessionFile::create(path_, std::nullopt, {}).save(state);
  const Session loaded = SessionFile::open(path_).load(Progress());
  ASSERT_EQ(loaded.state.views.size(), 1U);
  EXPECT_EQ(raysBlob(*loaded.state.views[0].image->rays), raysBlob(*profile->rays));
}

TEST_F(SessionFileTest, RefusesWhatIsNoSession) {
  EXPECT_THROW(static_cast<void>(SessionFile::open((folder_ / "missing.vantage").string())), IoError);
  std::ofstream(path_) << "not a database at all, but long enough to be looked at";
  EXPECT_THROW(static_cast<void>(SessionFile::open(path_)), IoError);
  std::filesystem::remove(path_);
  Database(path_, Database::Mode::Create).run("CREATE TABLE other(x)");
  EXPECT_THROW(static_cast<void>(SessionFile::open(path_)), InvalidInput);
}

TEST_F(SessionFileTest, SaysWhichPartIsDamaged) {
  static_cast<void>(saveTwoViews());
  Database(path_, Database::Mode::Open).run("UPDATE scan SET range = x'00112233' WHERE id = 1");
  try {
    static_cast<void>(SessionFile::open(path_).load(Progress()));
    FAIL() << "a damaged scan was read";
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("scan 1"), std::string::npos) << e.what();
  }
}

TEST(SessionBlobs, RefuseEveryTruncation) {
  Model model;
  model.mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  model.mesh.triangles = {{0, 1, 2}};
  model.confidence = {1, 1, 1};
  model.vertexView = model.vertexSample = {0, 0, 0};
  model.triangleView = {0};
  const auto blob = modelBlob(model);
  EXPECT_EQ(modelFromBlob(blob, "model").mesh.triangles, model.mesh.triangles);
  for (std::size_t size = 0; size < blob.size(); ++size)
    EXPECT_THROW(static_cast<void>(modelFromBlob(std::span(blob).first(size), "model")), InvalidInput) << size;
}

}  // namespace
}  // namespace vantage
