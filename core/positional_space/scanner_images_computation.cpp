#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "base/parallel.h"
#include "positional_space/ray_fan.h"
#include "positional_space/scanner_images.h"

namespace vantage {
namespace {

// How the images of a workspace repeat under turns about z that map surface cells to surface cells.
struct Periods {
  int count = 1;    // per turn
  int steps = 1;    // positions per turn
  int columns = 1;  // surface columns per period

  [[nodiscard]] int stepsPerPeriod() const { return steps / count; }
  // Positions whose images are stored: those of the first period of every tilt.
  [[nodiscard]] std::size_t images(int positions) const { return static_cast<std::size_t>(positions / count); }
  [[nodiscard]] std::size_t position(std::size_t image) const {
    const auto per = static_cast<std::size_t>(stepsPerPeriod());
    return image / per * static_cast<std::size_t>(steps) + image % per;
  }
};

bool isTurntable(const Workspace& workspace) {
  const auto steps = static_cast<std::size_t>(std::max(workspace.steps, 0));
  if (steps == 0 || workspace.size() % steps != 0) return false;
  for (std::size_t i = 0; i < workspace.size(); ++i) {
    const double angle = 2.0 * kPi * static_cast<double>(i % steps) / static_cast<double>(steps);
    const Pose expected = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * workspace.poses[i - i % steps];
    if (!workspace.poses[i].isApprox(expected, 1e-9)) return false;
  }
  return true;
}

Periods periodsOf(const Workspace& workspace, int columns) {
  if (!isTurntable(workspace)) return {1, static_cast<int>(workspace.size()), columns};
  const int count = std::gcd(workspace.steps, columns);
  return {count, workspace.steps, columns / count};
}

// The ranging ray of one position through one surface cell.
struct Entry {
  std::uint32_t surfaceCell = 0;  // of the period
  PositionalCell direction;
  std::uint32_t side = 0;
  std::uint32_t period = 0;  // that the surface cell is in
  FanRay ray;

  [[nodiscard]] auto key() const { return std::make_tuple(surfaceCell, direction.phi, direction.psi, side); }
};

// Which quarter around the ray the receiver is in, the quarters centred on across and up.
std::uint32_t receiverSide(const SurfaceCell& cell, const Vec3& source, const Vec3& receiver, const Vec3& direction) {
  Vec3 aside = receiver - source;
  aside -= aside.dot(direction) * direction;
  const double x = aside.dot(cell.across);
  const double y = aside.dot(cell.up);
  if (std::abs(x) >= std::abs(y)) return x >= 0.0 ? 0 : 1;
  return y >= 0.0 ? 2 : 3;
}

std::vector<Entry> entriesOf(const ScannerProfile& profile, const PositionalSpaceGrid& grid, const RayFan& fan,
                             const Periods& periods, const Pose& T_object_scanner) {
  std::vector<Entry> entries;
  std::optional<GridPosition> hint;
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const SurfaceCell& cell = grid.surfaceCell(row, column);
      const auto ray = fan.through(cell, T_object_scanner, hint);
      if (!ray) continue;
      Entry entry;
      entry.surfaceCell = static_cast<std::uint32_t>(row * periods.columns + column % periods.columns);
      entry.period = static_cast<std::uint32_t>(column / periods.columns);
      entry.direction = grid.directionCell(cell, ray->direction);
      if (profile.rays->triangulates()) {
        const Vec3 source = cell.centre + ray->sourceDistance * ray->direction;
        const Vec3 receiver = T_object_scanner * profile.rays->receivers(ray->sample)[0];
        entry.side = receiverSide(cell, source, receiver, ray->direction);
      }
      entry.ray = *ray;
      entries.push_back(entry);
    }
  }
  return entries;
}

// One entry within the lists of all stored images.
struct EntryPlace {
  std::uint32_t image;
  std::uint32_t index;
};

// Mean of the entries that share a cell.
class CellMean {
 public:
  explicit CellMean(std::size_t receivers) : receivers_(receivers, Vec3::Zero()) {}

  void add(const Entry& entry, const ScannerProfile& profile, const Pose& T_object_scanner, double turnBack) {
    slope_ += entry.ray.slope;
    fan_ += entry.ray.fan;
    distance_ += entry.ray.sourceDistance;
    const Pose T_period_scanner = Eigen::AngleAxisd(turnBack, Vec3::UnitZ()) * T_object_scanner;
    const auto positions = profile.rays->receivers(entry.ray.sample);
    for (std::size_t k = 0; k < positions.size(); ++k) receivers_[k] += T_period_scanner * positions[k];
    ++count_;
  }

  [[nodiscard]] OccupiedCell cell(std::uint32_t side) const {
    OccupiedCell cell;
    for (int k = 0; k < 2; ++k) cell.slope[static_cast<std::size_t>(k)] = static_cast<float>(slope_[k] / count_);
    for (int k = 0; k < 4; ++k) cell.fan[static_cast<std::size_t>(k)] = static_cast<float>(fan_(k / 2, k % 2) / count_);
    cell.sourceDistance = static_cast<float>(distance_ / count_);
    cell.receiverSide = side;
    return cell;
  }

  [[nodiscard]] std::vector<Vec3> receivers() const {
    std::vector<Vec3> mean = receivers_;
    for (Vec3& r : mean) r /= count_;
    return mean;
  }

 private:
  Vec2 slope_ = Vec2::Zero();
  Eigen::Matrix2d fan_ = Eigen::Matrix2d::Zero();
  double distance_ = 0.0;
  std::vector<Vec3> receivers_;
  double count_ = 0.0;
};

// A cell of the union before it has its number.
struct UnionCell {
  std::uint32_t surfaceCell;
  std::array<std::int16_t, 2> direction;
  OccupiedCell cell;
  std::vector<Vec3> receivers;
  std::vector<EntryPlace> entries;
};

std::vector<UnionCell> uniteEntries(const ScannerProfile& profile, const Periods& periods,
                                    const std::vector<std::vector<Entry>>& images) {
  std::vector<EntryPlace> order;
  for (std::size_t b = 0; b < images.size(); ++b)
    for (std::size_t k = 0; k < images[b].size(); ++k)
      order.push_back({static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(k)});
  auto entry = [&](const EntryPlace& p) -> const Entry& { return images[p.image][p.index]; };
  std::stable_sort(order.begin(), order.end(),
                   [&](const EntryPlace& a, const EntryPlace& b) { return entry(a).key() < entry(b).key(); });

  std::vector<UnionCell> cells;
  const double period = 2.0 * kPi / periods.count;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const Entry& first = entry(order[begin]);
    CellMean mean(profile.rays->receivers(0).size());
    UnionCell cell;
    for (end = begin; end < order.size() && entry(order[end]).key() == first.key(); ++end) {
      const Pose& pose = profile.workspace.poses[periods.position(order[end].image)];
      mean.add(entry(order[end]), profile, pose, -period * entry(order[end]).period);
      cell.entries.push_back(order[end]);
    }
    cell.surfaceCell = first.surfaceCell;
    cell.direction = {static_cast<std::int16_t>(first.direction.phi), static_cast<std::int16_t>(first.direction.psi)};
    cell.cell = mean.cell(first.side);
    cell.receivers = mean.receivers();
    cells.push_back(std::move(cell));
  }
  std::stable_sort(cells.begin(), cells.end(), [](const UnionCell& a, const UnionCell& b) {
    return std::tie(a.surfaceCell, a.cell.slope[0]) < std::tie(b.surfaceCell, b.cell.slope[0]);
  });
  return cells;
}

ScannerImages::Data assemble(const ScannerProfile& profile, const PositionalSpaceGrid& grid, const Periods& periods,
                             const std::vector<std::vector<Entry>>& images) {
  const std::vector<UnionCell> cells = uniteEntries(profile, periods, images);
  ScannerImages::Data data;
  data.shape = grid.shape();
  data.positions = static_cast<int>(profile.workspace.size());
  data.steps = periods.steps;
  data.periods = periods.count;
  data.receivers = static_cast<int>(profile.rays->receivers(0).size());
  data.minRange = profile.minRange;
  data.maxRange = profile.maxRange;
  data.surfaceStart.assign(static_cast<std::size_t>(grid.rows() * periods.columns) + 1, 0);
  std::vector<std::vector<std::uint32_t>> numbers(images.size());
  for (std::size_t n = 0; n < cells.size(); ++n) {
    ++data.surfaceStart[cells[n].surfaceCell + 1];
    data.cells.push_back(cells[n].cell);
    data.direction.push_back(cells[n].direction);
    data.receiverPositions.insert(data.receiverPositions.end(), cells[n].receivers.begin(), cells[n].receivers.end());
    for (const EntryPlace& p : cells[n].entries)
      numbers[p.image].push_back(static_cast<std::uint32_t>(images[p.image][p.index].period * cells.size() + n));
  }
  std::partial_sum(data.surfaceStart.begin(), data.surfaceStart.end(), data.surfaceStart.begin());
  data.imageStart.push_back(0);
  for (auto& list : numbers) {
    std::sort(list.begin(), list.end());
    data.imageCells.insert(data.imageCells.end(), list.begin(), list.end());
    data.imageStart.push_back(static_cast<std::uint32_t>(data.imageCells.size()));
  }
  return data;
}

}  // namespace

ScannerImages computeScannerImages(const ScannerProfile& profile, const Progress& progress) {
  const PositionalSpaceGrid grid = makePositionalSpaceGrid(profile, progress.part(0.0, 0.1));
  const Periods periods = periodsOf(profile.workspace, grid.columns());
  progress.checkpoint(0.1);
  const RayFan fan(profile.rays, 4.0 * grid.shape().radius);
  progress.checkpoint(0.1);
  std::vector<std::vector<Entry>> images(periods.images(static_cast<int>(profile.workspace.size())));
  parallelChunks(images.size(), 1, progress.part(0.1, 0.9), [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
      images[b] = entriesOf(profile, grid, fan, periods, profile.workspace.poses[periods.position(b)]);
  });
  progress.checkpoint(0.9);
  return ScannerImages(assemble(profile, grid, periods, images));
}

}  // namespace vantage
