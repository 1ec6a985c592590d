// Registration of two and of eight views of a mug with relief, against the numbers of other libraries on the same
// inputs: VANTAGE_PERF_DATA names the folder with pair0.rng, pair1.rng and view0.rng ... view7.rng. The disturbed poses
// are theirs as well. Prints medians of the time and the RMS error of the found poses.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "recorded_views.h"
#include "registration/icp.h"
#include "registration/multi_view.h"

using namespace vantage;

namespace {

constexpr int kThreads = 2;
constexpr int kRuns = 5;
const Vec3 kCentre(0, 0, 140);

// splitmix64 and Box-Muller: the disturbed poses are the same on every side of the comparison.
class SharedRandom {
 public:
  explicit SharedRandom(std::uint64_t seed) : state_(seed) {}

  double normal() {
    const double u = std::max(uniform(), 1e-300);
    const double v = uniform();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * kPi * v);
  }
  Vec3 vector() {
    const double x = normal();
    const double y = normal();
    return {x, y, normal()};
  }

 private:
  double uniform() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

  std::uint64_t state_;
};

Pose disturbance(std::uint64_t seed, double angle, double shift) {
  SharedRandom random(1000 + seed);
  const Vec3 axis = random.vector().normalized();
  const Vec3 direction = random.vector().normalized();
  Pose motion = Pose::Identity();
  motion.translate(kCentre + shift * direction);
  motion.rotate(Eigen::AngleAxisd(angle, axis));
  motion.translate(-kCentre);
  return motion;
}

View readView(const std::string& path) {
  return readRecordedView(path, radians(70.0));
}

double squaredError(const View& view, const Pose& found) {
  double squares = 0.0;
  for (const Vec3& p : view.mesh->mesh.vertices) squares += (found * p - view.T_object_scanner * p).squaredNorm();
  return squares;
}

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void registerPair(const std::string& folder) {
  const View fixed = readView(folder + "/pair0.rng");
  const View moving = readView(folder + "/pair1.rng");
  const Mesh model = transformed(fixed.mesh->mesh, fixed.T_object_scanner);
  std::vector<double> times;
  std::vector<double> errors;
  for (int run = 0; run < kRuns; ++run) {
    for (std::uint64_t k = 0; k < 5; ++k) {
      const Pose start = disturbance(k, radians(3.0), 3.0) * moving.T_object_scanner;
      RegistrationResult result;
      times.push_back(seconds([&] {
        const RegistrationTarget target(model, fixed.mesh->confidence);
        result = registerView(*moving.mesh, *moving.image->rays, start, target, {}, Progress({}, {}, kThreads));
      }));
      const auto n = static_cast<double>(moving.mesh->mesh.vertices.size());
      errors.push_back(std::sqrt(squaredError(moving, result.T_object_scanner) / n));
    }
  }
  std::printf("pair: %zu and %zu points, %.3f s, RMS pose error %.4f mm (largest %.4f)\n",
              fixed.mesh->mesh.vertices.size(), moving.mesh->mesh.vertices.size(), median(times), median(errors),
              *std::max_element(errors.begin(), errors.end()));
}

void refineEight(const std::string& folder) {
  std::vector<View> truth;
  std::vector<View> views;
  for (std::uint64_t i = 0; i < 8; ++i) {
    truth.push_back(readView(folder + "/view" + std::to_string(i) + ".rng"));
    views.push_back(truth.back());
    if (i > 0) views.back().T_object_scanner = disturbance(50 + i, radians(1.5), 1.5) * truth.back().T_object_scanner;
  }
  std::vector<double> times;
  times.reserve(kRuns);
  MultiViewResult result;
  for (int run = 0; run < kRuns; ++run)
    times.push_back(seconds([&] { result = refineViews(views, {}, Progress({}, {}, kThreads)); }));
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    squares += squaredError(truth[i], result.poses[i]);
    count += static_cast<double>(truth[i].mesh->mesh.vertices.size());
  }
  std::printf("eight views: %.3f s, RMS pose error %.4f mm, residual %.4f -> %.4f mm\n", median(times),
              std::sqrt(squares / count), result.rmsBefore, result.rmsAfter);
}

}  // namespace

int main() {
  const auto folder = recordedViewsFolder();
  if (!folder) {
    std::puts("skipped: VANTAGE_PERF_DATA names no folder with pair0.rng, pair1.rng, view0.rng ... view7.rng");
    return 0;
  }
  try {
    registerPair(*folder);
    refineEight(*folder);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
