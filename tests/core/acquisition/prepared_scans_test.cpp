#include "acquisition/prepared_scans.h"

#include <gtest/gtest.h>

#include <memory>

#include "acquisition/step_options.h"
#include "acquisition/steps.h"
#include "support/scenes/small_scene.h"

namespace vantage::testing {
namespace {

AcquisitionSettings threeViews() {
  AcquisitionSettings settings;
  settings.maxViews = 3;
  return settings;
}

TEST(PreparedScans, AreMadeOnceForAllSteps) {
  const AcquisitionState state = acquireSmallObject(threeViews(), 1);
  const auto scans = scansOf(state, ScanStatus::In);
  ASSERT_EQ(scans.size(), 3U);
  const auto prepared = preparedViews(scans, {});
  for (std::size_t i = 0; i < scans.size(); ++i) {
    ASSERT_TRUE(scans[i]->prepared) << i;
    EXPECT_EQ(scans[i]->prepared->mesh, scans[i]->view.mesh) << i;
    EXPECT_EQ(&prepared[i].points.normalAt(0), &scans[i]->prepared->points.normalAt(0)) << i;
  }
}

TEST(PreparedScans, AreMadeAnewOfAnotherMesh) {
  KeptScan scan = acquireSmallObject(threeViews(), 1).scans.back();
  scan.view.mesh = std::make_shared<const ViewMesh>(*scan.view.mesh);
  EXPECT_EQ(preparedViews({&scan}, {}).front().mesh, scan.view.mesh);
  AcquisitionState none;
  prepareScans(none, scan, {});
  EXPECT_EQ(scan.prepared->mesh, scan.view.mesh);
}

TEST(PreparedScans, ChangeNothingThatAStepComesTo) {
  int steps = 0;
  static_cast<void>(acquireSmallObject(
      threeViews(), 1, [&](const Command& command, const AcquisitionState& before, const AcquisitionState& after) {
        if (!std::holds_alternative<AddScan>(command)) return;
        ++steps;
        AcquisitionState bare = before;
        for (KeptScan& scan : bare.scans) scan.prepared.reset();
        const KeptScan& added = after.scans.back();
        const AcquisitionState again =
            addScan(bare, {added.number, added.view.image}, {}, stepOptionsFor(bare), Progress({}, {}, 2));
        ASSERT_EQ(again.scans.size(), after.scans.size());
        for (std::size_t i = 0; i < again.scans.size(); ++i)
          EXPECT_TRUE(again.scans[i].view.T_object_scanner.matrix() == after.scans[i].view.T_object_scanner.matrix());
        EXPECT_EQ(again.model->mesh.vertices, after.model->mesh.vertices);
      }));
  EXPECT_EQ(steps, 3);
}

}  // namespace
}  // namespace vantage::testing
