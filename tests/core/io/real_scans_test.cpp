#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "base/errors.h"
#include "geometry/measures.h"
#include "io/mesh_reader.h"
#include "io/range_files.h"
#include "io/scan_poses.h"
#include "support/test_data.h"

namespace vantage {
namespace {

TEST(StanfordScans, HaveThePublishedNumberOfSamples) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  const auto bunny = *folder / "range_scans" / "stanford_bunny";
  std::size_t samples = 0;
  for (const ScanPose& pose : readScanPoses((bunny / "bun.conf").string(), 1000.0)) {
    const RangeGrid grid = readRangeGrid((bunny / pose.file).string());
    EXPECT_EQ(grid.scale, 1000.0) << pose.file;
    EXPECT_EQ(grid.samples.rows, 400);
    EXPECT_EQ(grid.samples.columns, 512);
    samples += grid.samples.points.size();
  }
  EXPECT_EQ(samples, 362272U);
}

TEST(StanfordScans, HaveRaysThatFormARegularGrid) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  const auto scans = *folder / "range_scans";
  for (const char* name : {"stanford_bunny/bun000.ply", "stanford_dragon_stand/dragonStandRight_0.ply",
                           "stanford_dragon_stand/dragonStandRight_72.ply"}) {
    const RangeImage image = readRangeFile((scans / name).string());
    validate(image);
    const RayGrid& rays = *image.rays;
    std::size_t found = 0;
    std::size_t asked = 0;
    for (std::size_t i = 0; i < rays.size(); i += 101) {
      const auto position = rays.locate(rays.ray(i).origin + 150.0 * rays.ray(i).direction);
      found += position && rays.nearest(*position) == i ? 1 : 0;
      ++asked;
    }
    EXPECT_EQ(found, asked) << name;
  }
}

TEST(StanfordScans, ReproduceTheirSamples) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  const std::string path = (*folder / "range_scans/stanford_dragon_stand/dragonStandRight_72.ply").string();
  const SampleGrid samples = readRangeGrid(path).samples;
  const RangeImage image = readRangeFile(path);
  ASSERT_EQ(image.sampleCount(), samples.points.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i)) worst = std::max(worst, (image.point(i) - samples.points[samples.cell[i]]).norm());
  EXPECT_LT(worst, 1e-4);
}

// Rows of "name r00 r01 r02 tx r10 ..." in metres.
std::map<std::string, Pose> readMatrices(const std::filesystem::path& path) {
  std::map<std::string, Pose> matrices;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#') || line.starts_with("scan\t")) continue;
    std::istringstream row(line);
    std::string name;
    row >> name;
    Pose pose = Pose::Identity();
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) row >> pose.matrix()(r, c);
    matrices[name] = pose;
  }
  return matrices;
}

TEST(StanfordScans, HaveThePosesOfTheirMatrices) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  for (const auto& [scans, list] :
       {std::pair("stanford_bunny", "bun.conf"), std::pair("stanford_dragon_stand", "dragonStandRight.conf")}) {
    const auto path = *folder / "range_scans" / scans;
    const auto poses = readScanPoses((path / list).string(), 1000.0);
    const auto matrices = readMatrices(path / "poses_4x4.tsv");
    EXPECT_EQ(poses.size(), matrices.size());
    for (const auto& [name, expected] : matrices) {
      const auto pose = findPose(poses, name);
      ASSERT_TRUE(pose) << name;
      EXPECT_LT((pose->linear() - expected.linear()).norm(), 1e-6) << name;
      EXPECT_LT((pose->translation() - 1000.0 * expected.translation()).norm(), 1e-4) << name;
    }
  }
}

TEST(Meshes, AllLoad) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  std::size_t loaded = 0;
  for (const std::string& path : testing::filesBelow(*folder / "meshes")) {
    if (path.ends_with(".md")) continue;
    EXPECT_NO_THROW({
      const LoadedMesh mesh = loadMesh(path);
      EXPECT_LT(mesh.repair.dropped(), mesh.mesh.triangles.size() / 20 + 1) << path << ": " << describe(mesh.repair);
    }) << path;
    ++loaded;
  }
  EXPECT_GT(loaded, 60U);
}

TEST(Meshes, TheReconstructedBunnyHasThePublishedSize) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  const LoadedMesh bunny = loadMesh((*folder / "range_scans/stanford_bunny/reconstruction/bun_zipper.ply").string());
  EXPECT_EQ(bunny.mesh.triangles.size() + bunny.repair.dropped(), 69451U);
  EXPECT_EQ(bunny.mesh.vertices.size() + bunny.repair.unusedVertices + bunny.repair.mergedVertices, 35947U);
}

}  // namespace
}  // namespace vantage
