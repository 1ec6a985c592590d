#include "io/mesh_reader.h"
#include "io/file_bytes.h"

#include <sys/stat.h>

#include <algorithm>

#include "core/io/expect_error.h"
#include "geometry/measures.h"
#include "io/file_bytes.h"
#include "io/mesh_writer.h"
#include "support/meshes.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

template <typename E>
void expectRefused(const std::string& path, std::vector<std::string> parts) {
  parts.push_back(path);
  expectError<E>([&] { static_cast<void>(loadMesh(path)); }, parts);
}

// A box as a document of a format that only assimp reads.
const std::string kCollada = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><translate>5 6 7</translate><instance_geometry url="#g"/></node>
<node><translate>20 0 0</translate><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

TEST(LoadMesh, ReadsWhatTheWritersWrote) {
  const TemporaryFolder folder;
  const Mesh box = testing::makeBox({-1, -2, 0}, {3, 4, 5}, 4);
  for (const char* name : {"box.ply", "box.stl", "box.obj", "BOX.STL"}) {
    const std::string path = folder.file(name);
    exportMesh(box, path);
    const LoadedMesh loaded = loadMesh(path);
    const MeshMeasures m = measure(loaded.mesh);
    EXPECT_EQ(m.vertices, box.vertices.size()) << name;
    EXPECT_EQ(m.triangles, box.triangles.size()) << name;
    EXPECT_EQ(m.boundaryEdges + m.nonManifoldEdges, 0U) << name;
    EXPECT_DOUBLE_EQ(m.area, area(box)) << name;
    EXPECT_EQ(loaded.repair.dropped(), 0U) << name;
  }
}

TEST(LoadMesh, ReadsOtherFormatsWithAllObjectsInTheirPlaces) {
  const TemporaryFolder folder;
  const LoadedMesh loaded = loadMesh(folder.write("two.dae", kCollada));
  EXPECT_EQ(loaded.format, "dae");
  EXPECT_EQ(loaded.mesh.triangles.size(), 8U);
  const BoundingBox box = boundingBox(loaded.mesh);
  EXPECT_NEAR((box.min - Vec3(5, 0, 0)).norm(), 0.0, 1e-5);
  EXPECT_NEAR((box.max - Vec3(21, 7, 8)).norm(), 0.0, 1e-5);
}

TEST(LoadMesh, RefusesWhatIsNoFileThatCanBeRead) {
  const TemporaryFolder folder;
  expectRefused<IoError>(folder.file("missing.ply"), {"does not exist"});
  expectRefused<IoError>(folder.file("."), {"folder"});
  expectRefused<IoError>(folder.write("empty.stl", ""), {"is empty"});
  const std::string pipe = folder.file("pipe.obj");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expectRefused<IoError>(pipe, {"pipe"});
}

TEST(LoadMesh, RefusesOtherKindsByName) {
  const TemporaryFolder folder;
  expectRefused<InvalidInput>(
      folder.write("a.off", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n"), {"git-lfs pointer"});
  expectRefused<InvalidInput>(folder.write("a.e57", "ASTM-E57 and so on"), {"E57", "not supported"});
  expectRefused<InvalidInput>(folder.write("a.ptx", "2\n2\n"), {"point cloud", "expected a mesh"});
  expectRefused<InvalidInput>(folder.write("a.json", "{}"), {"JSON", "expected a mesh"});
  expectRefused<InvalidInput>(folder.write("a.vantage", std::string("SQLite format 3\0...", 19)),
                              {"session", "expected a mesh"});
  expectRefused<InvalidInput>(folder.write("a.conf", "bmesh a 0 0 0 0 0 0 1"), {"scan poses", "expected a mesh"});
  expectRefused<InvalidInput>(folder.write("a.txt", "hello"), {"'hello'", "no mesh"});
  expectRefused<InvalidInput>(folder.write("a.ply", "format ascii 1.0\n"), {"'format ascii 1.0?'", "'ply'"});
}

TEST(LoadMesh, RefusesMeshesWithoutTriangles) {
  const TemporaryFolder folder;
  expectRefused<InvalidInput>(folder.write("points.obj", "v 0 0 0\nv 1 1 1\n"), {"2 points but no triangles"});
  expectRefused<InvalidInput>(folder.write("nothing.obj", "# nothing\n"), {"no geometry"});
  expectRefused<InvalidInput>(folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
                              {"no usable triangle", "without an area"});
  expectRefused<InvalidInput>(folder.write("nan.obj", "v nan 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
                              {"no usable triangle", "no number"});
}

TEST(LoadMesh, RefusesWhatAssimpCannotReadInOneSentence) {
  const TemporaryFolder folder;
  expectRefused<InvalidInput>(folder.write("a.dae", "<COLLADA>"), {"no mesh that can be read"});
  expectRefused<InvalidInput>(folder.write("a.fbx", std::string(1000, '\x7f')), {});
  expectRefused<InvalidInput>(folder.write("a.3mf", "PK\x03\x04 and nothing else"), {"zip directory", "truncated"});
}

TEST(LoadMesh, NeverDiesOnFilesThatAreCutOff) {
  const TemporaryFolder folder;
  const Mesh box = testing::makeBox({0, 0, 0}, {1, 1, 1}, 2);
  for (const char* name : {"box.ply", "box.stl", "box.obj"}) {
    exportMesh(box, folder.file(name));
    const std::string whole(FileBytes(folder.file(name)).text());
    for (std::size_t size = 1; size < whole.size(); size += 7) {
      const std::string cut = folder.write(std::string("cut-") + name, whole.substr(0, size));
      try {
        EXPECT_LE(loadMesh(cut).mesh.triangles.size(), box.triangles.size());
      } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find(cut), std::string::npos) << e.what();
      }
    }
  }
}

TEST(LoadMesh, NeverDiesOnFilesWithFlippedBytes) {
  const TemporaryFolder folder;
  const Mesh box = testing::makeBox({0, 0, 0}, {1, 1, 1}, 2);
  for (const char* name : {"box.ply", "box.stl", "box.obj"}) {
    exportMesh(box, folder.file(name));
    const std::string whole(FileBytes(folder.file(name)).text());
    for (std::size_t at = 0; at < whole.size(); at += 5) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (at % 2 == 0 ? 0xff : 0x10));
      try {
        EXPECT_LE(loadMesh(folder.write(std::string("bad-") + name, damaged)).mesh.triangles.size(),
                  2 * box.triangles.size());
      } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("bad-"), std::string::npos) << e.what();
      }
    }
  }
}

TEST(ReadableMeshExtensions, NameTheUsualFormatsOnce) {
  const auto extensions = readableMeshExtensions();
  EXPECT_TRUE(std::is_sorted(extensions.begin(), extensions.end()));
  EXPECT_EQ(std::adjacent_find(extensions.begin(), extensions.end()), extensions.end());
  for (const char* name : {"3mf", "dae", "obj", "off", "ply", "stl"})
    EXPECT_TRUE(std::binary_search(extensions.begin(), extensions.end(), name)) << name;
}

}  // namespace
}  // namespace vantage
