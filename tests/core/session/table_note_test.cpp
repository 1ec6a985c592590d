#include "session/table_note.h"

#include <gtest/gtest.h>

#include "acquisition/acquisition.h"
#include "acquisition/table_place.h"
#include "base/errors.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

namespace vantage {
namespace {

// Goes where it is asked to, or stops on the way and knows where, or not.
class StoppingTable final : public Positioner {
 public:
  explicit StoppingTable(std::shared_ptr<const ScannerProfile> profile) : profile_(std::move(profile)) {}
  [[nodiscard]] std::string identity() const override { return "stopping table"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }
  [[nodiscard]] ReachedPose moveTo(int position, const Progress& /*progress*/) override {
    if (stops) throw DeviceError("stopping table: has stopped");
    where_ = {position, profile_->workspace.poses[static_cast<std::size_t>(position)], PoseSource::Reported, {}};
    return *where_;
  }
  [[nodiscard]] std::optional<ReachedPose> where() const override { return where_; }

  // Stands beyond a position, or nobody knows.
  void standAt(std::optional<int> position, double beyond = 0.0) {
    where_.reset();
    if (!position) return;
    const Pose& nominal = profile_->workspace.poses[static_cast<std::size_t>(*position)];
    where_ = {*position, Eigen::AngleAxisd(beyond, Vec3::UnitZ()) * nominal, PoseSource::Reported, {}};
  }
  bool stops = false;

 private:
  std::shared_ptr<const ScannerProfile> profile_;
  std::optional<ReachedPose> where_;
};

class TableNote : public ::testing::Test {
 protected:
  [[nodiscard]] TableLeft left() const { return tableLeft(session_).value_or(TableLeft{{-1, 0.0, 0.0}, {}}); }

  testing::TemporaryFolder folder_;
  Session session_ = testing::createSmallSession(folder_.file("a.vantage"), {});
  std::shared_ptr<StoppingTable> table_ = std::make_shared<StoppingTable>(session_.profile());
  Rig rig_ = remarked({nullptr, table_}, session_);
};

TEST_F(TableNote, IsWhereTheTableStandsAlsoWhenNoScanCameOfIt) {
  EXPECT_EQ(left().stand, TableStand{});
  static_cast<void>(rig_.positioner->moveTo(7, {}));
  EXPECT_EQ(left().stand, (TableStand{7, 0.0, 0.0}));
  EXPECT_FALSE(left().underWayTo);
  EXPECT_EQ(tablePosition(session_), 0) << "of scans";
}

TEST_F(TableNote, IsWhereAMoveEndedThatFailed) {
  static_cast<void>(rig_.positioner->moveTo(7, {}));
  table_->stops = true;
  table_->standAt(9, radians(-3.0));
  EXPECT_THROW(static_cast<void>(rig_.positioner->moveTo(12, {})), DeviceError);
  EXPECT_EQ(left().stand.position, 9);
  EXPECT_NEAR(left().stand.counted, radians(-3.0), 1e-9);
  EXPECT_FALSE(left().underWayTo);
}

TEST_F(TableNote, SaysWhenNobodyKnows) {
  table_->stops = true;
  table_->standAt({});
  EXPECT_THROW(static_cast<void>(rig_.positioner->moveTo(12, {})), DeviceError);
  EXPECT_EQ(left().stand, TableStand{});
  EXPECT_EQ(left().underWayTo, 12);
}

}  // namespace
}  // namespace vantage
