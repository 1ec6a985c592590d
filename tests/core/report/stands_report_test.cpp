#include "report/stands_report.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

KeptScan scanOf(std::int64_t number, int stand, ScanStatus status) {
  auto image = std::make_shared<RangeImage>();
  image->station.stand = stand;
  KeptScan scan;
  scan.number = number;
  scan.status = status;
  scan.view.image = image;
  return scan;
}

TEST(StandsReport, SaysOfEveryStandHowTheObjectStoodAndWhatCameOfIt) {
  AcquisitionState state;
  Pose lying = Pose::Identity();
  lying.rotate(Eigen::AngleAxisd(radians(90.0), Vec3::UnitX()));
  StandAlignment failed;
  failed.candidates.emplace_back();
  state.stands.push_back({lying});
  state.stands.push_back({{}, {}, std::make_shared<const StandAlignment>(failed)});
  state.scans = {scanOf(0, 0, ScanStatus::Aside), scanOf(1, 1, ScanStatus::Rejected), scanOf(2, 1, ScanStatus::Aside),
                 scanOf(3, 2, ScanStatus::In)};
  const auto stands = standsJson(state);
  ASSERT_EQ(stands.size(), 3U);
  EXPECT_EQ(stands[0]["verdict"], "reference");
  EXPECT_EQ(stands[0]["views"].dump(), "[0]");
  EXPECT_EQ(stands[0]["rotation"][0], 1.0);
  // Views are counted as those of the object, scans by their numbers.
  EXPECT_EQ(stands[1]["views"].dump(), "[1]");
  EXPECT_EQ(stands[1]["scans"].dump(), "[1,2]");
  EXPECT_EQ(stands[1]["verdict"], "good");
  // From object to table: what points up on the object lies along y.
  EXPECT_NEAR(stands[1]["rotation"][5].get<double>(), 1.0, 1e-12);
  EXPECT_EQ(stands[2]["verdict"], "failed");
  EXPECT_EQ(stands[2]["reason_code"], "other_object");
  EXPECT_TRUE(stands[2]["rotation"].is_null());
  EXPECT_TRUE(stands[2]["views"].empty());
  EXPECT_EQ(stands[2]["candidates"].size(), 1U);
}

}  // namespace
}  // namespace vantage
