#include "calibration/sample_end.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scanner/triangulation.h"

namespace vantage {
namespace {

constexpr double kSteepest = radians(85.0);
constexpr int kFirst = 45;         // below it every scanner measures [deg]
constexpr int kEnd = 85;           // [deg]
constexpr std::size_t kLeast = 5;  // angles in a degree, and bins that are to have them
// Of what surface that leans all ways gives: where it ends, and where it has surely not, and has surely.
constexpr double kHalf = 0.5;
constexpr double kNearlyAll = 0.8;
constexpr double kNearlyNone = 0.03;
constexpr double kMost = 0.985;  // of any angles are below their end

using Density = std::array<double, kEnd>;

// Per degree, in proportion to what surface that leans all ways gives; evened out over three degrees.
Density densityOf(std::span<const double> angles) {
  Density counts{};
  for (const double angle : angles) {
    const auto degree = static_cast<std::size_t>(degrees(angle));
    if (degree < counts.size()) counts[degree] += 1.0;
  }
  Density density{};
  for (std::size_t d = kFirst - 1; d < counts.size(); ++d) {
    double sum = 0.0;
    double expected = 0.0;
    for (std::size_t k = d - 1; k <= std::min<std::size_t>(d + 1, kEnd - 1); ++k) {
      const double middle = radians(static_cast<double>(k) + 0.5);
      sum += counts[k];
      expected += std::sin(middle) * std::cos(middle);
    }
    density[d] = sum / expected;
  }
  return density;
}

// The last degree with at least that share of the density.
int lastWith(const Density& density, double least) {
  for (int d = kEnd - 1; d >= kFirst; --d)
    if (density[static_cast<std::size_t>(d)] >= least) return d;
  return kFirst;
}

SampleEnd quantileEnd(std::span<const double> angles) {
  std::vector<double> sorted(angles.begin(), angles.end());
  std::sort(sorted.begin(), sorted.end());
  const double end = sorted[static_cast<std::size_t>(kMost * static_cast<double>(sorted.size() - 1))];
  return {end, end, std::max(end, kSteepest)};
}

}  // namespace

SampleEnd sampleEnd(std::span<const double> angles) {
  const Density density = densityOf(angles);
  std::vector<double> usual(density.begin() + kFirst, density.end());
  std::sort(usual.begin(), usual.end());
  // What ends late leaves few degrees without, what ends early many: the usual one is that of those which have some.
  const double some = kNearlyNone * usual[usual.size() * 3 / 4];
  std::erase_if(usual, [&](double value) { return value <= some; });
  if (usual.size() < kLeast || usual[usual.size() / 2] < static_cast<double>(kLeast)) return quantileEnd(angles);
  const double all = usual[usual.size() / 2];
  return {radians(lastWith(density, kHalf * all) + 1.0), radians(lastWith(density, kNearlyAll * all)),
          radians(lastWith(density, kNearlyNone * all) + 1.0)};
}

std::vector<double> incidenceAngles(std::span<const RangeImage> scans, const Progress& progress) {
  TriangulationOptions options;
  options.breakdownAngle = kSteepest;
  std::vector<double> angles;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    progress.checkpoint(static_cast<double>(k) / static_cast<double>(scans.size()));
    const ViewMesh view = triangulate(scans[k], options);
    // Of single triangles noise says that they lean more than they do.
    for (const float cosine : view.confidence) angles.push_back(std::acos(std::min(1.0, static_cast<double>(cosine))));
  }
  return angles;
}

}  // namespace vantage
