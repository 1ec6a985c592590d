#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "composites/composite_alignment.h"
#include "integration/consensus.h"
#include "integration/zipper.h"
#include "io/range_files.h"
#include "io/scan_poses.h"
#include "registration/alignment.h"
#include "support/test_data.h"

namespace vantage {
namespace {

struct NamedView {
  std::string file;
  View view;
};

// The scans of a .conf file in metres, placed from their published poses.
std::vector<NamedView> readRegistered(const std::filesystem::path& conf) {
  std::vector<NamedView> named;
  std::vector<View> views;
  for (const ScanPose& pose : readScanPoses(conf.string(), 1000.0)) {
    auto image = std::make_shared<RangeImage>(readRangeFile((conf.parent_path() / pose.file).string()));
    image->T_table_scanner = pose.T_object_scanner;
    View view;
    view.mesh = std::make_shared<const ViewMesh>(triangulate(*image, TriangulationOptions()));
    view.image = std::move(image);
    view.T_object_scanner = pose.T_object_scanner;
    views.push_back(view);
    named.push_back({pose.file, std::move(view)});
  }
  const AlignmentResult all = registerViews(views, {}, Progress({}, {}, 2));
  for (std::size_t i = 0; i < named.size(); ++i) named[i].view.T_object_scanner = all.poses[i];
  return named;
}

// Some of the scans as if nothing of the others were known: registered with each other only, in a frame of their own.
Composite halfOf(const std::vector<NamedView>& all, const std::set<std::string>& files, const Pose& T_half_object) {
  std::vector<View> views;
  for (const NamedView& each : all)
    if (files.count(each.file) > 0) views.push_back(each.view);
  const AlignmentResult alone = registerViews(views, {}, Progress({}, {}, 2));
  for (std::size_t i = 0; i < views.size(); ++i) views[i].T_object_scanner = T_half_object * alone.poses[i];
  Composite half;
  half.model = std::make_shared<const Model>(applyConsensus(zipper(views, {}).model, views, {}));
  half.views = std::move(views);
  return half;
}

// Where the found poses of two halves put the points of the second one, against where all scans together have them:
// the largest distance over its views [mm].
double worstOffset(const std::vector<NamedView>& truth, const Composite& a, const Composite& b, const Pose& T_a_b) {
  const auto truePose = [&](const View& view) {
    return std::find_if(truth.begin(), truth.end(), [&](const NamedView& n) { return n.view.image == view.image; })
        ->view.T_object_scanner;
  };
  const Pose T_object_a = truePose(a.views[0]) * a.views[0].T_object_scanner.inverse();
  double worst = 0.0;
  for (const View& view : b.views) {
    double sum = 0.0;
    const std::vector<Vec3>& points = view.mesh->mesh.vertices;
    for (std::size_t k = 0; k < points.size(); k += 37)
      sum += (T_object_a * T_a_b * view.T_object_scanner * points[k] - truePose(view) * points[k]).norm();
    worst = std::max(worst, 37.0 * sum / static_cast<double>(points.size()));
  }
  return worst;
}

TEST(RealComposites, TwoHalvesOfTheBunnyComeTogether) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  const auto all = readRegistered(*folder / "range_scans/stanford_bunny/bun.conf");
  Pose unknown(Eigen::AngleAxisd(radians(137.0), Vec3(0.3, -0.8, 0.5).normalized()));
  unknown.translation() = Vec3(45.0, -130.0, 62.0);
  const Composite front =
      halfOf(all, {"bun000.ply", "bun045.ply", "bun090.ply", "bun315.ply", "top2.ply"}, Pose::Identity());
  const Composite back = halfOf(all, {"bun180.ply", "bun270.ply", "top3.ply", "chin.ply", "ear_back.ply"}, unknown);
  const CompositeAlignment found =
      alignComposites(CompositeModel(front), CompositeModel(back), {}, Progress({}, {}, 2));
  ASSERT_FALSE(found.poses.empty());
  EXPECT_EQ(found.verdict(), AlignmentVerdict::Good);
  EXPECT_LE(worstOffset(all, front, back, found.poses.front().T_reference_moved), 0.5);
}

}  // namespace
}  // namespace vantage
