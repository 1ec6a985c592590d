#include "io/no_sample.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "io/grid_file.h"

namespace vantage {
namespace {

// A point is a mark when so many cells share it; a zero point already when it stands there twice.
constexpr std::size_t kLeastRepeats = 8;
constexpr double kRepeatedShare = 0.002;
// Points are told apart roughly before they are compared.
constexpr unsigned kBucketBits = 16;
constexpr std::size_t kLeastZeros = 2;
// A plane of constant depth: at least so many of the cells, at equal depth but for rounding.
constexpr double kPlaneShare = 0.02;
constexpr std::size_t kLeastPlane = 20;
constexpr double kEqualDepth = 1e-6;
// It is no surface when it lies so many times the size of the rest behind it, or half of that size where the rest has
// noise and it has none.
constexpr double kFarGap = 3.0;
constexpr double kSomeGap = 0.5;
constexpr double kDistinctShare = 0.5;
// Farther from the median than this many times the middle half of the values, along the axis where that is widest: a
// wall is as thin as its noise along one.
constexpr double kOutOfProportion = 1000.0;

std::vector<Vec3> pointsOf(const SampleGrid& grid) {
  std::vector<Vec3> points;
  points.reserve(grid.cell.size());
  for (const std::uint32_t cell : grid.cell)
    if (cell != kNoIndex) points.push_back(grid.points[cell]);
  return points;
}

bool before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

// Equal for equal points.
std::size_t bucketOf(const Vec3& p) {
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k)
    hash = (hash ^ std::bit_cast<std::uint64_t>(p[k] + 0.0)) * 0x9e3779b97f4a7c15ULL;  // -0 + 0 is 0
  return hash >> (64U - kBucketBits);
}

// The point that most cells share, at least `least` of them, and how many do; 0 where there is none.
std::pair<Vec3, std::size_t> mostRepeated(const std::vector<Vec3>& points, std::size_t least) {
  std::vector<std::size_t> counts(std::size_t{1} << kBucketBits, 0);
  for (const Vec3& p : points) ++counts[bucketOf(p)];
  std::vector<Vec3> candidates;
  std::copy_if(points.begin(), points.end(), std::back_inserter(candidates),
               [&](const Vec3& p) { return counts[bucketOf(p)] >= least; });
  std::sort(candidates.begin(), candidates.end(), before);
  std::pair<Vec3, std::size_t> most{Vec3::Zero(), 0};
  for (std::size_t i = 0, j = 0; i < candidates.size(); i = j) {
    while (j < candidates.size() && candidates[j] == candidates[i]) ++j;
    if (j - i >= least && j - i > most.second) most = {candidates[i], j - i};
  }
  return most;
}

// The value that so many others are not greater than; reorders them.
double ranked(std::vector<double>& values, std::size_t rank) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

class Dropper {
 public:
  Dropper(SampleGrid& grid, std::optional<double> given) : grid_(grid), given_(given) {}

  NoSamples drop(const Progress& progress) {
    if (given_)
      take(NoSampleMark::Given, [&](const Vec3& p) { return p.z() == *given_ || p == Vec3::Constant(*given_); });
    progress.checkpoint(0.0);
    dropZeros();
    do {
      progress.checkpoint(0.2);
    } while (dropRepeated());
    progress.checkpoint(0.4);
    dropOutliers(progress);
    for (const bool high : {false, true}) {
      progress.checkpoint(high ? 0.8 : 0.7);
      dropPlane(high);
    }
    progress.checkpoint(1.0);
    return found_;
  }

 private:
  template <typename Predicate>
  void take(NoSampleMark mark, const Predicate& isNone) {
    const std::size_t dropped = dropSamples(grid_, isNone);
    if (dropped > mostOfOne_) {
      mostOfOne_ = dropped;
      found_.mark = mark;
    }
    found_.dropped += dropped;
  }

  void dropZeros() {
    const auto isZero = [](const Vec3& p) { return p.isZero(0.0); };
    const auto points = pointsOf(grid_);
    if (static_cast<std::size_t>(std::count_if(points.begin(), points.end(), isZero)) >= kLeastZeros)
      take(NoSampleMark::Zero, isZero);
  }

  bool dropRepeated() {
    const double share = std::ceil(kRepeatedShare * static_cast<double>(grid_.cell.size()));
    const auto [point, count] = mostRepeated(pointsOf(grid_), std::max(kLeastRepeats, static_cast<std::size_t>(share)));
    if (count == 0) return false;
    const Vec3 mark = point;
    take(NoSampleMark::Repeated, [&](const Vec3& p) { return p == mark; });
    return true;
  }

  void dropOutliers(const Progress& progress) {
    const std::vector<Vec3> points = pointsOf(grid_);
    if (points.size() < 4) return;
    Vec3 middle;
    double half = 0.0;
    for (int k = 0; k < 3; ++k) {
      progress.checkpoint(0.4 + 0.1 * k);
      std::vector<double> values;
      values.reserve(points.size());
      for (const Vec3& p : points) values.push_back(p[k]);
      middle[k] = ranked(values, values.size() / 2);
      const double upper = ranked(values, 3 * values.size() / 4);
      half = std::max(half, upper - ranked(values, values.size() / 4));
    }
    if (!(half > 0.0)) return;
    take(NoSampleMark::Outlier,
         [&](const Vec3& p) { return (p - middle).cwiseAbs().maxCoeff() > kOutOfProportion * half; });
  }

  // The samples of the least or the greatest depth.
  void dropPlane(bool high) {
    std::vector<Vec3> points = pointsOf(grid_);
    if (points.size() < 2 * kLeastPlane) return;
    const auto lower = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
    const auto extreme = high ? std::max_element(points.begin(), points.end(), lower)
                              : std::min_element(points.begin(), points.end(), lower);
    const double depth = extreme->z();
    const auto isEqual = [&](const Vec3& p) { return std::abs(p.z() - depth) <= kEqualDepth * std::abs(depth); };
    const auto count = static_cast<std::size_t>(std::count_if(points.begin(), points.end(), isEqual));
    const double least = kPlaneShare * static_cast<double>(grid_.cell.size());
    if (count < kLeastPlane || static_cast<double>(count) < least || count == points.size()) return;
    std::sort(points.begin(), points.end(), lower);
    if (high) std::reverse(points.begin(), points.end());
    const auto rest = std::find_if_not(points.begin(), points.end(), isEqual);
    if (isNoSurface({rest, points.end()}, std::abs(rest->z() - depth))) take(NoSampleMark::FarPlane, isEqual);
  }

  // Whether a plane so far from the rest of the samples is none.
  static bool isNoSurface(const std::vector<Vec3>& rest, double gap) {
    Vec3 low = rest.front();
    Vec3 high = rest.front();
    for (const Vec3& p : rest) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const double size = (high - low).maxCoeff();
    if (gap > kFarGap * size) return true;
    std::size_t distinct = 1;
    for (std::size_t i = 1; i < rest.size(); ++i) distinct += rest[i].z() != rest[i - 1].z() ? 1U : 0U;
    const bool varies = static_cast<double>(distinct) > kDistinctShare * static_cast<double>(rest.size());
    return varies && gap > kSomeGap * size;
  }

  SampleGrid& grid_;
  std::optional<double> given_;
  NoSamples found_;
  std::size_t mostOfOne_ = 0;
};

}  // namespace

NoSamples dropNoSamples(SampleGrid& grid, std::optional<double> given, const Progress& progress) {
  NoSamples found = Dropper(grid, given).drop(progress);
  if (found.dropped > 0) keepUsedPoints(grid);
  return found;
}

}  // namespace vantage
