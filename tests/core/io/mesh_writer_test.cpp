#include "io/mesh_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <limits>
#include <span>

#include "base/errors.h"
#include "core/io/expect_error.h"
#include "geometry/measures.h"
#include "io/file_bytes.h"
#include "io/mesh_reader.h"
#include "io/model_reader.h"
#include "io/ply_document.h"
#include "io/ply_header.h"
#include "support/meshes.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

Model modelOf(Mesh mesh) {
  Model model;
  model.mesh = std::move(mesh);
  for (std::size_t i = 0; i < model.mesh.vertices.size(); ++i)
    model.confidence.push_back(1.0F / static_cast<float>(i + 1));
  for (std::size_t i = 0; i < model.mesh.triangles.size(); ++i)
    model.triangleView.push_back(static_cast<std::uint32_t>(i % 3));
  model.vertexView.assign(model.mesh.vertices.size(), 0);
  model.vertexSample.assign(model.mesh.vertices.size(), 0);
  return model;
}

// Coordinates that single precision holds exactly.
Model makeModel() {
  return modelOf(testing::makeGrid(7, 5, 0.25));
}

void expectSame(const Model& a, const Model& b) {
  EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.confidence, b.confidence);
  EXPECT_EQ(a.triangleView, b.triangleView);
}

TEST(ExportModel, PlyComesBackAsItWas) {
  const TemporaryFolder folder;
  const Model model = makeModel();
  exportModel(model, folder.file("model.ply"));
  const Model back = readModel(folder.file("model.ply"));
  expectSame(back, model);
  EXPECT_EQ(back.vertexView, std::vector<std::uint32_t>(model.mesh.vertices.size(), kNoIndex));
  EXPECT_TRUE(isModel(readPlyHeader(folder.file("model.ply"))));
}

TEST(ExportModel, AnOffsetIsPutBackWherePrecisionHoldsIt) {
  const TemporaryFolder folder;
  const Model model = makeModel();
  const Vec3 far(403000000.0, 605000000.0, 1000.0);
  Model moved = model;
  for (Vec3& v : moved.mesh.vertices) v += far;
  for (const char* name : {"model.ply", "model.obj"}) {
    exportModel(model, folder.file(name), {}, far);
    EXPECT_TRUE(holdsOffset(name));
  }
  EXPECT_NE(FileBytes(folder.file("model.obj")).text().find("v 403000000.25 6.05e+08 1000\n"), std::string_view::npos);
  expectSame(readModel(folder.file("model.ply")), moved);
  exportModel(model, folder.file("model.stl"), {}, far);
  EXPECT_FALSE(holdsOffset("model.stl"));
  EXPECT_EQ(boundingBox(loadMesh(folder.file("model.stl")).mesh).max, boundingBox(model.mesh).max);
}

TEST(ExportModel, AnEmptyModelIsStillAModel) {
  const TemporaryFolder folder;
  exportModel({}, folder.file("model.ply"));
  EXPECT_TRUE(readModel(folder.file("model.ply")).mesh.empty());
}

TEST(ExportModel, PlyIsByteForByteAsDocumented) {
  const TemporaryFolder folder;
  Model model;
  model.mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  model.mesh.triangles = {{0, 1, 2}};
  model.confidence = {1.0F, 0.5F, 0.25F};
  model.triangleView = {7};
  exportModel(model, folder.file("model.ply"));
  std::string expected =
      "ply\nformat binary_little_endian 1.0\ncomment millimetres\nelement vertex 3\nproperty float x\nproperty float "
      "y\n"
      "property float z\nproperty float confidence\nelement face 1\nproperty list uchar int vertex_indices\nproperty "
      "int view\n"
      "end_header\n";
  for (const float value : {1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 1.0F, 0.0F, 0.5F, 0.0F, 0.0F, 1.0F, 0.25F})
    expected.append(reinterpret_cast<const char*>(&value), 4);
  expected += '\3';
  for (const int value : {0, 1, 2, 7}) expected.append(reinterpret_cast<const char*>(&value), 4);
  EXPECT_EQ(FileBytes(folder.file("model.ply")).text(), expected);
}

TEST(ExportModel, WhatIsInventedIsAPropertyOfItsVerticesAndAViewOfItsTriangles) {
  const TemporaryFolder folder;
  Model model = makeModel();
  std::vector<std::uint8_t> invented(model.mesh.vertices.size(), 0);
  invented[5] = invented[7] = 1;
  model.triangleView[3] = kNoIndex;
  ExportOptions options;
  options.invented = invented;
  exportModelAs(model, folder.file("model.ply"), options);
  const PlyHeader header = readPlyHeader(folder.file("model.ply"));
  EXPECT_NE(header.find("vertex")->find("invented"), nullptr);
  const FileBytes file(folder.file("model.ply"));
  const PlySelection selection{"vertex", "invented"};
  const PlyDocument document = readPlyDocument(file, std::array{selection});
  EXPECT_EQ(document.find("vertex", "invented")->values, std::vector<double>(invented.begin(), invented.end()));
  expectSame(readModel(folder.file("model.ply")), model);
  options.invented = std::span(invented).subspan(1);
  EXPECT_THROW(exportModelAs(model, folder.file("no.ply"), options), InvalidInput);
}

TEST(ExportModel, InchesAreInchesInEveryFormat) {
  const TemporaryFolder folder;
  const Model model = modelOf(testing::makeBox(Vec3(0, 0, 0), Vec3(25.4, 50.8, 76.2)));
  ExportOptions options;
  options.unit = LengthUnit::Inch;
  for (const char* name : {"model.ply", "model.stl", "model.obj"}) {
    exportModelAs(model, folder.file(name), options);
    EXPECT_LT((boundingBox(loadMesh(folder.file(name)).mesh).max - Vec3(1, 2, 3)).norm(), 1e-6) << name;
    EXPECT_NE(FileBytes(folder.file(name)).text().find("inches"), std::string_view::npos) << name;
  }
  exportModelAs(model, folder.file("model.3mf"), options);
  EXPECT_LT((boundingBox(loadMesh(folder.file("model.3mf")).mesh).max - Vec3(25.4, 50.8, 76.2)).norm(), 1e-5);
  options.unit = LengthUnit::Metre;
  EXPECT_THROW(exportModelAs(model, folder.file("model.stl"), options), InvalidInput);
}

TEST(ExportModel, SaysWhatAFormatHolds) {
  EXPECT_TRUE(holdsInvented("a.ply"));
  EXPECT_TRUE(holdsInvented("a.3mf"));
  EXPECT_FALSE(holdsInvented("a.stl"));
  EXPECT_FALSE(holdsInvented("a.obj"));
  EXPECT_FALSE(holdsOffset("a.3mf"));
  EXPECT_FALSE(holdsColours("a.3mf"));
}

TEST(ReadModel, ReadsOtherLayoutsOfTheSameContent) {
  const TemporaryFolder folder;
  const Model back = readModel(
      folder.write("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty double confidence\nproperty float x\n"
                   "property float y\nproperty float z\nelement face 1\nproperty uchar view\n"
                   "property list uchar uint vertex_index\nend_header\n1 1 0 0\n0.5 0 1 0\n0.25 0 0 1\n7 3 0 1 2\n"));
  EXPECT_EQ(back.confidence, (std::vector<float>{1.0F, 0.5F, 0.25F}));
  EXPECT_EQ(back.triangleView, (std::vector<std::uint32_t>{7}));
  EXPECT_EQ(back.mesh.vertices[2], Vec3(0, 0, 1));
  EXPECT_EQ(back.mesh.triangles[0], (Triangle{0, 1, 2}));
}

TEST(ReadModel, RefusesWhatAModelCannotBe) {
  const TemporaryFolder folder;
  exportMesh(makeModel().mesh, folder.file("mesh.ply"));
  expectError<InvalidInput>([&] { static_cast<void>(readModel(folder.file("mesh.ply"))); },
                            {"mesh.ply", "no model", "confidence"});

  auto refuse = [&](const Model& model, const std::vector<std::string>& parts) {
    exportModel(model, folder.file("bad.ply"));
    expectError<InvalidInput>([&] { static_cast<void>(readModel(folder.file("bad.ply"))); }, parts);
  };
  Model model = makeModel();
  model.confidence[3] = 1.5F;
  refuse(model, {"bad.ply", "vertex 3", "1.5"});
  model = makeModel();
  model.triangleView[2] = 0x80000000U;
  refuse(model, {"face 2", "view"});
  model = makeModel();
  model.mesh.vertices[4].x() = std::numeric_limits<double>::quiet_NaN();
  refuse(model, {"vertex 4", "not finite"});
}

TEST(ReadModel, RefusesFacesOtherThanTrianglesOfTheFile) {
  const TemporaryFolder folder;
  exportModel(makeModel(), folder.file("model.ply"));
  const std::string whole(FileBytes(folder.file("model.ply")).text());
  const std::size_t lastFace = whole.size() - 17;
  std::string damaged = whole;
  damaged[lastFace + 12] = '\x7f';
  expectError<InvalidInput>([&] { static_cast<void>(readModel(folder.write("a.ply", damaged))); },
                            {"a.ply", "face 69", "48 vertices"});
  damaged = whole;
  damaged[lastFace] = '\2';
  expectError<InvalidInput>([&] { static_cast<void>(readModel(folder.write("b.ply", damaged))); },
                            {"b.ply", "face 69"});
  expectError<InvalidInput>(
      [&] { static_cast<void>(readModel(folder.write("c.ply", whole.substr(0, whole.size() - 5)))); }, {"c.ply"});
}

TEST(ReadModel, IsTheSameForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Model sphere = modelOf(testing::makeSphere(10.0, 300));
  exportModel(sphere, folder.file("a.ply"));
  const Model one = readModel(folder.file("a.ply"));
  expectSame(readModel(folder.file("a.ply"), Progress({}, {}, 4)), one);
  EXPECT_EQ(one.mesh.triangles, sphere.mesh.triangles);
}

TEST(ExportMesh, RefusesUnknownExtensionsAndBrokenIndices) {
  const TemporaryFolder folder;
  expectError<InvalidInput>([&] { exportMesh(makeModel().mesh, folder.file("a.xyz")); },
                            {"a.xyz", "'xyz'", ".ply, .stl, .obj or .3mf"});
  Mesh mesh = makeModel().mesh;
  mesh.triangles[5][1] = 48;
  expectError<InvalidInput>([&] { exportMesh(mesh, folder.file("a.ply")); }, {"triangle 5", "vertex 48 of 48"});
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.ply")));
}

TEST(ExportMesh, LeavesTheOldFileWhenCancelled) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.stl", "old");
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(exportMesh(makeModel().mesh, path, Progress({}, stop.get_token(), 1)), Cancelled);
  EXPECT_EQ(FileBytes(path).text(), "old");
  EXPECT_EQ(testing::filesBelow(folder.file(".")).size(), 1U);
}

}  // namespace
}  // namespace vantage
