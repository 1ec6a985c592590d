#include "io/mesh_colours.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "core/io/expect_error.h"
#include "io/file_bytes.h"
#include "io/file_info.h"
#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "io/model_reader.h"
#include "io/ply_colours.h"
#include "io/range_files.h"
#include "support/coloured_scan.h"
#include "support/meshes.h"
#include "support/test_data.h"
#include "support/written_scans.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

Model gridModel() {
  Model model;
  model.mesh = testing::makeGrid(7, 5, 0.25);
  model.confidence.assign(model.mesh.vertices.size(), 0.5F);
  model.triangleView.assign(model.mesh.triangles.size(), 1);
  return model;
}

// Every value of every channel.
VertexColours everyColour(std::size_t count) {
  VertexColours colours;
  for (std::size_t i = 0; i < count; ++i)
    colours.push_back(Colour{static_cast<std::uint8_t>(i * 6), static_cast<std::uint8_t>(255 - i), 7});
  return colours;
}

std::vector<Colour> withGrey(const VertexColours& colours) {
  std::vector<Colour> result;
  for (const auto& colour : colours) result.push_back(colour.value_or(kGrey));
  return result;
}

TEST(MeshColours, ComeBackFromPlyAndObj) {
  const TemporaryFolder folder;
  const Model model = gridModel();
  const VertexColours colours = everyColour(model.mesh.vertices.size());
  for (const char* name : {"model.ply", "model.obj"})
    for (const Vec3& offset : {Vec3(0, 0, 0), Vec3(403000000.0, 605000000.0, 1000.0)}) {
      exportModel(model, folder.file(name), {}, offset, colours);
      EXPECT_TRUE(holdsColours(name));
      EXPECT_EQ(readMeshColours(folder.file(name)), withGrey(colours)) << name;
    }
}

TEST(MeshColours, LeaveTheModelBesideThemAsItIs) {
  const TemporaryFolder folder;
  const Model model = gridModel();
  exportModel(model, folder.file("model.ply"), {}, Vec3::Zero(), everyColour(model.mesh.vertices.size()));
  const Model back = readModel(folder.file("model.ply"));
  EXPECT_EQ(loadMesh(folder.file("model.ply")).mesh.triangles.size(), model.mesh.triangles.size());
  EXPECT_EQ(back.mesh.vertices, model.mesh.vertices);
  EXPECT_EQ(back.mesh.triangles, model.mesh.triangles);
  EXPECT_EQ(back.confidence, model.confidence);
  EXPECT_EQ(back.triangleView, model.triangleView);
  EXPECT_EQ(std::get<std::int64_t>(describeFile(folder.file("model.ply")).at("coloured_vertices")), 48);
}

TEST(MeshColours, OfAVertexWithoutOneAreGreyAndTheFileSaysSo) {
  const TemporaryFolder folder;
  const Model model = gridModel();
  VertexColours colours = everyColour(model.mesh.vertices.size());
  colours[3] = std::nullopt;
  colours[9] = std::nullopt;
  for (const char* name : {"model.ply", "model.obj"}) {
    exportModel(model, folder.file(name), {}, Vec3::Zero(), colours);
    EXPECT_EQ(readMeshColours(folder.file(name)), withGrey(colours)) << name;
  }
  EXPECT_NE(FileBytes(folder.file("model.ply"))
                .text()
                .find("\ncomment no colour was measured at 2 vertices, which are 128 128 128\n"),
            std::string_view::npos);
}

TEST(MeshColours, ArePlyPropertiesByteForByteAsDocumented) {
  const TemporaryFolder folder;
  Model model;
  model.mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  model.mesh.triangles = {{0, 1, 2}};
  model.confidence = {1.0F, 0.5F, 0.25F};
  model.triangleView = {7};
  exportModel(model, folder.file("model.ply"), {}, Vec3::Zero(),
              {Colour{1, 2, 3}, Colour{255, 0, 9}, Colour{65, 66, 67}});
  const std::string text(FileBytes(folder.file("model.ply")).text());
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment millimetres\nelement vertex 3\nproperty float x\nproperty float "
      "y\nproperty float z\nproperty float confidence\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty int view\nend_header\n";
  ASSERT_EQ(text.substr(0, header.size()), header);
  EXPECT_EQ(text.size(), header.size() + 3 * 19 + 17);
  EXPECT_EQ(text.substr(header.size() + 16, 3), "\1\2\3");
  EXPECT_EQ(text.substr(header.size() + 2 * 19 + 16, 3), "ABC");
  exportModel(model, folder.file("model.obj"), {}, Vec3::Zero(),
              {Colour{0, 51, 255}, Colour{0, 51, 255}, Colour{0, 51, 255}});
  EXPECT_EQ(FileBytes(folder.file("model.obj")).text().substr(0, 31), "# millimetres\nv 1 0 0 0 0.2 1\nv");
}

TEST(MeshColours, AreLeftOutOfStl) {
  const TemporaryFolder folder;
  const Model model = gridModel();
  exportModel(model, folder.file("plain.stl"));
  exportModel(model, folder.file("coloured.stl"), {}, Vec3::Zero(), everyColour(model.mesh.vertices.size()));
  EXPECT_FALSE(holdsColours("model.stl"));
  EXPECT_EQ(FileBytes(folder.file("plain.stl")).text(), FileBytes(folder.file("coloured.stl")).text());
  EXPECT_TRUE(readMeshColours(folder.file("plain.stl")).empty());
}

TEST(MeshColours, AreReadFromFilesOfOthers) {
  const TemporaryFolder folder;
  const std::string shares = folder.write(
      "shares.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float blue\nproperty float x\nproperty float y\nproperty "
      "float z\nproperty float red\nproperty float green\nelement face 1\nproperty list uchar int vertex_indices\n"
      "end_header\n0.2 0 0 0 1 0\n0.2 1 0 0 1 0\n0.2 0 1 0 1 0\n3 0 1 2\n");
  EXPECT_EQ(readMeshColours(shares), std::vector<Colour>(3, Colour{255, 0, 51}));
  // An OBJ of which one vertex has none, or something else, has none.
  for (const char* line : {"v 1 0 0", "v 1 0 0 1", "v 1 0 0 200 100 0"})
    EXPECT_TRUE(
        readMeshColours(folder.write("some.obj", std::string("v 0 0 0 1 1 1\n") + line + "\nv 0 1 0 1 1 1\nf 1 2 3\n"))
            .empty())
        << line;
  exportMesh(gridModel().mesh, folder.file("plain.ply"));
  exportMesh(gridModel().mesh, folder.file("plain.obj"));
  for (const char* name : {"plain.ply", "plain.obj"}) EXPECT_TRUE(readMeshColours(folder.file(name)).empty()) << name;
}

TEST(MeshColours, OfAnotherNumberThanVerticesAreRefused) {
  const TemporaryFolder folder;
  expectError<InvalidInput>([&] { exportModel(gridModel(), folder.file("a.ply"), {}, Vec3::Zero(), everyColour(47)); },
                            {"47 colours", "48 vertices"});
}

TEST(RangeFileColours, ComeBackAsTheyWere) {
  const TemporaryFolder folder;
  const ScannerProfile profile = testing::cameraProfile();
  RangeImage image;
  image.rays = profile.rays;
  image.range = testing::WrittenScan(profile).range;
  image = testing::painted(image);
  writeRangeFile(image, folder.file("scan.ply"));
  const RangeImage back = readRangeFile(folder.file("scan.ply"), image.rays);
  EXPECT_EQ(back.colours, image.colours);
  EXPECT_EQ(std::get<std::int64_t>(describeFile(folder.file("scan.ply")).at("coloured_samples")),
            static_cast<std::int64_t>(image.sampleCount()));
}

}  // namespace
}  // namespace vantage
