#include "positional_space/scanner_images.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/errors.h"
#include "geometry/mesh.h"

namespace vantage {
namespace {

// Whether starts count up from 0 to the end of a list.
bool isPartition(const std::vector<std::uint32_t>& start, std::size_t parts, std::size_t end) {
  return start.size() == parts + 1 && start.front() == 0 && start.back() == end &&
         std::is_sorted(start.begin(), start.end());
}

// Whether every cell leaves in a direction that there is.
bool directionsFit(const ScannerImages::Data& d) {
  const auto known = [&](std::int16_t k) { return k >= 0 && k < d.shape.directions; };
  return std::all_of(d.direction.begin(), d.direction.end(),
                     [&](const auto& k) { return known(k[0]) && known(k[1]); }) &&
         std::all_of(d.cells.begin(), d.cells.end(), [](const OccupiedCell& c) {
           return std::isfinite(c.slope[0]) && std::isfinite(c.slope[1]) && c.receiverSide < 4;
         });
}

bool numbersFit(const ScannerImages::Data& d) {
  for (const double v :
       {d.shape.radius, d.shape.bottom, d.shape.top, d.shape.firstColumn, d.shape.angularError, d.minRange, d.maxRange})
    if (!std::isfinite(v)) return false;
  return d.shape.radius > 0.0 && d.shape.directions > 0 && d.shape.rows > 0 && d.shape.columns > 0 &&
         std::all_of(d.receiverPositions.begin(), d.receiverPositions.end(),
                     [](const Vec3& p) { return p.allFinite(); });
}

bool fits(const ScannerImages::Data& d) {
  if (!numbersFit(d) || !directionsFit(d)) return false;
  if (d.positions < 1 || d.steps < 1 || d.periods < 1 || d.receivers < 0) return false;
  if (d.positions % d.steps != 0 || d.steps % d.periods != 0 || d.shape.columns % d.periods != 0) return false;
  const std::size_t cells = d.cells.size();
  const auto surfaceCells =
      static_cast<std::size_t>(d.shape.rows) * static_cast<std::size_t>(d.shape.columns / d.periods);
  const std::size_t total = cells * static_cast<std::size_t>(d.periods);
  return total < kNoIndex && isPartition(d.surfaceStart, surfaceCells, cells) && d.direction.size() == cells &&
         d.receiverPositions.size() == cells * static_cast<std::size_t>(d.receivers) &&
         isPartition(d.imageStart, static_cast<std::size_t>(d.positions / d.periods), d.imageCells.size()) &&
         std::all_of(d.imageCells.begin(), d.imageCells.end(), [&](std::uint32_t c) { return c < total; });
}

ScannerImages::Data checked(ScannerImages::Data data) {
  if (!fits(data)) throw InvalidInput("scanner images: their parts do not fit together");
  return data;
}

}  // namespace

ScannerImages::ScannerImages(Data data) : data_(checked(std::move(data))), grid_(data_.shape) {
  const std::size_t cells = data_.cells.size();
  const int perPeriod = data_.steps / data_.periods;
  const auto images = static_cast<std::uint32_t>(data_.imageStart.size() - 1);
  positionStart_.assign(cells + 1, 0);
  for (const std::uint32_t number : data_.imageCells) ++positionStart_[number % cells + 1];
  std::partial_sum(positionStart_.begin(), positionStart_.end(), positionStart_.begin());
  positions_.resize(data_.imageCells.size());
  std::vector<std::uint32_t> next(positionStart_.begin(), positionStart_.end() - 1);
  for (std::uint32_t b = 0; b < images; ++b) {
    for (std::uint32_t k = data_.imageStart[b]; k < data_.imageStart[b + 1]; ++k) {
      const auto period = static_cast<int>(data_.imageCells[k] / cells);
      const int step = static_cast<int>(b) % perPeriod + (data_.periods - period) % data_.periods * perPeriod;
      const int tilt = static_cast<int>(b) / perPeriod;
      positions_[next[data_.imageCells[k] % cells]++] = static_cast<std::uint32_t>(tilt * data_.steps + step);
    }
  }
}

ScannerImages::Shift ScannerImages::shiftOf(int position) const {
  const int perPeriod = data_.steps / data_.periods;
  const int tilt = position / data_.steps;
  const int step = position % data_.steps;
  return {static_cast<std::size_t>(tilt * perPeriod + step % perPeriod),
          static_cast<std::size_t>(step / perPeriod) * data_.cells.size()};
}

std::vector<std::uint32_t> ScannerImages::image(int position) const {
  const Shift shift = shiftOf(position);
  const std::size_t total = cellCount();
  std::vector<std::uint32_t> cells(data_.imageCells.begin() + data_.imageStart[shift.image],
                                   data_.imageCells.begin() + data_.imageStart[shift.image + 1]);
  for (std::uint32_t& c : cells) c = static_cast<std::uint32_t>((c + shift.offset) % total);
  std::sort(cells.begin(), cells.end());
  return cells;
}

std::vector<int> ScannerImages::positionsOf(std::uint32_t number) const {
  const std::size_t stored = number % data_.cells.size();
  const int turn = static_cast<int>(number / data_.cells.size()) * (data_.steps / data_.periods);
  std::vector<int> found;
  for (std::uint32_t k = positionStart_[stored]; k < positionStart_[stored + 1]; ++k) {
    const int position = static_cast<int>(positions_[k]);
    const int step = position % data_.steps;
    found.push_back(position - step + (step + turn) % data_.steps);
  }
  std::sort(found.begin(), found.end());
  return found;
}

PositionalCell ScannerImages::cell(std::uint32_t number) const {
  const std::size_t stored = number % data_.cells.size();
  const auto period = static_cast<int>(number / data_.cells.size());
  const int columns = data_.shape.columns / data_.periods;
  const auto after = std::upper_bound(data_.surfaceStart.begin(), data_.surfaceStart.end(), stored);
  const auto surfaceCell = static_cast<int>(after - data_.surfaceStart.begin()) - 1;
  return {surfaceCell / columns, surfaceCell % columns + period * columns, data_.direction[stored][0],
          data_.direction[stored][1]};
}

OutwardRay ScannerImages::ray(std::uint32_t number) const {
  const PositionalCell where = cell(number);
  const SurfaceCell& s = grid_.surfaceCell(where.row, where.column);
  const auto& slope = data_.cells[number % data_.cells.size()].slope;
  const Vec3 direction = s.normal + static_cast<double>(slope[0]) * s.across + static_cast<double>(slope[1]) * s.up;
  return {s.centre, direction.normalized()};
}

std::vector<Vec3> ScannerImages::receivers(std::uint32_t number) const {
  const std::size_t stored = number % data_.cells.size();
  const std::size_t period = number / data_.cells.size();
  const Eigen::AngleAxisd turn(2.0 * kPi * static_cast<double>(period) / data_.periods, Vec3::UnitZ());
  std::vector<Vec3> found;
  const auto count = static_cast<std::size_t>(data_.receivers);
  for (std::size_t k = 0; k < count; ++k) found.push_back(turn * data_.receiverPositions[stored * count + k]);
  return found;
}

}  // namespace vantage
