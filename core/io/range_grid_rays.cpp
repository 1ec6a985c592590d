#include "io/range_grid_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/mesh.h"

namespace vantage {
namespace {

constexpr int kReweightings = 30;
constexpr double kDeviationFloor = 0.04;  // of the pitch: smaller deviations count alike
constexpr double kLeastSlope = 1e-4;      // below this it is rounding of the file's numbers
constexpr double kMostSlope = 2.0;        // 63 degrees: no scanner looks along its own surface
constexpr int kMedianRounds = 10;
constexpr int kSpreadSweeps = 40;

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Two neighbouring samples: how x (or y) changes from one to the other, and what that may depend on.
struct Step {
  Eigen::Matrix<double, 6, 1> features;  // along a row, from an even row, from an odd row, dz, d(u z), d(v z)
  Vec2 change;
};

std::vector<Step> collectSteps(const SampleGrid& grid, double z0) {
  std::vector<Step> steps;
  auto at = [&](int r, int c) {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(c);
  };
  auto u = [&](int c) { return (c - 0.5 * grid.columns) / grid.columns; };
  auto v = [&](int r) { return (r - 0.5 * grid.rows) / grid.rows; };
  auto add = [&](int r, int c, int r2, int c2) {
    if (r2 >= grid.rows || c2 >= grid.columns) return;
    const std::uint32_t from = grid.cell[at(r, c)];
    const std::uint32_t to = grid.cell[at(r2, c2)];
    if (from == kNoIndex || to == kNoIndex) return;
    const double z = grid.points[from].z() - z0;
    const double z2 = grid.points[to].z() - z0;
    Step step;
    step.features << (c2 > c ? 1.0 : 0.0), (r2 > r && r % 2 == 0 ? 1.0 : 0.0), (r2 > r && r % 2 == 1 ? 1.0 : 0.0),
        z2 - z, u(c2) * z2 - u(c) * z, v(r2) * z2 - v(r) * z;
    step.change = (grid.points[to] - grid.points[from]).head<2>();
    steps.push_back(step);
  };
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.columns; ++c) {
      add(r, c, r, c + 1);
      add(r, c, r + 1, c);
    }
  }
  return steps;
}

Vec6 fitSteps(const std::vector<Step>& steps, int axis, double floor) {
  Vec6 fit = Vec6::Zero();
  for (int i = 0; i < kReweightings; ++i) {
    Mat6 a = Mat6::Zero();  // the lower half, which is what is solved
    Vec6 b = Vec6::Zero();
    for (const Step& step : steps) {
      const double deviation = step.change[axis] - step.features.dot(fit);
      const double weight = i == 0 ? 1.0 : floor / (floor + std::abs(deviation));
      const Vec6 weighted = weight * step.features;
      for (int k = 0; k < 6; ++k)
        for (int j = k; j < 6; ++j) a(j, k) += weighted[j] * step.features[k];
      b += weight * step.change[axis] * step.features;
    }
    // What nothing tells about stays 0.
    a.diagonal().array() += 1e-12 * a.trace() + 1e-30;
    fit = a.ldlt().solve(b);
  }
  return fit;
}

double meanHeight(const SampleGrid& grid) {
  double sum = 0.0;
  for (const Vec3& p : grid.points) sum += p.z();
  return sum / static_cast<double>(grid.points.size());
}

Vec2 slopeAt(const SightSlopes& slopes, const SampleGrid& grid, int r, int c) {
  return slopes.constant + slopes.column * ((c - 0.5 * grid.columns) / grid.columns) +
         slopes.row * ((r - 0.5 * grid.rows) / grid.rows);
}

// One coordinate of the grid's cells: known values, and a model of them.
class CoordinateFill {
 public:
  CoordinateFill(int rows, int columns, std::vector<double> known)
      : rows_(rows),
        columns_(columns),
        known_(std::move(known)),
        rowOffset_(static_cast<std::size_t>(rows)),
        columnOffset_(static_cast<std::size_t>(columns)) {}

  std::vector<double> fill() {
    fitPitch();
    for (int i = 0; i < kMedianRounds; ++i) {
      fitOffsets(columnOffset_, 1, false);
      // Interlaced rows come in pairs: a row without samples follows those of its own kind.
      fitOffsets(rowOffset_, 2, true);
    }
    return spread();
  }

 private:
  std::size_t at(int r, int c) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
  }
  bool isKnown(std::size_t i) const { return known_[i] == known_[i]; }

  double model(int r, int c) const {
    return perColumn_ * c + perRow_ * r + rowOffset_[static_cast<std::size_t>(r)] +
           columnOffset_[static_cast<std::size_t>(c)];
  }

  // Median change from a sample to the next in the same row, and two rows on in the same column.
  void fitPitch() {
    std::vector<double> along;
    std::vector<double> across;
    for (int r = 0; r < rows_; ++r) {
      for (int c = 0; c < columns_; ++c) {
        if (!isKnown(at(r, c))) continue;
        if (c + 1 < columns_ && isKnown(at(r, c + 1))) along.push_back(known_[at(r, c + 1)] - known_[at(r, c)]);
        if (r + 2 < rows_ && isKnown(at(r + 2, c))) across.push_back(known_[at(r + 2, c)] - known_[at(r, c)]);
      }
    }
    perColumn_ = along.empty() ? 0.0 : median(along);
    perRow_ = across.empty() ? 0.0 : 0.5 * median(across);
  }

  void fitOffsets(std::vector<double>& offset, std::size_t stride, bool ofRows) {
    std::vector<std::vector<double>> left(offset.size());
    std::fill(offset.begin(), offset.end(), 0.0);
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c)
        if (isKnown(at(r, c))) left[static_cast<std::size_t>(ofRows ? r : c)].push_back(known_[at(r, c)] - model(r, c));
    for (std::size_t first = 0; first < std::min(stride, offset.size()); ++first)
      interpolate(left, offset, first, stride);
  }

  // Offsets first, first + stride, ...: medians where there are samples, linear between them, constant beyond.
  static void interpolate(std::vector<std::vector<double>>& left, std::vector<double>& offset, std::size_t first,
                          std::size_t stride) {
    std::vector<std::size_t> found;
    for (std::size_t i = first; i < offset.size(); i += stride) {
      if (left[i].empty()) continue;
      offset[i] = median(left[i]);
      found.push_back(i);
    }
    if (found.empty()) return;
    for (std::size_t i = first; i < offset.size(); i += stride) {
      const auto next = std::lower_bound(found.begin(), found.end(), i);
      if (next == found.begin() || next == found.end()) {
        offset[i] = offset[next == found.end() ? found.back() : *next];
      } else if (*next != i) {
        const std::size_t before = *(next - 1);
        const double t = static_cast<double>(i - before) / static_cast<double>(*next - before);
        offset[i] = (1.0 - t) * offset[before] + t * offset[*next];
      }
    }
  }

  // Gauss-Seidel sweeps of the mean over the four neighbours, from nothing: what is left at the samples reaches some
  // cells far and no farther.
  std::vector<double> spread() const {
    std::vector<double> left(known_.size(), 0.0);
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c)
        if (isKnown(at(r, c))) left[at(r, c)] = known_[at(r, c)] - model(r, c);
    for (int sweep = 0; sweep < kSpreadSweeps; ++sweep) {
      for (int k = 0; k < rows_; ++k) {
        const int r = sweep % 2 == 0 ? k : rows_ - 1 - k;
        for (int c = 0; c < columns_; ++c)
          if (!isKnown(at(r, c)))
            left[at(r, c)] = 0.25 * (left[at(std::max(r - 1, 0), c)] + left[at(std::min(r + 1, rows_ - 1), c)] +
                                     left[at(r, std::max(c - 1, 0))] + left[at(r, std::min(c + 1, columns_ - 1))]);
      }
    }
    std::vector<double> filled = known_;
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c)
        if (!isKnown(at(r, c))) filled[at(r, c)] = model(r, c) + left[at(r, c)];
    return filled;
  }

  int rows_;
  int columns_;
  std::vector<double> known_;
  std::vector<double> rowOffset_;
  std::vector<double> columnOffset_;
  double perColumn_ = 0.0;
  double perRow_ = 0.0;
};

}  // namespace

SightSlopes fitSightSlopes(const SampleGrid& grid) {
  const std::vector<Step> steps = collectSteps(grid, meanHeight(grid));
  SightSlopes slopes;
  if (steps.empty()) return slopes;
  std::vector<double> lengths;
  lengths.reserve(steps.size());
  for (const Step& step : steps) lengths.push_back(step.change.norm());
  const double floor = std::max(kDeviationFloor * median(lengths), 1e-9);
  for (int axis = 0; axis < 2; ++axis) {
    const Vec6 fit = fitSteps(steps, axis, floor);
    const double most = std::abs(fit[3]) + 0.5 * std::abs(fit[4]) + 0.5 * std::abs(fit[5]);
    if (!(most > kLeastSlope && most < kMostSlope)) continue;
    slopes.constant[axis] = fit[3];
    slopes.column[axis] = fit[4];
    slopes.row[axis] = fit[5];
  }
  return slopes;
}

void fillGridPositions(int rows, int columns, std::vector<Vec2>& positions) {
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<double> known(positions.size());
    std::transform(positions.begin(), positions.end(), known.begin(), [axis](const Vec2& p) { return p[axis]; });
    const std::vector<double> filled = CoordinateFill(rows, columns, std::move(known)).fill();
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i][axis] = filled[i];
  }
}

std::vector<RangingRay> reconstructRays(const SampleGrid& grid, double top) {
  const SightSlopes slopes = fitSightSlopes(grid);
  const double z0 = meanHeight(grid);
  // Where the rays pass the plane z = z0.
  std::vector<Vec2> positions(grid.cell.size(), Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
  std::vector<RangingRay> rays(grid.cell.size());
  auto forCells = [&](const auto& what) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const int r = static_cast<int>(i / static_cast<std::size_t>(grid.columns));
      const int c = static_cast<int>(i % static_cast<std::size_t>(grid.columns));
      what(i, slopeAt(slopes, grid, r, c));
    }
  };
  forCells([&](std::size_t i, const Vec2& slope) {
    if (grid.cell[i] == kNoIndex) return;
    const Vec3& p = grid.points[grid.cell[i]];
    positions[i] = p.head<2>() - slope * (p.z() - z0);
  });
  fillGridPositions(grid.rows, grid.columns, positions);
  forCells([&](std::size_t i, const Vec2& slope) {
    const Vec2 origin = positions[i] + slope * (top - z0);
    rays[i] = {Vec3(origin.x(), origin.y(), top), -Vec3(slope.x(), slope.y(), 1.0).normalized()};
  });
  return rays;
}

}  // namespace vantage
