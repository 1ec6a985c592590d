#include "core/io/expect_error.h"
#include "core/io/zip_writer.h"
#include "geometry/measures.h"
#include "io/mesh_reader.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;
using testing::zipOf;

const std::string kRelations =
    R"(<Relationships><Relationship Target="/3D/root.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";

// The corner of a cube with sides of 1, closed.
const std::string kMesh =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices>
<triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh>)";

std::string model(const std::string& resources, const std::string& build, const std::string& attributes = "") {
  return R"(<?xml version="1.0"?><model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )" +
         attributes + "><resources>" + resources + "</resources><build>" + build + "</build></model>";
}

LoadedMesh load(const std::string& root, const std::string& other = "") {
  const TemporaryFolder folder;
  return loadMesh(
      folder.write("a.3mf", zipOf({{"_rels/.rels", kRelations}, {"3D/other.model", other}, {"3D/root.model", root}})));
}

void expectRefused(const std::string& root, std::vector<std::string> parts, const std::string& other = "") {
  parts.emplace_back("a.3mf");
  expectError<InvalidInput>([&] { static_cast<void>(load(root, other)); }, parts);
}

const std::string kObject = R"(<object id="1">)" + kMesh + "</object>";

TEST(ThreeMfReader, PlacesItemsAndComponents) {
  // Object 2 is object 1 turned by 90 degrees about z (x goes to y) and moved; it stands in the scene twice.
  const std::string assembly =
      R"(<object id="2"><components><component objectid="1" transform="0 1 0 -1 0 0 0 0 1 10 0 0"/></components></object>)";
  const LoadedMesh loaded = load(
      model(kObject + assembly, R"(<item objectid="2"/><item objectid="2" transform="1 0 0 0 1 0 0 0 1 0 0 100"/>)"));
  EXPECT_EQ(loaded.mesh.triangles.size(), 8U);
  const BoundingBox box = boundingBox(loaded.mesh);
  EXPECT_EQ(box.min, Vec3(9, 0, 0));
  EXPECT_EQ(box.max, Vec3(10, 1, 101));
  EXPECT_TRUE(loaded.repair.nothing()) << describe(loaded.repair);
}

TEST(ThreeMfReader, ConvertsToMillimetres) {
  const LoadedMesh loaded = load(model(kObject, R"(<item objectid="1"/>)", R"(unit="inch")"));
  EXPECT_NEAR((boundingBox(loaded.mesh).max - Vec3::Constant(25.4)).norm(), 0.0, 1e-12);
}

TEST(ThreeMfReader, FollowsPathsIntoOtherParts) {
  const LoadedMesh loaded = load(model("", R"(<item objectid="1" p:path="/3D/other.model"/>)"), model(kObject, ""));
  EXPECT_EQ(loaded.mesh.triangles.size(), 4U);
}

TEST(ThreeMfReader, LeavesSupportsOut) {
  const std::string support = R"(<object id="2" type="support">)" + kMesh + "</object>";
  EXPECT_EQ(load(model(kObject + support, R"(<item objectid="1"/><item objectid="2"/>)")).mesh.triangles.size(), 4U);
}

TEST(ThreeMfReader, KnowsTheExtensionsThatCanBeSkipped) {
  const std::string item = R"(<item objectid="1"/>)";
  EXPECT_NO_THROW(static_cast<void>(load(
      model(kObject, item,
            R"(xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02" requiredextensions="m")"))));
  expectRefused(model(kObject, item, R"(xmlns:q="http://example.com/q" requiredextensions="q")"), {"'q'", "required"});
  expectRefused(model(kObject, item, R"(requiredextensions="q")"), {"'q'", "required"});
}

TEST(ThreeMfReader, RefusesDamagedModels) {
  const std::string item = R"(<item objectid="1"/>)";
  auto changed = [](std::string text, const std::string& what, const std::string& to) {
    return text.replace(text.find(what), what.size(), to);
  };
  const std::string good = model(kObject, item);
  expectRefused(changed(good, "x=\"1\"", "x=\"1,0\""), {"3D/root.model", "line 1", "'1,0'"});
  expectRefused(changed(good, "v1=\"1\"", "v1=\"one\""), {"line 2", "'one'"});
  expectRefused(changed(good, "</model>", ""), {"truncated"});
  expectRefused(changed(good, "model xmlns", "mesh xmlns"), {"line 2"});
  expectRefused(changed(good, "id=\"1\"", "id=\"7\""), {"no object '1'"});
  expectRefused(model(kObject + kObject, item), {"'1' is given twice"});
  expectRefused(model(kObject, R"(<item objectid="1" path="/3D/none.model"/>)"), {"none.model", "not in the archive"});
  expectRefused(model(kObject, R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 0 0 0 0"/>)"), {"leaves no volume"});
  expectRefused(model(kObject, R"(<item objectid="1" transform="1 0 0"/>)"), {"twelve numbers"});
  expectRefused(model(kObject, "", R"(unit="furlong")"), {"'furlong'"});
  expectRefused(model(kObject, ""), {"no geometry"});
}

TEST(ThreeMfReader, RefusesObjectsThatContainThemselves) {
  const std::string twice = R"(<components><component objectid="2"/><component objectid="2"/></components>)";
  expectRefused(model(R"(<object id="2">)" + twice + "</object>", R"(<item objectid="2"/>)"), {"deep"});
}

TEST(ThreeMfReader, RefusesAFewObjectsPlacedAMillionTimes) {
  std::string objects = kObject;
  for (int id = 2; id <= 24; ++id) {
    const std::string part = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    objects += "<object id=\"" + std::to_string(id) + "\"><components>" + part + part + part + "</components></object>";
  }
  expectRefused(model(objects, R"(<item objectid="24"/>)"), {"1000000 times"});
}

TEST(ThreeMfReader, DropsTrianglesWithoutVertices) {
  std::string mesh = kObject;
  mesh.replace(mesh.find("v1=\"1\""), 6, "v1=\"9\"");
  const LoadedMesh loaded = load(model(mesh, R"(<item objectid="1"/>)"));
  EXPECT_EQ(loaded.repair.droppedMissingVertex, 1U);
  EXPECT_EQ(loaded.mesh.triangles.size(), 3U);
}

}  // namespace
}  // namespace vantage
