// Zippering eight views of a mug with relief, 0.99 million triangles, and the consensus geometry, on the same input as
// the programs compared with: VANTAGE_PERF_DATA names the folder with view0.rng ... view7.rng and the true mug.ply.
// Prints medians of the times, the largest time for adding one view, and what the model is. With a path as argument the
// model is written there as PLY, for the judge that the others were measured with.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "geometry/measures.h"
#include "integration/consensus.h"
#include "integration/zipper.h"
#include "recorded_views.h"

using namespace vantage;

namespace {

constexpr int kThreads = 2;
constexpr int kRuns = 5;
// The breakdown angle that the range images were made with.
const double kBreakdown = radians(75.0);

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void writePly(const std::string& path, const Mesh& mesh) {
  std::ofstream out(path);
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& v : mesh.vertices) out << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const Triangle& t : mesh.triangles) out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

void run(const std::string& folder, const std::string& output) {
  std::vector<View> views;
  std::size_t triangles = 0;
  for (int i = 0; i < 8; ++i) {
    views.push_back(readRecordedView(folder + "/view" + std::to_string(i) + ".rng", kBreakdown));
    triangles += views.back().mesh->mesh.triangles.size();
  }
  ZipperOptions options;
  options.breakdownAngle = kBreakdown;
  const Progress progress({}, {}, kThreads);
  std::vector<double> zippering;
  std::vector<double> slowest;
  std::vector<double> averaging;
  Model published;
  for (int k = 0; k < kRuns; ++k) {
    Model model;
    double sum = 0.0;
    double most = 0.0;
    for (std::uint32_t view = 0; view < views.size(); ++view) {
      const double time = seconds([&] { model = integrateView(model, views, view, options, progress).model; });
      sum += time;
      most = std::max(most, time);
    }
    zippering.push_back(sum);
    slowest.push_back(most);
    averaging.push_back(seconds([&] { published = applyConsensus(model, views, {}, progress); }));
  }
  const MeshMeasures m = measure(published.mesh);
  std::printf("8 views, %zu triangles: zippered in %.3f s (slowest view %.3f s), consensus %.3f s\n", triangles,
              median(zippering), median(slowest), median(averaging));
  std::printf("model: %zu triangles, %zu boundary loops, %zu non-manifold edges, %zu pieces\n", m.triangles,
              m.boundaryLoops, m.nonManifoldEdges, m.components);
  if (!output.empty()) writePly(output, published.mesh);
}

}  // namespace

int main(int argc, char** argv) {
  const auto folder = recordedViewsFolder();
  if (!folder) {
    std::puts("skipped: VANTAGE_PERF_DATA names no folder with view0.rng ... view7.rng");
    return 0;
  }
  try {
    run(*folder, argc > 1 ? argv[1] : "");
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
