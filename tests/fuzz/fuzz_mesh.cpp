#include <array>
#include <memory>

#include "base/errors.h"
#include "core/io/zip_writer.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/scratch_file.h"
#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "io/model_reader.h"
#include "support/meshes.h"

// An input is a mesh file behind one byte that chooses its extension among the formats with readers of our own.

namespace vantage::testing {
namespace {

constexpr std::array<const char*, 5> kEndings{".ply", ".stl", ".obj", ".off", ".3mf"};
constexpr std::size_t kMaxUnpacked = 64U << 20;

constexpr const char* kAsciiPly =
    "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty double y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n3 0 1 2\n4 0 1 2 "
    "3\n";
constexpr const char* kStripPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n5 0 1 2 -1 3\n";
constexpr const char* kAsciiStl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "s\n";
constexpr const char* kObj = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 -1\nf 1 2 \\\n3\n";
constexpr const char* kOff =
    "COFF\n# c\n4 2 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n0 0 1 1 1 1 1\n3 0 1 2\n3 0 1 3\n";
constexpr const char* kRelations =
    R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/m.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";
constexpr const char* kModel =
    R"(<?xml version="1.0"?><model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/></triangles></mesh></object><object id="2"><components><component objectid="1" transform="0 1 0 -1 0 0 0 0 1 10 0 0"/></components></object></resources><build><item objectid="2"/></build></model>)";

const ScratchFile& fileOf(std::size_t kind) {
  static const auto files = [] {
    std::array<std::unique_ptr<ScratchFile>, kEndings.size()> list;
    for (std::size_t i = 0; i < kEndings.size(); ++i) list[i] = std::make_unique<ScratchFile>(kEndings[i]);
    return list;
  }();
  return *files[kind];
}

std::string seed(std::size_t kind, const std::string& bytes) {
  return std::string(1, static_cast<char>(kind)) + bytes;
}

template <typename Write>
std::string written(std::size_t kind, const Write& write) {
  write(fileOf(kind).path());
  return seed(kind, fileOf(kind).read());
}

}  // namespace

std::vector<std::string> fuzzSeeds() {
  Model model;
  model.mesh = makeBox(Vec3(0, 0, 0), Vec3(1, 2, 3));
  model.confidence.assign(model.mesh.vertices.size(), 0.5F);
  model.vertexView.assign(model.mesh.vertices.size(), 0);
  model.vertexSample.assign(model.mesh.vertices.size(), 0);
  model.triangleView.assign(model.mesh.triangles.size(), 0);
  std::vector<std::string> seeds{seed(0, kAsciiPly), seed(0, kStripPly), seed(1, kAsciiStl), seed(2, kObj),
                                 seed(3, kOff)};
  for (std::size_t kind = 0; kind < 3; ++kind)
    seeds.push_back(written(kind, [&](const std::string& path) { exportModel(model, path); }));
  seeds.push_back(seed(4, zipOf({{"_rels/.rels", kRelations}, {"3D/m.model", kModel}})));
  return seeds;
}

}  // namespace vantage::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vantage::testing;
  if (size == 0) return 0;
  const std::size_t kind = data[0] % kEndings.size();
  const ScratchFile& file = fileOf(kind);
  file.write({reinterpret_cast<const char*>(data) + 1, size - 1});
  try {
    static_cast<void>(vantage::loadMesh(file.path(), {.maxUnpackedBytes = kMaxUnpacked}));
  } catch (const vantage::Error&) {
    // Refused, as it should be.
  }
  try {
    if (kind == 0) static_cast<void>(vantage::readModel(file.path()));
  } catch (const vantage::Error&) {
    return 0;
  }
  return 0;
}
