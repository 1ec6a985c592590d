#include "acquisition/table_place.h"

#include <gtest/gtest.h>

#include "acquisition/acquisition.h"
#include "acquisition/memory_journal.h"
#include "scanner/table_stand.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// Positions of the small workspace by which the table slips before the fourth scan.
constexpr int kSlip = 2;

double stepOf(const ScannerProfile& profile) {
  return 2.0 * kPi / static_cast<double>(profile.workspace.size());
}

// A table that slips and does not know.
class SlippingTable final : public Positioner {
 public:
  explicit SlippingTable(std::shared_ptr<const ScannerProfile> profile, std::shared_ptr<Positioner> inner)
      : profile_(std::move(profile)), inner_(std::move(inner)) {}
  [[nodiscard]] std::string identity() const override { return "slipping table"; }
  void open(const Progress& progress) override { inner_->open(progress); }
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return inner_->notReady(); }
  [[nodiscard]] ReachedPose moveTo(int position, const Progress& progress) override {
    const auto positions = static_cast<int>(profile_->workspace.size());
    static_cast<void>(inner_->moveTo((position + (++moves == 4 ? kSlip : 0)) % positions, progress));
    return {position, profile_->workspace.poses[static_cast<std::size_t>(position)], PoseSource::Reported, {}};
  }
  void standsFarther(double angle) override { farther.push_back(angle); }
  [[nodiscard]] std::optional<ReachedPose> where() const override { return {}; }

  int moves = 0;
  std::vector<double> farther;

 private:
  std::shared_ptr<const ScannerProfile> profile_;
  std::shared_ptr<Positioner> inner_;
};

TEST(TablePlace, ASlipThatAScanShowsIsToldToTheTableAndKnownLater) {
  AcquisitionSettings settings;
  settings.registration.limits.fewPairs = 100;  // the scans are small
  const auto profile = testing::smallProfile();
  MemoryJournal journal(profile, settings);
  AcquisitionTools tools = testing::smallTools(profile, settings, 0);
  const auto table = std::make_shared<SlippingTable>(profile, tools.rig->positioner);
  tools.rig->positioner = table;
  Acquisition acquisition(journal, tools);
  for (const int position : {0, 1, 2}) {
    acquisition.carryOut(ChoosePosition{position});
    acquisition.scanNext();
    EXPECT_EQ(tableStand(journal), (TableStand{position, 0.0, 0.0}));
  }
  EXPECT_TRUE(table->farther.empty());
  acquisition.carryOut(ChoosePosition{3});
  acquisition.scanNext();
  ASSERT_EQ(journal.state()->scans.back().record.registration.finding.reason, VerdictReason::TableSlipped);
  ASSERT_EQ(table->farther.size(), 1U);
  const double slip = kSlip * stepOf(*profile);
  EXPECT_NEAR(table->farther[0], slip, radians(0.5));
  const auto stand = tableStand(journal);
  ASSERT_TRUE(stand);
  EXPECT_EQ(stand->position, 3);
  EXPECT_NEAR(stand->counted, 0.0, 1e-9);
  EXPECT_NEAR(stand->farther, slip, radians(0.5));
}

TEST(TablePlace, IsTheFirstPositionBeforeAnyScan) {
  const MemoryJournal journal(testing::smallProfile(), {});
  EXPECT_EQ(tableStand(journal), TableStand{});
  EXPECT_EQ(tablePosition(journal), 0);
}

}  // namespace
}  // namespace vantage
