#include "positional_space/observation_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace vantage {
namespace {

// Steps over all slopes in which the occupied cells of a surface cell are looked up.
constexpr int kStepsUp = 16;
constexpr int kStepsAcross = 64;
// Slopes beyond any that a cell can have.
constexpr float kAnySlope = 1e9F;
// [mm] A source nearer than this to the plane of a surface cell sees it edge-on.
constexpr float kLeastDistance = 1e-3F;

// The step of a slope: uniform in slope / (1 + |slope|), which is cheap and covers all slopes.
int stepOf(float slope, int steps) {
  const float x = slope / (1.0F + std::abs(slope));
  return std::clamp(static_cast<int>((x + 1.0F) * (0.5F * static_cast<float>(steps))), 0, steps - 1);
}

}  // namespace

// A source and what of it depends on the column only: how far its centre is from the axis along the column's direction
// and sideways, and its normal's part along the column's direction.
struct ObservationRays::View {
  View(const ObservationSource& source, double offset, const ObservationRays& rays);


  float px, py, pz;
  float nx, ny, nz;
  float ox, oy, oz;  // where its rays begin
  float axial;       // of the centre
  float normalAxial;
  float inward;      // centre . normal in the horizontal plane
  std::array<float, PositionalSpaceGrid::kMostColumns> along;
  std::array<float, PositionalSpaceGrid::kMostColumns> aside;
  std::array<float, PositionalSpaceGrid::kMostColumns> normalAlong;
};

// A surface cell as a source sees it: its middle in the frame of the cell, from the source.
struct ObservationRays::Candidate {
  std::size_t row;
  std::size_t column;
  float ahead;   // along the cell's normal
  float across;
  float up;
};

// An occupied cell that an observation ray is in.
struct ObservationRays::Match {
  std::uint32_t cell;    // stored
  float across;          // where in the surface cell the rays are collinear
  float up;
  float off;             // squared, relative to the size of the surface cell
  std::uint32_t side;
};

ObservationRays::View::View(const ObservationSource& source, double offset, const ObservationRays& rays)
    : px(static_cast<float>(source.centre.x())),
      py(static_cast<float>(source.centre.y())),
      pz(static_cast<float>(source.centre.z())),
      nx(static_cast<float>(source.normal.x())),
      ny(static_cast<float>(source.normal.y())),
      nz(static_cast<float>(source.normal.z())) {
  const Vec3 origin = source.centre + offset * source.normal;
  ox = static_cast<float>(origin.x());
  oy = static_cast<float>(origin.y());
  oz = static_cast<float>(origin.z());
  axial = std::sqrt(px * px + py * py);
  normalAxial = std::sqrt(nx * nx + ny * ny);
  inward = px * nx + py * ny;
  for (std::size_t j = 0; j < rays.columns_; ++j) {
    along[j] = px * rays.cosine_[j] + py * rays.sine_[j];
    aside[j] = py * rays.cosine_[j] - px * rays.sine_[j];
    normalAlong[j] = nx * rays.cosine_[j] + ny * rays.sine_[j];
  }
}

void ObservationBatch::clear() {
  rays.clear();
  observations.clear();
  cells.clear();
}

ObservationRays::ObservationRays(const ScannerImages& scanner, double breakdownAngle,
                                 const AccumulationOptions& options)
    : scanner_(scanner),
      options_(options),
      minCosine_(static_cast<float>(std::cos(breakdownAngle))),
      minRange_(static_cast<float>(scanner.data().minRange)),
      maxRange_(static_cast<float>(scanner.data().maxRange)),
      columns_(static_cast<std::size_t>(scanner.grid().columns())),
      columnsPerPeriod_(columns_ / static_cast<std::size_t>(scanner.data().periods)) {
  for (std::size_t column = 0; column < columns_; ++column) {
    const Vec3& across = scanner.grid().surfaceCell(0, static_cast<int>(column)).across;
    cosine_.push_back(static_cast<float>(across.y()));
    sine_.push_back(static_cast<float>(-across.x()));
  }
  for (int row = 0; row < scanner.grid().rows(); ++row) addRow(row);
  addFanRanges();
  addSlopeRanges();
  addLookup();
}

void ObservationRays::addRow(int row) {
  const SurfaceCell& cell = scanner_.grid().surfaceCell(row, 0);
  // Aimed elsewhere in the cell, a ray is longer or shorter and ends farther or nearer by at most half a diagonal.
  const double slack = std::hypot(cell.halfWidth, cell.halfHeight) * (1.0 + static_cast<double>(minCosine_));
  rows_.push_back({static_cast<float>(cell.centre.head<2>().norm()), static_cast<float>(cell.centre.z()),
                   static_cast<float>(cell.normal.head<2>().norm()), static_cast<float>(cell.normal.z()),
                   static_cast<float>(cell.halfWidth), static_cast<float>(cell.halfHeight),
                   static_cast<float>(slack)});
}

// delta inside the surface cell implies |a - b| <= (I / h + |K|) half: of the slopes on either side, b +- half / h are
// those by which the source sees the surface cell, and a +- |K| half those of the ranging rays.
void ObservationRays::addFanRanges() {
  const ScannerImages::Data& data = scanner_.data();
  order_.resize(data.cells.size());
  std::iota(order_.begin(), order_.end(), 0U);
  for (std::size_t stored = 0; stored + 1 < data.surfaceStart.size(); ++stored) {
    const Row& row = rows_[stored / columnsPerPeriod_];
    const auto begin = order_.begin() + data.surfaceStart[stored];
    const auto end = order_.begin() + data.surfaceStart[stored + 1];
    std::stable_sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
      return stepOf(data.cells[a].slope[1], kStepsUp) < stepOf(data.cells[b].slope[1], kStepsUp);
    });
    for (auto k = begin; k != end; ++k) {
      const OccupiedCell& cell = data.cells[*k];
      const float across = std::abs(cell.fan[0]) * row.halfWidth + std::abs(cell.fan[1]) * row.halfHeight;
      const float up = std::abs(cell.fan[2]) * row.halfWidth + std::abs(cell.fan[3]) * row.halfHeight;
      fans_.push_back({{cell.slope[0] - across, cell.slope[0] + across}, {cell.slope[1] - up, cell.slope[1] + up}});
    }
  }
}

void ObservationRays::addSlopeRanges() {
  const ScannerImages::Data& data = scanner_.data();
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    SlopeRange whole{kAnySlope, -kAnySlope};
    for (std::size_t column = 0; column < columns_; ++column) {
      const std::size_t stored = r * columnsPerPeriod_ + column % columnsPerPeriod_;
      SlopeRange range{kAnySlope, -kAnySlope};
      for (std::uint32_t k = data.surfaceStart[stored]; k < data.surfaceStart[stored + 1]; ++k) {
        range.low = std::min(range.low, fans_[k].up.low);
        range.high = std::max(range.high, fans_[k].up.high);
      }
      low_.push_back(range.low);
      high_.push_back(range.high);
      whole.low = std::min(whole.low, range.low);
      whole.high = std::max(whole.high, range.high);
    }
    rowRange_.push_back(whole);
  }
}

void ObservationRays::addLookup() {
  const ScannerImages::Data& data = scanner_.data();
  for (std::size_t stored = 0; stored + 1 < data.surfaceStart.size(); ++stored) {
    const std::uint32_t begin = data.surfaceStart[stored];
    const std::uint32_t end = data.surfaceStart[stored + 1];
    Lookup lookup{0, -1, 0.0F, static_cast<std::uint32_t>(lookup_.size())};
    if (begin < end) {
      lookup.firstUp = stepOf(data.cells[order_[begin]].slope[1], kStepsUp);
      lookup.lastUp = stepOf(data.cells[order_[end - 1]].slope[1], kStepsUp);
    }
    std::uint32_t first = begin;
    for (int up = lookup.firstUp; up <= lookup.lastUp; ++up) {
      std::uint32_t last = first;
      while (last < end && stepOf(data.cells[order_[last]].slope[1], kStepsUp) == up) ++last;
      addSteps(first, last);
      first = last;
    }
    for (std::uint32_t k = begin; k < end; ++k)
      lookup.margin = std::max(lookup.margin, 0.5F * (fans_[k].up.high - fans_[k].up.low));
    lookups_.push_back(lookup);
  }
}

// For each step across, the smallest range of [first, last) with all cells whose fan reaches into it.
void ObservationRays::addSteps(std::uint32_t first, std::uint32_t last) {
  const std::size_t start = lookup_.size();
  lookup_.resize(start + kStepsAcross, {last, first});
  for (std::uint32_t k = first; k < last; ++k) {
    for (int step = stepOf(fans_[k].across.low, kStepsAcross); step <= stepOf(fans_[k].across.high, kStepsAcross); ++step) {
      auto& range = lookup_[start + static_cast<std::size_t>(step)];
      range[0] = std::min(range[0], k);
      range[1] = std::max(range[1], k + 1);
    }
  }
  // A range that begins in one step and ends in a later one must not be empty because its ends are.
  for (std::size_t step = 1; step < kStepsAcross; ++step)
    lookup_[start + step][1] = std::max(lookup_[start + step][1], lookup_[start + step - 1][1]);
  for (std::size_t step = kStepsAcross - 1; step-- > 0;)
    lookup_[start + step][0] = std::min(lookup_[start + step][0], lookup_[start + step + 1][0]);
}

// Whether any cell of a row can be a candidate.
bool ObservationRays::reaches(const View& view, std::size_t r, Purpose purpose) const {
  const Row& row = rows_[r];
  const float rise = row.z - view.pz;
  const float front = row.axial * view.normalAxial - view.inward + rise * view.nz +
                      (purpose == Purpose::Middles ? 0.0F : row.slack);
  const float beside = row.axial - view.axial;
  if (front <= 0.0F || front * front < minCosine_ * minCosine_ * (beside * beside + rise * rise)) return false;
  if (purpose != Purpose::Pruned) return true;
  const float ahead = row.normalAxial * row.axial + row.normalZ * rise;
  const float nearest = std::max(ahead - row.normalAxial * view.axial, 0.0F);
  const float farthest = ahead + row.normalAxial * view.axial;
  const float up = row.normalAxial * rise - row.normalZ * row.axial;
  const float swing = std::abs(row.normalZ) * view.axial;
  const SlopeRange& range = rowRange_[r];
  return up - swing <= std::max(nearest * range.high, farthest * range.high) + row.halfHeight &&
         up + swing >= std::min(nearest * range.low, farthest * range.low) - row.halfHeight;
}

// Calls visit(row, column) for the surface cells with f + slack >= cos(breakdown) |d|, d from the source to the middle
// of the cell, f = d . normal; when pruning, only for those where an occupied cell has a slope[1] to match.
template <typename Visit>
void ObservationRays::forCandidates(const View& view, Purpose purpose, const Visit& visit) const {
  std::array<std::int32_t, PositionalSpaceGrid::kMostColumns> keep;
  const auto all = static_cast<std::int32_t>(purpose != Purpose::Pruned);
  const float limit = minCosine_ * minCosine_;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (!reaches(view, r, purpose)) continue;
    const Row& row = rows_[r];
    const float rise = row.z - view.pz;
    const float front = rise * view.nz - view.inward + (purpose == Purpose::Middles ? 0.0F : row.slack);
    const float square = row.axial * row.axial + view.axial * view.axial + rise * rise;
    const float ahead = row.normalAxial * row.axial + row.normalZ * rise;
    const float up = row.normalAxial * rise - row.normalZ * row.axial;
    const float* low = &low_[r * columns_];
    const float* high = &high_[r * columns_];
    for (std::size_t j = 0; j < columns_; ++j) {
      const float f = front + row.axial * view.normalAlong[j];
      const float l2 = square - 2.0F * row.axial * view.along[j];
      const float h = ahead - row.normalAxial * view.along[j];
      const float v = up + row.normalZ * view.along[j];
      const auto matches = static_cast<std::int32_t>(v <= h * high[j] + row.halfHeight) &
                           static_cast<std::int32_t>(v >= h * low[j] - row.halfHeight);
      keep[j] = static_cast<std::int32_t>(f > 0.0F) & static_cast<std::int32_t>(f * f >= limit * l2) &
                static_cast<std::int32_t>(h > kLeastDistance) & (all | matches);
    }
    for (std::size_t j = 0; j < columns_; ++j)
      if (keep[j] != 0) visit(r, j);
  }
}

ObservationRays::Candidate ObservationRays::candidate(const View& view, std::size_t r, std::size_t column) const {
  const Row& row = rows_[r];
  const float rise = row.z - view.pz;
  const float beyond = row.axial - view.along[column];
  return {r, column, row.normalAxial * beyond + row.normalZ * rise, -view.aside[column],
          row.normalAxial * rise - row.normalZ * beyond};
}

// The occupied cells that the source meets in a surface cell.
void ObservationRays::match(const Candidate& c, std::vector<Match>& matches) const {
  const Row& row = rows_[c.row];
  const std::size_t stored = c.row * columnsPerPeriod_ + c.column % columnsPerPeriod_;
  const float inverse = 1.0F / c.ahead;
  const float across = c.across * inverse;
  const float up = c.up * inverse;
  const FanRange seen{{across - row.halfWidth * inverse, across + row.halfWidth * inverse},
                      {up - row.halfHeight * inverse, up + row.halfHeight * inverse}};
  const Lookup& lookup = lookups_[stored];
  const int firstAcross = stepOf(seen.across.low, kStepsAcross);
  const int lastAcross = stepOf(seen.across.high, kStepsAcross);
  int firstUp = lookup.firstUp;
  int lastUp = lookup.lastUp;
  if (firstUp < lastUp) {
    firstUp = std::max(firstUp, stepOf(seen.up.low - lookup.margin, kStepsUp));
    lastUp = std::min(lastUp, stepOf(seen.up.high + lookup.margin, kStepsUp));
  }
  for (int step = firstUp; step <= lastUp; ++step) {
    const auto* ranges = &lookup_[lookup.start + static_cast<std::size_t>((step - lookup.firstUp) * kStepsAcross)];
    const std::uint32_t end = ranges[lastAcross][1];
    for (std::uint32_t k = ranges[firstAcross][0]; k < end; ++k) {
      const FanRange& fan = fans_[k];
      if (fan.across.high >= seen.across.low && fan.across.low <= seen.across.high && fan.up.high >= seen.up.low &&
          fan.up.low <= seen.up.high)
        matchCell(c, order_[k], matches);
    }
  }
}

// Solves delta = (I - h K)^-1 (h a - d): where in the surface cell the ranging ray through the source crosses it.
void ObservationRays::matchCell(const Candidate& c, std::uint32_t number, std::vector<Match>& matches) const {
  const Row& row = rows_[c.row];
  const OccupiedCell& cell = scanner_.data().cells[number];
  const float h = c.ahead;
  const float a = 1.0F - h * cell.fan[0];
  const float d = 1.0F - h * cell.fan[3];
  const float b = h * cell.fan[1];
  const float e = h * cell.fan[2];
  const float offAcross = h * cell.slope[0] - c.across;
  const float offUp = h * cell.slope[1] - c.up;
  const float determinant = a * d - b * e;
  const float across = d * offAcross + b * offUp;
  const float up = e * offAcross + a * offUp;
  const float size = std::abs(determinant);
  if (std::abs(across) > row.halfWidth * size || std::abs(up) > row.halfHeight * size) return;
  const float distance = std::sqrt(h * h + c.across * c.across + c.up * c.up) + cell.sourceDistance;
  if (distance < minRange_ || distance > maxRange_) return;
  const float inverse = 1.0F / determinant;
  const float shareAcross = offAcross / row.halfWidth;
  const float shareUp = offUp / row.halfHeight;
  matches.push_back({number, across * inverse, up * inverse, shareAcross * shareAcross + shareUp * shareUp,
                     cell.receiverSide});
}

// One observation ray for matches with receivers on one side, aimed to be collinear with the nearest of them.
void ObservationRays::emit(const View& view, const Candidate& c, std::uint32_t source,
                           std::span<const Match> matches, ObservationBatch& batch) const {
  const auto nearest = std::min_element(matches.begin(), matches.end(),
                                        [](const Match& a, const Match& b) { return a.off < b.off; });
  const float shiftAcross = matches.empty() ? 0.0F : nearest->across;
  const float shiftUp = matches.empty() ? 0.0F : nearest->up;
  const Row& row = rows_[c.row];
  const float cosine = cosine_[c.column];
  const float sine = sine_[c.column];
  const float axial = row.axial - shiftUp * row.normalZ;
  const float x = axial * cosine - shiftAcross * sine;
  const float y = axial * sine + shiftAcross * cosine;
  const float z = row.z + shiftUp * row.normalAxial;

  const float dx = x - view.px;
  const float dy = y - view.py;
  const float dz = z - view.pz;
  const float front = dx * view.nx + dy * view.ny + dz * view.nz;
  const float length = std::sqrt(dx * dx + dy * dy + dz * dz);
  if (front <= 0.0F || front < minCosine_ * length) return;

  Observation observation;
  observation.source = source;
  observation.firstCell = static_cast<std::uint32_t>(batch.cells.size());
  observation.cellCount = static_cast<std::uint32_t>(matches.size());
  observation.confidence = std::min(front / length, 1.0F);
  const auto shift = static_cast<std::uint32_t>(c.column / columnsPerPeriod_ * scanner_.data().cells.size());
  for (const Match& m : matches) batch.cells.push_back(m.cell + shift);
  if (!matches.empty()) observation.nearest = nearest->cell + shift;
  batch.observations.push_back(observation);
  batch.rays.push_back({view.ox, view.oy, view.oz, 0.0F, x - view.ox, y - view.oy, z - view.oz, 0.0F, 1.0F});
}

void ObservationRays::append(const ObservationSource& source, std::uint32_t index, ObservationBatch& batch) const {
  const View view(source, options_.surfaceOffset, *this);
  std::vector<Match> matches;
  forCandidates(view, options_.prune ? Purpose::Pruned : Purpose::All, [&](std::size_t row, std::size_t column) {
    const Candidate c = candidate(view, row, column);
    matches.clear();
    match(c, matches);
    if (matches.empty()) {
      if (!options_.prune) emit(view, c, index, {}, batch);
      return;
    }
    const auto bySide = [](const Match& a, const Match& b) { return a.side < b.side; };
    if (!std::is_sorted(matches.begin(), matches.end(), bySide))
      std::stable_sort(matches.begin(), matches.end(), bySide);
    for (auto first = matches.begin(); first != matches.end();) {
      const auto last = std::find_if(first, matches.end(), [&](const Match& m) { return m.side != first->side; });
      emit(view, c, index, {first, last}, batch);
      first = last;
    }
  });
}

std::vector<std::uint32_t> ObservationRays::candidates(const ObservationSource& source) const {
  const View view(source, options_.surfaceOffset, *this);
  std::vector<std::uint32_t> cells;
  forCandidates(view, Purpose::Middles, [&](std::size_t row, std::size_t column) {
    cells.push_back(static_cast<std::uint32_t>(row * columns_ + column));
  });
  return cells;
}

}  // namespace vantage
