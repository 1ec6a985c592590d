#include "io/file_info.h"

#include "core/io/expect_error.h"
#include "io/mesh_writer.h"
#include "support/meshes.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

std::int64_t countOf(const FileInfo& info, const std::string& key) {
  return std::get<std::int64_t>(info.at(key));
}

TEST(DescribeFile, CountsAMesh) {
  const TemporaryFolder folder;
  const Mesh sheet = testing::makeGrid(4, 3, 2.0);
  exportMesh(testing::joined(sheet, testing::makeBox({0, 0, 10}, {1, 1, 11})), folder.file("a.obj"));
  const FileInfo info = describeFile(folder.file("a.obj"));
  EXPECT_EQ(info.content, FileContent::Mesh);
  EXPECT_EQ(countOf(info, "vertices"), 28);
  EXPECT_EQ(countOf(info, "triangles"), 36);
  EXPECT_EQ(countOf(info, "components"), 2);
  EXPECT_EQ(countOf(info, "boundary_edges"), 14);
  EXPECT_EQ(countOf(info, "boundary_loops"), 1);
  EXPECT_EQ(countOf(info, "non_manifold_edges"), 0);
  EXPECT_EQ(toText(info.at("area_mm2")), "54");
  EXPECT_EQ(toText(info.at("extent_mm")), "8 x 6 x 11");
  EXPECT_THROW(static_cast<void>(info.at("repairs")), InvalidInput);
}

TEST(DescribeFile, TellsModelsFromMeshes) {
  const TemporaryFolder folder;
  Model model;
  model.mesh = testing::makeGrid(2, 2, 1.0);
  model.confidence.assign(9, 0.5F);
  model.triangleView = {0, 0, 0, 4, 4, 4, 2, 2};
  exportModel(model, folder.file("model.ply"));
  const FileInfo info = describeFile(folder.file("model.ply"));
  EXPECT_EQ(info.content, FileContent::Model);
  EXPECT_EQ(countOf(info, "views"), 3);
  EXPECT_EQ(toText(info.at("mean_confidence")), "0.5");
}

TEST(DescribeFile, SaysThatPointsAreOnlyPoints) {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.write("a.obj", "v 0 0 0\nv 1 2 3\n"),
                                  folder.write("a.ply",
                                               "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty "
                                               "float y\nproperty float z\nend_header\n0 0 0\n1 2 3\n")}) {
    const FileInfo info = describeFile(path);
    EXPECT_EQ(nameOf(info.content), "points");
    EXPECT_EQ(countOf(info, "points"), 2);
    EXPECT_EQ(countOf(info, "triangles"), 0);
    EXPECT_EQ(toText(info.at("extent")), "1 x 2 x 3");
  }
}

TEST(DescribeFile, ReportsRepairs) {
  const TemporaryFolder folder;
  const FileInfo info = describeFile(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\nf 1 1 2\n"));
  EXPECT_EQ(toText(info.at("repairs")), "1 face without an area dropped, 1 unused vertex left out");
}

TEST(DescribeFile, KnowsRangeFilesPosesProfilesAndSessions) {
  const TemporaryFolder folder;
  const FileInfo range =
      describeFile(folder.write("r.ply",
                                "ply\nformat ascii 1.0\nobj_info num_cols 3\nobj_info num_rows 2\nelement vertex "
                                "3\nproperty float x\nproperty float y\nproperty float z\n"
                                "element range_grid 6\nproperty list uchar int vertex_indices\nend_header\n0 0 "
                                "0\n0.001 0 0\n0 0.001 0\n1 0\n1 1\n0\n1 2\n0\n0\n"));
  EXPECT_EQ(range.content, FileContent::RangeImage);
  EXPECT_EQ(countOf(range, "rows"), 2);
  EXPECT_EQ(countOf(range, "columns"), 3);
  EXPECT_EQ(countOf(range, "samples"), 3);
  EXPECT_EQ(toText(range.at("mm_per_unit")), "1000");
  EXPECT_EQ(toText(range.at("filled")), "0.5");

  const FileInfo poses =
      describeFile(folder.write("scans.txt", "camera 0\nbmesh a.ply 0 0 0 0 0 0 1\nbmesh b 0 0 0 0 0 0 1\n"));
  EXPECT_EQ(poses.content, FileContent::ScanPoses);
  EXPECT_EQ(countOf(poses, "poses"), 2);

  EXPECT_EQ(describeFile(folder.write("s.vantage", std::string("SQLite format 3\0", 16))).content,
            FileContent::Session);

  const FileInfo profile =
      describeFile(folder.write("p.json", R"({"name":"Camera","scanner":{"type":"pinhole","position":[400,0,150],
    "look_at":[0,0,100],"rows":30,"columns":40,"horizontal_fov_deg":40,"vertical_fov_deg":30,"receivers":[],"breakdown_angle_deg":60,
    "range_mm":[100,900]},"workspace":{"type":"turntable","steps":12},"viewing_volume":{"radius_mm":100,"height_mm":200},
    "positional_space":{"surface":"cylinder","rows":10,"columns":36}})"));
  EXPECT_EQ(profile.content, FileContent::Profile);
  EXPECT_EQ(toText(profile.at("name")), "Camera");
  EXPECT_EQ(countOf(profile, "rows"), 30);
  EXPECT_EQ(countOf(profile, "positions"), 12);
}

TEST(DescribeFile, RefusesGarbageInOneSentence) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "a.txt", "a.ply", "a.stl", "a.off", "a.json", "a.conf", "a.dae", "a.3mf"}) {
    const std::string path = folder.write(name, std::string("\x01\x02 garbage \xff\0\n more", 19));
    expectError<InvalidInput>([&] { static_cast<void>(describeFile(path)); }, {path});
  }
}

}  // namespace
}  // namespace vantage
