#include "io/three_mf_writer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "base/errors.h"
#include "geometry/measures.h"
#include "io/file_bytes.h"
#include "io/mesh_reader.h"
#include "io/zip_archive.h"
#include "support/meshes.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::makeBox;
using testing::TemporaryFolder;

std::string modelPart(const std::string& path) {
  const FileBytes file(path);
  const ZipArchive archive(file, 1U << 30);
  return archive.unpack(*archive.find("/3D/3dmodel.model"));
}

void write(const Mesh& mesh, const std::string& path, LengthUnit unit = LengthUnit::Millimetre,
           const std::vector<std::uint8_t>& invented = {}) {
  AtomicFile file(path);
  writeThreeMf(mesh, invented, unit, file);
  file.commit();
}

TEST(ThreeMfWriter, ComesBackAsItWas) {
  const TemporaryFolder folder;
  const Mesh box = makeBox(Vec3(-1, 2, 3), Vec3(4, 5.5, 9.25), 6);
  write(box, folder.file("box.3mf"));
  const LoadedMesh back = loadMesh(folder.file("box.3mf"));
  EXPECT_EQ(back.mesh.triangles, box.triangles);
  ASSERT_EQ(back.mesh.vertices.size(), box.vertices.size());
  for (std::size_t v = 0; v < box.vertices.size(); ++v)
    EXPECT_EQ(back.mesh.vertices[v].cast<float>(), box.vertices[v].cast<float>());
  EXPECT_TRUE(back.repair.nothing());
}

TEST(ThreeMfWriter, InchesAreTheSameSize) {
  const TemporaryFolder folder;
  write(makeBox(Vec3(0, 0, 0), Vec3(25.4, 50.8, 2.54)), folder.file("box.3mf"), LengthUnit::Inch);
  EXPECT_NE(modelPart(folder.file("box.3mf")).find("unit=\"inch\""), std::string::npos);
  EXPECT_NE(modelPart(folder.file("box.3mf")).find("x=\"1\" y=\"2\" z=\"0.1\""), std::string::npos);
  const Vec3 size = boundingBox(loadMesh(folder.file("box.3mf")).mesh).size();
  EXPECT_LT((size - Vec3(25.4, 50.8, 2.54)).norm(), 1e-5);
}

TEST(ThreeMfWriter, WhatIsInventedHasItsOwnMaterial) {
  const TemporaryFolder folder;
  const Mesh box = makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1));
  std::vector<std::uint8_t> invented(box.triangles.size(), 0);
  invented[3] = 1;
  write(box, folder.file("box.3mf"), LengthUnit::Millimetre, invented);
  const std::string text = modelPart(folder.file("box.3mf"));
  EXPECT_NE(text.find("<base name=\"invented\""), std::string::npos);
  std::size_t marked = 0;
  for (std::size_t at = text.find("pid=\"1\" p1=\"1\""); at != std::string::npos;
       at = text.find("pid=\"1\" p1=\"1\"", at + 1))
    ++marked;
  EXPECT_EQ(marked, 1U);
  EXPECT_EQ(loadMesh(folder.file("box.3mf")).mesh.triangles.size(), box.triangles.size());
  write(box, folder.file("plain.3mf"), LengthUnit::Millimetre, std::vector<std::uint8_t>(12, 0));
  EXPECT_EQ(modelPart(folder.file("plain.3mf")).find("basematerials"), std::string::npos);
}

TEST(ThreeMfWriter, TheSameMeshIsTheSameFile) {
  const TemporaryFolder folder;
  const Mesh sphere = testing::makeSphere(10.0, 40);
  write(sphere, folder.file("a.3mf"));
  write(sphere, folder.file("b.3mf"));
  EXPECT_EQ(FileBytes(folder.file("a.3mf")).text(), FileBytes(folder.file("b.3mf")).text());
}

TEST(ThreeMfWriter, RefusesWhatIsNoNumber) {
  const TemporaryFolder folder;
  Mesh box = makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1));
  box.vertices[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(write(box, folder.file("box.3mf")), InvalidInput);
  EXPECT_FALSE(std::filesystem::exists(folder.file("box.3mf")));
}

}  // namespace
}  // namespace vantage
