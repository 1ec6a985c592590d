// What positional space costs: the accumulation's rays per second against the ray caster alone on the same rays, the
// time of P_s and P_v for a model, and the sums for 90 and 900 positions. Both sides of a ratio take turns in one run,
// and the medians are compared.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "positional_space/objective_sums.h"
#include "positional_space/observation_rays.h"
#include "positional_space/positional_image.h"
#include "support/scenes/small_profiles.h"

using namespace vantage;

namespace {

constexpr int kRuns = 7;
constexpr std::size_t kPacket = 256;
// Rays of the raw side per chunk of work: about those of a chunk of sources.
constexpr std::size_t kRaysPerChunk = 64 * kPacket;
const double kBreakdown = radians(60.0);
constexpr AccumulationOptions kOptions{.keepSightings = false, .surfaceOffset = 0.05};

// A (2, 3) torus knot with a wavy tube, 60 mm about the middle of the viewing volume: 2 * around * along triangles.
Mesh makeKnot(int along, int around) {
  auto spine = [](double t) {
    const double r = 45.0 + 16.0 * std::cos(3.0 * t);
    return Vec3(r * std::cos(2.0 * t), r * std::sin(2.0 * t), 150.0 + 30.0 * std::sin(3.0 * t));
  };
  Mesh mesh;
  for (int i = 0; i < along; ++i) {
    const double t = 2.0 * kPi * i / along;
    const Vec3 forward = (spine(t + 1e-4) - spine(t - 1e-4)).normalized();
    const Vec3 side = forward.cross(Vec3::UnitZ()).normalized();
    const Vec3 up = side.cross(forward);
    for (int j = 0; j < around; ++j) {
      const double a = 2.0 * kPi * j / around;
      const double radius = 12.0 + 1.5 * std::sin(5.0 * a + 20.0 * t);
      mesh.vertices.push_back(spine(t) + radius * (std::cos(a) * side + std::sin(a) * up));
    }
  }
  auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(i % along * around + j % around); };
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
    }
  }
  return mesh;
}

ScannerProfile profile(const std::string& scanner, const std::string& workspace) {
  return parseProfile({"benchmark",
                       R"({"name": "benchmark", "scanner": {)" + scanner +
                           R"("breakdown_angle_deg": 60, "range_mm": [50, 900]}, "workspace": {)" + workspace + "}}",
                       {}});
}

const std::string kStripe =
    R"("type": "rotating_stripe", "position": [300, 0, 150], "stripe_height_mm": 300, "samples_per_stripe": 250,
       "stripes": 240, "sweep_deg": 60,)";
const std::string kCamera =
    R"("type": "pinhole", "position": [450, 0, 150], "look_at": [0, 0, 150], "rows": 200, "columns": 240,
       "horizontal_fov_deg": 40, "vertical_fov_deg": 40,)";
const std::string kTurntable90 = R"("type": "turntable", "steps": 90)";
const std::string kTurntable900 = R"("type": "turntable", "steps": 900)";
const std::string kTilts = R"("type": "turntable_tilt", "steps": 90, "tilt_center": [0, 0, 150],
                              "tilts_deg": [-25, -20, -15, -10, -5, 0, 5, 10, 15, 20, 25])";
const std::string kNoReceivers = R"("receivers": [],)";
const std::string kReceiver = R"("receivers": [[60, 0, 0]],)";

double seconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Medians of works that take turns.
std::vector<double> medians(const std::vector<std::function<void()>>& works) {
  std::vector<std::vector<double>> times(works.size());
  for (int run = 0; run < kRuns; ++run)
    for (std::size_t k = 0; k < works.size(); ++k) times[k].push_back(seconds(works[k]));
  std::vector<double> middle;
  for (auto& t : times) {
    std::sort(t.begin(), t.end());
    middle.push_back(t[t.size() / 2]);
  }
  return middle;
}

// The same rays through the ray caster alone: copied into a stream, as the caster overwrites them, and traced.
void traceRaw(const std::vector<OcclusionRay>& rays, const RayCaster& obstacles, const Progress& progress) {
  parallelChunks(rays.size(), kRaysPerChunk, progress, [&](std::size_t begin, std::size_t end) {
    std::vector<OcclusionRay> stream(kPacket);
    for (std::size_t k = begin; k < end; k += kPacket) {
      const std::size_t count = std::min(kPacket, end - k);
      std::copy_n(rays.begin() + static_cast<std::ptrdiff_t>(k), count, stream.begin());
      obstacles.occluded(std::span(stream).first(count));
    }
  });
}

void compareWithRaw(const char* name, const ScannerImages& images, const std::vector<ObservationSource>& sources,
                    const RayCaster& obstacles) {
  ObservationBatch batch;
  const CellLookup lookup(images);
  ObservationRays generator(images, lookup, kBreakdown, kOptions);
  for (std::size_t s = 0; s < sources.size(); ++s) generator.append(sources[s], static_cast<std::uint32_t>(s), batch);
  const double rays = static_cast<double>(batch.rays.size());
  for (const int threads : {1, 2}) {
    const Progress progress(nullptr, {}, threads);
    const auto t = medians({[&] { traceRaw(batch.rays, obstacles, progress); },
                            [&] { (void)accumulate(sources, obstacles, images, kBreakdown, kOptions, progress); }});
    std::printf("%-28s threads %d  rays/source %6.1f  raw %6.2f Mrays/s  accumulation %6.2f Mrays/s  share %.3f\n",
                name, threads, rays / static_cast<double>(sources.size()), rays / t[0] / 1e6, rays / t[1] / 1e6,
                t[0] / t[1]);
  }
}

}  // namespace

int main() {
  const Mesh knot = makeKnot(500, 30);
  const RayCaster obstacles(knot);
  const std::vector<ObservationSource> all = vantage::testing::sourcesOf(knot);
  std::vector<ObservationSource> some;
  for (std::size_t s = 0; s < all.size(); s += 5) some.push_back(all[s]);
  std::printf("model of %zu triangles\n", knot.triangles.size());

  const ScannerImages stripe = computeScannerImages(profile(kStripe + kNoReceivers, kTurntable90));
  const ScannerImages tilts = computeScannerImages(profile(kCamera + kNoReceivers, kTilts));
  compareWithRaw("stripe", stripe, all, obstacles);
  compareWithRaw("camera with tilts", tilts, some, obstacles);

  const ScannerImages few = computeScannerImages(profile(kStripe + kReceiver, kTurntable90));
  const ScannerImages many = computeScannerImages(profile(kStripe + kReceiver, kTurntable900));
  const Progress two(nullptr, {}, 2);
  PositionalImage ofFew;
  PositionalImage ofMany;
  const auto t = medians({[&] { ofFew = accumulate(all, obstacles, few, kBreakdown, kOptions, two); },
                          [&] { ofMany = accumulate(all, obstacles, many, kBreakdown, kOptions, two); },
                          [&] { (void)intersect(ofFew, few); }, [&] { (void)intersect(ofMany, many); }});
  std::printf("P of the whole model, with lines of sight, 2 threads: 90 positions %.3f s, 900 positions %.3f s\n", t[0],
              t[1]);
  std::printf("sums over all positions: 90 positions %.6f s, 900 positions %.6f s; in all 900 / 90 = %.3f\n", t[2],
              t[3], (t[1] + t[3]) / (t[0] + t[2]));
}
