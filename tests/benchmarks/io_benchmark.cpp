// Binary PLY with 1.1 million triangles, read and written by us and by assimp in one run. Compare the medians of one
// run only: --benchmark_enable_random_interleaving=true takes the sides in turns.
#include <assimp/scene.h>
#include <benchmark/benchmark.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>

#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "io/model_reader.h"
#include "support/meshes.h"
#include "support/test_data.h"

namespace {

constexpr int kRings = 525;  // 1.1 million triangles
constexpr int kRepetitions = 7;

struct Files {
  vantage::testing::TemporaryFolder folder;
  vantage::Mesh mesh = vantage::testing::makeSphere(100.0, kRings);
  std::string ply = folder.file("sphere.ply");
  std::string model = folder.file("model.ply");

  Files() {
    vantage::exportMesh(mesh, ply);
    const std::vector<std::uint32_t> none(mesh.vertices.size(), vantage::kNoIndex);
    vantage::exportModel({mesh, std::vector<float>(mesh.vertices.size(), 1.0F), none, none,
                          std::vector<std::uint32_t>(mesh.triangles.size(), 0)},
                         model);
  }
};

const Files& files() {
  static const Files made;
  return made;
}

void readOurs(benchmark::State& state) {
  const std::string& path = files().model;
  while (state.KeepRunning()) benchmark::DoNotOptimize(vantage::readModel(path).mesh.triangles.data());
}

void readAssimp(benchmark::State& state) {
  const std::string& path = files().ply;
  while (state.KeepRunning()) {
    Assimp::Importer importer;
    benchmark::DoNotOptimize(importer.ReadFile(path, 0));
  }
}

void readAndRepair(benchmark::State& state) {
  const std::string& path = files().ply;
  while (state.KeepRunning()) benchmark::DoNotOptimize(vantage::loadMesh(path).mesh.triangles.data());
}

void writeOurs(benchmark::State& state) {
  const std::string path = files().folder.file("ours.ply");
  while (state.KeepRunning()) vantage::exportMesh(files().mesh, path);
}

void writeAssimp(benchmark::State& state) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(files().ply, 0);
  const std::string path = files().folder.file("assimp.ply");
  while (state.KeepRunning()) {
    Assimp::Exporter exporter;
    benchmark::DoNotOptimize(exporter.Export(scene, "plyb", path));
  }
}

#define VANTAGE_TIMED(name) \
  BENCHMARK(name)->Unit(benchmark::kMillisecond)->Repetitions(kRepetitions)->ReportAggregatesOnly(true)->UseRealTime()

VANTAGE_TIMED(readOurs);
VANTAGE_TIMED(readAssimp);
VANTAGE_TIMED(readAndRepair);
VANTAGE_TIMED(writeOurs);
VANTAGE_TIMED(writeAssimp);

}  // namespace

BENCHMARK_MAIN();
