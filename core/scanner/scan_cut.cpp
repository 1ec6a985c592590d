#include "scanner/scan_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "scanner/sample_spacing.h"

namespace vantage {
namespace {

constexpr double kRealJump = 1.4;
constexpr std::size_t kRealIsland = 12;
// The table plane is hit by all but one in 30,000 samples of the table within so many standard deviations.
constexpr double kTableSigmas = 4.0;
// Spacings of the samples that the table plane may be off.
constexpr double kTableSpacings = 0.5;
// Standard deviations of a sample that noise may part neighbours by.
constexpr double kJumpSigmas = 4.0;
// A flying pixel lies between what is up to so many rays away: the fringe of an edge is wider than one.
constexpr int kFringe = 2;
// So few neighbours have the samples of a wide fringe, which lie anywhere between front and back.
constexpr int kFewNeighbours = 1;
// A piece hangs together across one sample that is lost: rods are as thin as that.
constexpr int kIslandReach = 2;
// Rays that are worked on before it is asked whether to go on.
constexpr std::size_t kGrain = 65'536;

struct Step {
  int row;
  int column;
};
// Half of the neighbours in a grid; the others are opposite.
constexpr std::array<Step, 4> kSteps{{{0, 1}, {1, 0}, {1, 1}, {1, -1}}};

// The median of what is there; reorders it.
double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Whether it is known where a scan was taken from.
bool isPlaced(const RangeImage& image) {
  return image.station.position.has_value() || image.poseKnownBy != PoseSource::Unknown;
}

// How neighbouring samples of a range image lie.
class Neighbourhood {
 public:
  Neighbourhood(const RangeImage& image, double lengthRatio, double slack)
      : image_(image), lengthRatio_(lengthRatio), slack_(slack) {}

  // The ray that is `count` steps from ray i; nothing outside of the grid.
  [[nodiscard]] std::optional<std::size_t> ray(std::size_t i, const Step& step, int count) const {
    const RayGrid& rays = *image_.rays;
    const int row = static_cast<int>(i / static_cast<std::size_t>(rays.columns())) + count * step.row;
    const int column = static_cast<int>(i % static_cast<std::size_t>(rays.columns())) + count * step.column;
    if (row < 0 || row >= rays.rows() || column < 0 || column >= rays.columns()) return std::nullopt;
    return rays.index(row, column);
  }

  [[nodiscard]] bool isJump(std::size_t a, std::size_t b) const {
    return (image_.point(a) - image_.point(b)).norm() > lengthRatio_ * raySpacing(image_, a, b) + slack_;
  }

  // Calls visit(j) for the rays up to `reach` steps from ray i that have a sample which is not a jump away.
  template <typename Visit>
  void eachNeighbour(std::size_t i, int reach, const Visit& visit) const {
    for (const Step& step : kSteps)
      for (int count = -reach; count <= reach; ++count)
        if (const auto j = ray(i, step, count); count != 0 && j && image_.valid(*j) && !isJump(i, *j)) visit(*j);
  }

  [[nodiscard]] int neighbours(std::size_t i) const {
    int count = 0;
    eachNeighbour(i, 1, [&](std::size_t /*j*/) { ++count; });
    return count;
  }

  // Whether sample i lies between front and back.
  [[nodiscard]] bool isFlying(std::size_t i) const {
    const auto between = [&](const Step& step, int reach) {
      const Side one = side(i, step, 1, reach);
      const Side other = side(i, step, -1, reach);
      return (one.nearer && other.farther) || (one.farther && other.nearer);
    };
    if (std::any_of(kSteps.begin(), kSteps.end(), [&](const Step& step) { return between(step, 1); })) return true;
    return neighbours(i) <= kFewNeighbours &&
           std::any_of(kSteps.begin(), kSteps.end(), [&](const Step& step) { return between(step, kFringe); });
  }

 private:
  // What lies a jump away on one side of a sample.
  struct Side {
    bool nearer = false;
    bool farther = false;
  };

  [[nodiscard]] Side side(std::size_t i, const Step& step, int sign, int reach) const {
    Side side;
    for (int count = 1; count <= reach; ++count) {
      const auto j = ray(i, step, sign * count);
      if (!j || !image_.valid(*j) || !isJump(i, *j)) continue;
      (image_.range[*j] < image_.range[i] ? side.nearer : side.farther) = true;
    }
    return side;
  }

  const RangeImage& image_;
  double lengthRatio_;
  double slack_;
};

// What of a scan lies outside of its viewing volume.
class VolumeCut {
 public:
  VolumeCut(const RangeImage& image, const ViewingVolume& volume, const CutOptions& options, double sigma)
      : image_(image), volume_(volume), options_(options), sigma_(sigma) {}

  [[nodiscard]] CutReason of(std::size_t i) const {
    const Vec3 p = image_.T_table_scanner * image_.point(i);
    if (p.head<2>().norm() > volume_.radius - options_.radiusMargin || p.z() > volume_.height)
      return CutReason::Outside;
    return p.z() < tableMargin(i) ? CutReason::Table : CutReason::Kept;
  }

 private:
  [[nodiscard]] double tableMargin(std::size_t i) const {
    if (options_.tableMargin) return *options_.tableMargin;
    const double down = std::abs((image_.T_table_scanner.linear() * image_.rays->ray(i).direction).z());
    return kTableSpacings * spacing(i) + kTableSigmas * sigma_ * down;
  }

  // Of the rays at a sample, along the row.
  [[nodiscard]] double spacing(std::size_t i) const {
    const RayGrid& rays = *image_.rays;
    const bool last = (i + 1) % static_cast<std::size_t>(rays.columns()) == 0;
    const std::size_t j = last ? i - 1 : i + 1;
    const Vec3 offset = (rays.ray(j).origin - rays.ray(i).origin) +
                        static_cast<double>(image_.range[i]) * (rays.ray(j).direction - rays.ray(i).direction);
    return offset.norm();
  }

  const RangeImage& image_;
  const ViewingVolume& volume_;
  const CutOptions& options_;
  double sigma_;
};

// Which samples lie in the cylinder of a viewing volume, on the table or not far below.
std::vector<std::uint8_t> near(const RangeImage& image, const ViewingVolume& volume) {
  std::vector<std::uint8_t> near(image.range.size(), 0);
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (!image.valid(i)) continue;
    const Vec3 p = image.T_table_scanner * image.point(i);
    near[i] = p.head<2>().norm() <= volume.radius && std::abs(p.z()) <= volume.height ? 1 : 0;
  }
  return near;
}

// Takes out what hangs together with too little.
void cutIslands(std::vector<CutReason>& reasons, const Neighbourhood& neighbourhood, const CutOptions& options,
                const Progress& progress) {
  std::vector<std::uint8_t> seen(reasons.size(), 0);
  std::vector<std::size_t> piece;
  for (std::size_t first = 0; first < reasons.size(); ++first) {
    if (first % kGrain == 0) progress.checkpoint(static_cast<double>(first) / static_cast<double>(reasons.size()));
    if (reasons[first] != CutReason::Kept || seen[first] != 0) continue;
    piece.assign(1, first);
    seen[first] = 1;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      if (k % kGrain == kGrain - 1)
        progress.checkpoint(static_cast<double>(first) / static_cast<double>(reasons.size()));
      neighbourhood.eachNeighbour(piece[k], kIslandReach, [&](std::size_t j) {
        if (reasons[j] != CutReason::Kept || seen[j] != 0) return;
        seen[j] = 1;
        piece.push_back(j);
      });
    }
    if (options.isolated && piece.size() == 1)
      reasons[first] = CutReason::Isolated;
    else if (piece.size() < options.smallestIsland)
      for (const std::size_t i : piece) reasons[i] = CutReason::Island;
  }
}

}  // namespace

CutOptions cutForRealScanners() {
  CutOptions options;
  options.volume = true;
  options.flyingPixels = true;
  options.flyingJump = kRealJump;
  options.isolated = true;
  options.smallestIsland = kRealIsland;
  return options;
}

bool cutsNothing(const CutOptions& options) {
  return !options.volume && !options.flyingPixels && !options.isolated && options.smallestIsland <= 1;
}

std::string_view name(CutReason reason) {
  switch (reason) {
    case CutReason::Kept:
      return "kept";
    case CutReason::NoSample:
      return "no_sample";
    case CutReason::Table:
      return "table";
    case CutReason::Outside:
      return "outside";
    case CutReason::Flying:
      return "flying";
    case CutReason::Isolated:
      return "isolated";
    case CutReason::Island:
      break;
  }
  return "island";
}

CutScene cutSceneOf(const ScannerProfile& profile) {
  return {profile.viewingVolume, profile.breakdownAngle, profile.noise.rangeSigma};
}

double rangeSigmaOf(const RangeImage& image, std::span<const std::uint8_t> counts, const Progress& progress) {
  // Of a - 2 b + c, by the standard deviation of each; and of the median of the absolute value.
  const double scale = 1.4826 / std::sqrt(6.0);
  std::vector<double> differences;
  const Neighbourhood neighbourhood(image, 1.0, 0.0);
  for (std::size_t i = 0; i < image.range.size(); ++i) {
    if (i % kGrain == 0) progress.checkpoint(static_cast<double>(i) / static_cast<double>(image.range.size()));
    if (!image.valid(i) || (!counts.empty() && counts[i] == 0)) continue;
    for (const Step& step : {Step{0, 1}, Step{1, 0}}) {
      const auto before = neighbourhood.ray(i, step, -1);
      const auto after = neighbourhood.ray(i, step, 1);
      if (!before || !after || !image.valid(*before) || !image.valid(*after)) continue;
      differences.push_back(std::abs(static_cast<double>(image.range[*before]) -
                                     2.0 * static_cast<double>(image.range[i]) +
                                     static_cast<double>(image.range[*after])));
    }
  }
  return differences.empty() ? 0.0 : scale * median(differences);
}

std::vector<CutReason> cutOf(const RangeImage& image, const ScanCut& cut, const Progress& progress) {
  validate(image);
  const CutOptions& options = cut.options;
  const bool hasVolume = options.volume && cut.scene.volume && isPlaced(image);
  const ViewingVolume volume = cut.scene.volume.value_or(ViewingVolume{});
  // A wall far behind is noisier than what stands on the table.
  const double sigma = std::max(
      cut.scene.rangeSigma,
      rangeSigmaOf(image, hasVolume ? near(image, volume) : std::vector<std::uint8_t>{}, progress.part(0.0, 0.3)));
  const Neighbourhood neighbourhood(image, options.flyingJump / std::cos(cut.scene.breakdownAngle),
                                    kJumpSigmas * sigma);
  const VolumeCut volumeCut(image, volume, options, sigma);

  std::vector<CutReason> reasons(image.range.size(), CutReason::NoSample);
  parallelChunks(reasons.size(), kGrain, progress.part(0.3, 0.6), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!image.valid(i)) continue;
      reasons[i] = hasVolume ? volumeCut.of(i) : CutReason::Kept;
      // Of front and back one may lie outside of the volume.
      if (reasons[i] == CutReason::Kept && options.flyingPixels && neighbourhood.isFlying(i))
        reasons[i] = CutReason::Flying;
    }
  });
  if (options.isolated || options.smallestIsland > 1)
    cutIslands(reasons, neighbourhood, options, progress.part(0.6, 1.0));
  return reasons;
}

CutCounts countsOf(std::span<const CutReason> reasons) {
  CutCounts counts{};
  for (const CutReason reason : reasons) ++counts[static_cast<std::size_t>(reason)];
  return counts;
}

std::size_t cutSamples(const CutCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0}) -
         counts[static_cast<std::size_t>(CutReason::Kept)] - counts[static_cast<std::size_t>(CutReason::NoSample)];
}

RangeImage withoutCut(const RangeImage& image, std::span<const CutReason> reasons) {
  RangeImage cut = image;
  for (std::size_t i = 0; i < cut.range.size(); ++i)
    if (reasons[i] != CutReason::Kept) cut.range[i] = kNoSample;
  return cut;
}

CutImage cutImage(const std::shared_ptr<const RangeImage>& image, const ScanCut& cut, const Progress& progress) {
  if (cutsNothing(cut.options)) return {image, {}};
  const std::vector<CutReason> reasons = cutOf(*image, cut, progress);
  const CutCounts counts = countsOf(reasons);
  if (cutSamples(counts) == 0) return {image, counts};
  return {std::make_shared<const RangeImage>(withoutCut(*image, reasons)), counts};
}

}  // namespace vantage
