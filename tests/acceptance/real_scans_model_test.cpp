#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "acquisition/import_scans.h"
#include "geometry/measures.h"
#include "geometry/ray_caster.h"
#include "io/mesh_reader.h"
#include "io/range_files.h"
#include "io/scan_poses.h"
#include "support/test_data.h"

// Recorded scans of a Cyberware scanner become models with as few openings as the object has for it.

namespace vantage {
namespace {

// In the order of the file names, as a shell gives them.
Mesh importedModel(const std::filesystem::path& conf) {
  const std::vector<ScanPose> poses = readScanPoses(conf.string(), 1000.0);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(conf.parent_path()))
    if (entry.path().extension() == ".ply") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  std::vector<NumberedScan> scans;
  for (const std::string& file : files) {
    RangeImage image = readRangeFile(file);
    image.T_table_scanner = findPose(poses, file).value();
    image.poseKnownBy = PoseSource::Reported;
    scans.push_back({static_cast<std::int64_t>(scans.size()), std::make_shared<const RangeImage>(std::move(image))});
  }
  const AcquisitionState empty;
  return importScans(empty, scans, importOptionsFor(empty), Progress({}, {}, 2)).model->mesh;
}

// Distances of the vertices of a mesh from another, ascending; those farther away than 5 mm count as that [mm].
std::vector<double> distances(const Mesh& from, const Mesh& to) {
  const RayCaster surface(to);
  std::vector<double> result;
  for (std::size_t v = 0; v < from.vertices.size(); v += 3) {
    const auto closest = surface.closestPoint(from.vertices[v], 5.0);
    result.push_back(closest ? (closest->point - from.vertices[v]).norm() : 5.0);
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(RealScans, BunnyIsOnePieceWithTheOpeningsThatNoScanSees) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  const auto bunny = *folder / "range_scans/stanford_bunny";
  const Mesh model = importedModel(bunny / "bun.conf");
  const MeshMeasures measures = measure(model);
  EXPECT_EQ(measures.components, 1U);
  EXPECT_LE(measures.boundaryLoops, 10U);
  EXPECT_EQ(measures.nonManifoldEdges, 0U);

  Mesh published = loadMesh((bunny / "reconstruction/bun_zipper.ply").string()).mesh;
  for (Vec3& v : published.vertices) v *= 1000.0;
  const std::vector<double> off = distances(model, published);
  EXPECT_LE(off[off.size() / 2], 0.06);
  EXPECT_LE(off[off.size() * 95 / 100], 0.28);
  const std::vector<double> uncovered = distances(published, model);
  const auto covered = std::upper_bound(uncovered.begin(), uncovered.end(), 0.75) - uncovered.begin();
  EXPECT_GE(static_cast<double>(covered), 0.9995 * static_cast<double>(uncovered.size()));
}

// Its scales hide the surface between them from all fifteen scans around it.
TEST(RealScans, DragonIsThreePiecesAtMost) {
  VANTAGE_NEEDS_TEST_DATA(folder);
  const Mesh model = importedModel(*folder / "range_scans/stanford_dragon_stand/dragonStandRight.conf");
  const MeshMeasures measures = measure(model);
  EXPECT_LE(measures.components, 3U);
  EXPECT_LE(measures.boundaryLoops, 85U);
  EXPECT_EQ(measures.nonManifoldEdges, 0U);
}

}  // namespace
}  // namespace vantage
