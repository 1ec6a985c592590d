#include "positional_space/observation_rays.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

// [mm] A source nearer than this to the plane of a surface cell sees it edge-on.
constexpr float kLeastDistance = 1e-3F;

}  // namespace

void ObservationBatch::clear() {
  rays.clear();
  observations.clear();
  cells.clear();
}

ObservationRays::ObservationRays(const ScannerImages& scanner, const CellLookup& lookup, double breakdownAngle,
                                 const AccumulationOptions& options)
    : scanner_(scanner),
      lookup_(lookup),
      options_(options),
      minCosine_(static_cast<float>(std::cos(breakdownAngle))),
      together_(static_cast<float>(scanner.data().shape.angularError * scanner.data().shape.angularError)),
      columnsPerPeriod_(static_cast<std::size_t>(scanner.data().shape.columns / scanner.data().periods)) {
  addColumns();
  for (std::size_t row = 0; row < static_cast<std::size_t>(scanner.grid().rows()); ++row) addRow(row);
  rows_.reached.resize(rows_.z.size());
}

void ObservationRays::addColumns() {
  for (int column = 0; column < scanner_.grid().columns(); ++column) {
    const Vec3& across = scanner_.grid().surfaceCell(0, column).across;
    columns_.cosine.push_back(static_cast<float>(across.y()));
    columns_.sine.push_back(static_cast<float>(-across.x()));
    const auto j = static_cast<std::size_t>(column);
    columns_.inPeriod.push_back(static_cast<std::uint32_t>(j % columnsPerPeriod_));
    columns_.firstCell.push_back(static_cast<std::uint32_t>(j / columnsPerPeriod_ * scanner_.data().cells.size()));
  }
  const std::size_t count = columns_.cosine.size();
  for (auto* list : {&columns_.along, &columns_.aside, &columns_.normalAlong, &views_.ahead, &views_.across, &views_.up,
                     &views_.front, &views_.square, &views_.normalAcross, &views_.normalUp, &views_.low, &views_.high,
                     &views_.lowUp, &views_.highUp})
    list->resize(count);
  for (auto* list : {&columns_.keep, &views_.firstStep, &views_.lastStep, &views_.firstStepUp, &views_.lastStepUp})
    list->resize(count);
}

void ObservationRays::addRow(std::size_t row) {
  const SurfaceCell& cell = scanner_.grid().surfaceCell(static_cast<int>(row), 0);
  rows_.axial.push_back(static_cast<float>(cell.centre.head<2>().norm()));
  rows_.z.push_back(static_cast<float>(cell.centre.z()));
  rows_.normalAxial.push_back(static_cast<float>(cell.normal.head<2>().norm()));
  rows_.normalZ.push_back(static_cast<float>(cell.normal.z()));
  rows_.halfWidth.push_back(static_cast<float>(cell.halfWidth));
  rows_.halfHeight.push_back(static_cast<float>(cell.halfHeight));
  rows_.taper.push_back(static_cast<float>(cell.taper));
  rows_.widest.push_back(static_cast<float>(cell.widest()));
  // Aimed elsewhere in the cell, a ray is longer or shorter and ends farther or nearer by at most half a diagonal.
  const double slack = std::hypot(cell.widest(), cell.halfHeight) * (1.0 + static_cast<double>(minCosine_));
  rows_.slack.push_back(static_cast<float>(slack));
  for (std::size_t column = 0; column < columns_.cosine.size(); ++column) {
    const std::size_t stored = row * columnsPerPeriod_ + columns_.inPeriod[column];
    low_.push_back(lookup_.upRange(stored).low);
    high_.push_back(lookup_.upRange(stored).high);
    margin_.push_back(lookup_.margin(stored));
    firstUp_.push_back(lookup_.stepsUp(stored).first);
    lastUp_.push_back(lookup_.stepsUp(stored).last);
  }
  const auto columns = static_cast<std::ptrdiff_t>(columns_.cosine.size());
  rows_.low.push_back(*std::min_element(low_.end() - columns, low_.end()));
  rows_.high.push_back(*std::max_element(high_.end() - columns, high_.end()));
}

void ObservationRays::face(const ObservationSource& source, std::uint32_t index) {
  Source& s = source_;
  const Vec3 origin = source.centre + options_.surfaceOffset * source.normal;
  s = {static_cast<float>(source.centre.x()),
       static_cast<float>(source.centre.y()),
       static_cast<float>(source.centre.z()),
       static_cast<float>(source.normal.x()),
       static_cast<float>(source.normal.y()),
       static_cast<float>(source.normal.z()),
       static_cast<float>(origin.x()),
       static_cast<float>(origin.y()),
       static_cast<float>(origin.z()),
       0.0F,
       0.0F,
       0.0F,
       index};
  s.axial = std::sqrt(s.px * s.px + s.py * s.py);
  s.normalAxial = std::sqrt(s.nx * s.nx + s.ny * s.ny);
  s.inward = s.px * s.nx + s.py * s.ny;
  const float* cosine = columns_.cosine.data();
  const float* sine = columns_.sine.data();
  float* along = columns_.along.data();
  float* aside = columns_.aside.data();
  float* normalAlong = columns_.normalAlong.data();
  const std::size_t count = columns_.cosine.size();
  for (std::size_t j = 0; j < count; ++j) along[j] = s.px * cosine[j] + s.py * sine[j];
  for (std::size_t j = 0; j < count; ++j) aside[j] = s.py * cosine[j] - s.px * sine[j];
  for (std::size_t j = 0; j < count; ++j) normalAlong[j] = s.nx * cosine[j] + s.ny * sine[j];
}

// Marks the rows of which any cell may be a candidate: the best that any of its columns can do is good enough.
void ObservationRays::markRows() {
  const Source& s = source_;
  const float limit = minCosine_ * minCosine_;
  const std::size_t count = rows_.z.size();
  for (std::size_t r = 0; r < count; ++r) {
    const float rise = rows_.z[r] - s.pz;
    const float front = rows_.axial[r] * s.normalAxial - s.inward + rise * s.nz + rows_.slack[r];
    const float beside = rows_.axial[r] - s.axial;
    const float ahead = rows_.normalAxial[r] * rows_.axial[r] + rows_.normalZ[r] * rise;
    const float nearest = std::max(ahead - rows_.normalAxial[r] * s.axial, 0.0F);
    const float farthest = ahead + rows_.normalAxial[r] * s.axial;
    const float up = rows_.normalAxial[r] * rise - rows_.normalZ[r] * rows_.axial[r];
    const float swing = std::abs(rows_.normalZ[r]) * s.axial;
    const float highest = std::max(nearest * rows_.high[r], farthest * rows_.high[r]) + rows_.halfHeight[r];
    const float lowest = std::min(nearest * rows_.low[r], farthest * rows_.low[r]) - rows_.halfHeight[r];
    rows_.reached[r] = static_cast<std::int32_t>(front > 0.0F) &
                       static_cast<std::int32_t>(front * front >= limit * (beside * beside + rise * rise)) &
                       static_cast<std::int32_t>(up - swing <= highest) &
                       static_cast<std::int32_t>(up + swing >= lowest);
  }
}

// Marks the candidates of a row: f + slack >= cos(breakdown) |d|, d from the source to the middle of the cell and
// f = d . normal, where an occupied cell has a slope up to match.
void ObservationRays::markColumns(std::size_t r) {
  const Source& s = source_;
  const float axial = rows_.axial[r];
  const float normalAxial = rows_.normalAxial[r];
  const float normalZ = rows_.normalZ[r];
  const float halfHeight = rows_.halfHeight[r];
  const float rise = rows_.z[r] - s.pz;
  const float front = rise * s.nz - s.inward + rows_.slack[r];
  const float square = axial * axial + s.axial * s.axial + rise * rise;
  const float ahead = normalAxial * axial + normalZ * rise;
  const float up = normalAxial * rise - normalZ * axial;
  const float limit = minCosine_ * minCosine_;
  const std::size_t count = columns_.cosine.size();
  const float* low = &low_[r * count];
  const float* high = &high_[r * count];
  const float* along = columns_.along.data();
  const float* normalAlong = columns_.normalAlong.data();
  std::int32_t* keep = columns_.keep.data();
  for (std::size_t j = 0; j < count; ++j) {
    const float f = front + axial * normalAlong[j];
    const float l2 = square - 2.0F * axial * along[j];
    const float h = ahead - normalAxial * along[j];
    const float v = up + normalZ * along[j];
    keep[j] = static_cast<std::int32_t>(f > 0.0F) & static_cast<std::int32_t>(f * f >= limit * l2) &
              static_cast<std::int32_t>(h > kLeastDistance) & static_cast<std::int32_t>(v <= h * high[j] + halfHeight) &
              static_cast<std::int32_t>(v >= h * low[j] - halfHeight);
  }
}

void ObservationRays::viewRun(std::size_t r, std::size_t begin, std::size_t end) {
  const float rise = rows_.z[r] - source_.pz;
  const float normalAxial = rows_.normalAxial[r];
  const float normalZ = rows_.normalZ[r];
  const float axial = rows_.axial[r];
  const float halfWidth = rows_.widest[r];
  const float halfHeight = rows_.halfHeight[r];
  const float* along = columns_.along.data();
  const float* aside = columns_.aside.data();
  float* ahead = views_.ahead.data();
  float* across = views_.across.data();
  float* up = views_.up.data();
  for (std::size_t j = begin; j < end; ++j) {
    const float beyond = axial - along[j];
    ahead[j] = normalAxial * beyond + normalZ * rise;
    across[j] = -aside[j];
    up[j] = normalAxial * rise - normalZ * beyond;
  }
  float* front = views_.front.data();
  float* square = views_.square.data();
  float* normalAcross = views_.normalAcross.data();
  float* normalUp = views_.normalUp.data();
  const float* normalAlong = columns_.normalAlong.data();
  const float* cosine = columns_.cosine.data();
  const float* sine = columns_.sine.data();
  for (std::size_t j = begin; j < end; ++j) {
    normalAcross[j] = cosine[j] * source_.ny - sine[j] * source_.nx;
    normalUp[j] = normalAxial * source_.nz - normalZ * normalAlong[j];
    const float normalAhead = normalAxial * normalAlong[j] + normalZ * source_.nz;
    front[j] = ahead[j] * normalAhead + across[j] * normalAcross[j] + up[j] * normalUp[j];
    square[j] = ahead[j] * ahead[j] + across[j] * across[j] + up[j] * up[j];
  }
  float* low = views_.low.data();
  float* high = views_.high.data();
  float* lowUp = views_.lowUp.data();
  float* highUp = views_.highUp.data();
  for (std::size_t j = begin; j < end; ++j) {
    const float inverse = 1.0F / ahead[j];
    low[j] = (across[j] - halfWidth) * inverse;
    high[j] = (across[j] + halfWidth) * inverse;
    lowUp[j] = (up[j] - halfHeight) * inverse;
    highUp[j] = (up[j] + halfHeight) * inverse;
  }
  viewSteps(r, begin, end);
}

void ObservationRays::viewSteps(std::size_t row, std::size_t begin, std::size_t end) {
  const float* low = views_.low.data();
  const float* high = views_.high.data();
  const float* lowUp = views_.lowUp.data();
  const float* highUp = views_.highUp.data();
  const float* margin = &margin_[row * columns_.cosine.size()];
  const std::int32_t* firstUp = &firstUp_[row * columns_.cosine.size()];
  const std::int32_t* lastUp = &lastUp_[row * columns_.cosine.size()];
  std::int32_t* firstStep = views_.firstStep.data();
  std::int32_t* lastStep = views_.lastStep.data();
  std::int32_t* firstStepUp = views_.firstStepUp.data();
  std::int32_t* lastStepUp = views_.lastStepUp.data();
  const auto stepAcross = [](float slope) {
    return CellLookup::stepOf(CellLookup::folded(slope), CellLookup::kStepsAcross);
  };
  const auto stepUp = [](float slope, float widened) {
    return CellLookup::stepOf(CellLookup::folded(slope) + widened, CellLookup::kStepsUp);
  };
  for (std::size_t j = begin; j < end; ++j) firstStep[j] = stepAcross(low[j]);
  for (std::size_t j = begin; j < end; ++j) lastStep[j] = stepAcross(high[j]);
  for (std::size_t j = begin; j < end; ++j) firstStepUp[j] = std::max(firstUp[j], stepUp(lowUp[j], -margin[j]));
  for (std::size_t j = begin; j < end; ++j) lastStepUp[j] = std::min(lastUp[j], stepUp(highUp[j], margin[j]));
}

void ObservationRays::appendRun(std::size_t row, std::size_t begin, std::size_t end, ObservationBatch& batch) {
  viewRun(row, begin, end);
  findSeen(row, begin, end);
  aim(row);
  for (std::size_t a = 0; a < aimCount_;) {
    const std::size_t column = aims_[a].column;
    const std::size_t first = a;
    while (a < aimCount_ && aims_[a].column == column) ++a;
    emitAims(row, std::span(aims_).subspan(first, a - first), batch);
  }
}

void ObservationRays::findSeen(std::size_t row, std::size_t begin, std::size_t end) {
  seenCount_ = 0;
  for (std::size_t j = begin; j < end; ++j) {
    if (seen_.size() < seenCount_ + lookup_.room()) seen_.resize(2 * (seenCount_ + lookup_.room()));
    const FanRange slopes{{views_.low[j], views_.high[j]}, {views_.lowUp[j], views_.highUp[j]}};
    seenCount_ += lookup_.findOverlapping(
        row * columnsPerPeriod_ + columns_.inPeriod[j], slopes, {views_.firstStep[j], views_.lastStep[j]},
        {views_.firstStepUp[j], views_.lastStepUp[j]}, static_cast<std::uint32_t>(j), &seen_[seenCount_]);
  }
}

// Solves delta = (I - h K)^-1 (h a - d): where in the surface cell the ranging ray through the source crosses it. Kept
// when that is inside, within the breakdown angle and the source within range.
void ObservationRays::aim(std::size_t row) {
  const float limit = minCosine_ * minCosine_;
  const float halfHeight = rows_.halfHeight[row];
  const float fullWidth = rows_.halfWidth[row];
  const float taper = rows_.taper[row];
  aimCount_ = 0;
  if (aims_.size() <= seenCount_) aims_.resize(2 * seenCount_ + 1);
  for (std::size_t k = 0; k < seenCount_; ++k) {
    const std::size_t j = seen_[k].column;
    const FannedCell& cell = lookup_.cell(seen_[k].place);
    const float h = views_.ahead[j];
    const float u = views_.across[j];
    const float v = views_.up[j];
    const float a = 1.0F - h * cell.fan[0];
    const float d = 1.0F - h * cell.fan[3];
    const float b = h * cell.fan[1];
    const float e = h * cell.fan[2];
    const float offAcross = h * cell.slope[0] - u;
    const float offUp = h * cell.slope[1] - v;
    const float inverse = 1.0F / (a * d - b * e);
    const float across = (d * offAcross + b * offUp) * inverse;
    const float up = (e * offAcross + a * offUp) * inverse;
    const float front = views_.front[j] + across * views_.normalAcross[j] + up * views_.normalUp[j];
    const float square = views_.square[j] + 2.0F * (across * u + up * v) + across * across + up * up;
    const float halfWidth = fullWidth * (1.0F - taper * up);
    const int inside = static_cast<int>(std::abs(up) <= halfHeight) & static_cast<int>(std::abs(across) <= halfWidth) &
                       static_cast<int>(front > 0.0F) & static_cast<int>(front * front >= limit * square) &
                       static_cast<int>(square >= cell.range[0]) & static_cast<int>(square <= cell.range[1]);
    aims_[aimCount_] = {seen_[k].column, cell.number, cell.receiverSide, across, up, front, square};
    aimCount_ += static_cast<std::size_t>(inside);
  }
}

void ObservationRays::emitAims(std::size_t row, std::span<Aim> aims, ObservationBatch& batch) const {
  if (aims.size() == 1) {
    const Aim& aim = aims.front();
    batch.observations.push_back({source_.index, static_cast<std::uint32_t>(batch.cells.size()), 1});
    batch.cells.push_back({aim.cell + columns_.firstCell[aim.column], aim.front, aim.square});
    emitRay(row, aim.column, aim.across, aim.up, batch);
    return;
  }
  while (!aims.empty()) aims = aims.first(emitTogether(row, aims, batch));
}

// Takes out the aim nearest to the middle and all with receivers on its side that are close to it: one observation ray.
// @return how many are left, in front.
std::size_t ObservationRays::emitTogether(std::size_t row, std::span<Aim> aims, ObservationBatch& batch) const {
  const auto off = [](const Aim& a) { return a.across * a.across + a.up * a.up; };
  const auto nearest =
      std::min_element(aims.begin(), aims.end(), [&](const Aim& a, const Aim& b) { return off(a) < off(b); });
  const Aim aim = *nearest;
  const std::uint32_t shift = columns_.firstCell[aim.column];
  const auto first = static_cast<std::uint32_t>(batch.cells.size());
  batch.cells.push_back({aim.cell + shift, aim.front, aim.square});
  const float near = together_ * views_.ahead[aim.column] * views_.ahead[aim.column];
  std::size_t left = 0;
  for (auto other = aims.begin(); other != aims.end(); ++other) {
    if (other == nearest) continue;
    const float across = other->across - aim.across;
    const float up = other->up - aim.up;
    if (other->side != aim.side || across * across + up * up > near)
      aims[left++] = *other;
    else
      batch.cells.push_back({other->cell + shift, other->front, other->square});
  }
  batch.observations.push_back({source_.index, first, static_cast<std::uint32_t>(batch.cells.size()) - first});
  emitRay(row, aim.column, aim.across, aim.up, batch);
  return left;
}

// Appends the ray to a point of a surface cell.
void ObservationRays::emitRay(std::size_t row, std::size_t column, float across, float up,
                              ObservationBatch& batch) const {
  const Source& s = source_;
  const float axial = rows_.axial[row] - up * rows_.normalZ[row];
  const float x = axial * columns_.cosine[column] - across * columns_.sine[column];
  const float y = axial * columns_.sine[column] + across * columns_.cosine[column];
  const float z = rows_.z[row] + up * rows_.normalAxial[row];
  batch.rays.push_back({s.ox, s.oy, s.oz, 0.0F, x - s.ox, y - s.oy, z - s.oz, 0.0F, 1.0F});
}

void ObservationRays::append(const ObservationSource& source, std::uint32_t index, ObservationBatch& batch) {
  face(source, index);
  markRows();
  const std::size_t count = columns_.cosine.size();
  for (std::size_t row = 0; row < rows_.z.size(); ++row) {
    if (rows_.reached[row] == 0) continue;
    markColumns(row);
    for (std::size_t begin = 0; begin < count; ++begin) {
      if (columns_.keep[begin] == 0) continue;
      std::size_t end = begin + 1;
      while (end < count && columns_.keep[end] != 0) ++end;
      appendRun(row, begin, end, batch);
      begin = end;
    }
  }
}

}  // namespace vantage
