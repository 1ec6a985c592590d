#include "session/model_writer.h"

#include <gtest/gtest.h>

#include "faulty_storage.h"
#include "session/session_blobs.h"
#include "session/session_schema.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

const std::shared_ptr<const Model>& smallModel() {
  static const std::shared_ptr<const Model> model = [] {
    AcquisitionSettings settings;
    settings.maxViews = 1;
    return testing::acquireSmallObject(settings, 1).model;
  }();
  return model;
}

class ModelWriterTest : public ::testing::Test {
 protected:
  ModelWriterTest() : store_(Database(folder_.file("test.vantage"), Database::Mode::Create)) {
    createSessionTables(store_.database());
  }

  // The disk is read as another program would see it.
  [[nodiscard]] std::shared_ptr<const Model> onDisk(std::int64_t step) const {
    return SessionStore(Database(folder_.file("test.vantage"), Database::Mode::Read)).model(step);
  }

  testing::TemporaryFolder folder_;
  testing::FaultyStorage storage_;
  SessionStore store_;
  std::recursive_mutex mutex_;
};

TEST_F(ModelWriterTest, WritesAModelWhileTheCallerGoesOn) {
  ModelWriter writer(store_, mutex_);
  {
    const std::lock_guard writingWaits(mutex_);
    writer.write(1, smallModel());
    EXPECT_EQ(onDisk(1), nullptr);
  }
  writer.settle();
  ASSERT_NE(onDisk(1), nullptr);
  EXPECT_EQ(modelBlob(*onDisk(1)), modelBlob(*smallModel()));
}

TEST_F(ModelWriterTest, OneThatComesWhileAnotherIsWrittenIsWrittenAtOnce) {
  ModelWriter writer(store_, mutex_);
  {
    const std::lock_guard firstWaits(mutex_);
    writer.write(1, smallModel());
    writer.write(2, smallModel());
    EXPECT_EQ(onDisk(1), nullptr);
    EXPECT_NE(onDisk(2), nullptr);
  }
  writer.settle();
  EXPECT_NE(onDisk(1), nullptr);
}

TEST_F(ModelWriterTest, EndsWhenEverythingIsWritten) {
  {
    ModelWriter writer(store_, mutex_);
    writer.write(1, smallModel());
  }
  EXPECT_NE(onDisk(1), nullptr);
}

TEST_F(ModelWriterTest, DoesNotHoldAModelThatItHasWritten) {
  ModelWriter writer(store_, mutex_);
  auto model = std::make_shared<const Model>(*smallModel());
  const std::weak_ptr<const Model> watched = model;
  writer.write(1, std::move(model));
  writer.settle();
  EXPECT_TRUE(watched.expired());
}

TEST_F(ModelWriterTest, AFullDiskLosesTheModelAndNothingElse) {
  ModelWriter writer(store_, mutex_);
  storage_.fillAfter(0);
  writer.write(1, smallModel());
  writer.settle();
  storage_.heal();
  EXPECT_EQ(onDisk(1), nullptr);
  EXPECT_TRUE(store_.database().sound());
  writer.write(2, smallModel());
  writer.settle();
  EXPECT_NE(onDisk(2), nullptr);
}

}  // namespace
}  // namespace vantage
