// Writes the sample objects as PLY files: make_sample_objects DIR
#include <cstdio>
#include <string>

#include "base/errors.h"
#include "geometry/decimation.h"
#include "io/mesh_writer.h"
#include "support/sample_objects/polygonize.h"
#include "support/sample_objects/sample_objects.h"

namespace {

constexpr double kSpacing = 1.0;    // [mm]
constexpr double kMaxError = 0.02;  // [mm]
constexpr double kFlat = 1e-3;      // [mm]
constexpr std::size_t kTriangles = 60000;

void write(double (*field)(const vantage::Vec3&), const vantage::Vec3& min, const vantage::Vec3& max,
           const std::string& path) {
  const vantage::Mesh fine = vantage::testing::polygonize(field, {min, max}, kSpacing);
  vantage::Mesh mesh = vantage::decimate(fine, {kTriangles, kMaxError, true});
  vantage::testing::flipFlatTriangles(mesh, kFlat);
  const double foot = vantage::boundingBox(mesh).min.z();
  for (vantage::Vec3& v : mesh.vertices) v.z() -= foot;
  vantage::exportMesh(mesh, path);
  std::printf("%s: %zu of %zu triangles\n", path.c_str(), mesh.triangles.size(), fine.triangles.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "use: make_sample_objects DIR\n");
    return 2;
  }
  const std::string folder = argv[1];
  try {
    write(vantage::testing::mug, {-60, -45, -2.5}, {60, 45, 98.5}, folder + "/mug.ply");
    write(vantage::testing::handset, {-100, -40, -2.5}, {100, 40, 49.5}, folder + "/handset.ply");
    write(vantage::testing::candleHolder, {-62, -56, -2.5}, {62, 56, 154.5}, folder + "/candle_holder.ply");
  } catch (const vantage::Error& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
