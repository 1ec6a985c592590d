#include "composites/ray_witness.h"

#include <algorithm>
#include <cmath>

#include "composites/two_sided_fit.h"

namespace vantage {
namespace {

// Surface that turns away from a ray by more may be missed by it.
const double kFacing = std::cos(radians(41.0));
// What may lie in the way of a ray begins so far from where it should have measured [conflict distances].
constexpr double kInTheWay = 1.5;
// Surface that faces the same way does so within this.
const double kSameWay = std::cos(radians(50.0));

}  // namespace

RayWitness::RayWitness(const CompositeModel& from, const CompositeModel& on, const Pose& T_on_from,
                       const AlignmentLimits& limits)
    : from_(from), on_(on), T_on_from_(T_on_from), T_from_on_(T_on_from.inverse()), near_(limits.conflict()) {
  for (const View& view : on.composite().views) T_scanner_on_.push_back(view.T_object_scanner.inverse());
  places_.resize(T_scanner_on_.size());
}

PlaceWord RayWitness::ask(std::uint32_t point) {
  const Vec3 p = T_on_from_ * from_.surface().point(point);
  if (isBelowTable(on_.composite(), p, near_)) return PlaceWord::Table;
  if (const auto near = nearestOnSurface(p); near && (on_.surface().point(*near) - p).squaredNorm() < near_ * near_)
    return PlaceWord::OnIt;
  bool missing = false;
  for (std::size_t v = 0; v < places_.size(); ++v) {
    const Word word = wordOf(v, p);
    if (word == Word::Passed) return PlaceWord::Conflict;
    if (word == Word::Empty && !missing) missing = isExpected(v, point, p);
  }
  return missing ? PlaceWord::Missing : PlaceWord::Nothing;
}

bool RayWitness::agrees(std::uint32_t point, double distance) const {
  const Vec3 p = T_on_from_ * from_.surface().point(point);
  const auto near = nearestOnSurface(p);
  if (!near) return false;
  const Vec3& normal = on_.surface().normal(*near);
  const Vec3 offset = p - on_.surface().point(*near);
  return std::abs(normal.dot(offset)) <= distance && offset.norm() <= near_ + distance &&
         normal.dot(T_on_from_.linear() * from_.surface().normal(point)) >= kSameWay;
}

std::optional<std::uint32_t> RayWitness::nearestOnSurface(const Vec3& p) const {
  const auto start = on_.field().nearest(p);
  if (!start) return std::nullopt;
  return on_.surface().walkTo(p, *start);
}

// Of the ray through p and its eight neighbours.
RayWitness::Word RayWitness::wordOf(std::size_t v, const Vec3& p) {
  const RangeImage& image = *on_.composite().views[v].image;
  const RayGrid& rays = *image.rays;
  const Vec3 q = T_scanner_on_[v] * p;
  std::optional<GridPosition>& place = places_[v];
  place = place ? rays.locate(q, *place) : rays.locate(q);
  if (!place) return Word::Nothing;
  const int row = static_cast<int>(std::lround(place->row));
  const int column = static_cast<int>(std::lround(place->column));
  if (row < 1 || column < 1 || row >= rays.rows() - 1 || column >= rays.columns() - 1) return Word::Nothing;
  int passed = 0;
  int empty = 0;
  for (int r = row - 1; r <= row + 1; ++r) {
    for (int c = column - 1; c <= column + 1; ++c) {
      const std::size_t i = rays.index(r, c);
      if (!image.valid(i)) {
        ++empty;
      } else if (image.range[i] > rays.ray(i).direction.dot(q - rays.ray(i).origin) + near_) {
        ++passed;
      } else {
        return Word::Nothing;
      }
    }
  }
  return passed == 9 ? Word::Passed : empty == 9 ? Word::Empty : Word::Nothing;
}

// Whether the scanner faces the surface at p, and neither composite hides it from ray and receiver.
bool RayWitness::isExpected(std::size_t v, std::uint32_t point, const Vec3& p) const {
  const View& view = on_.composite().views[v];
  const RayGrid& rays = *view.image->rays;
  const std::size_t ray = rays.nearest(*places_[v]);
  const Vec3 normal = T_on_from_.linear() * from_.surface().normal(point);
  if (normal.dot(view.T_object_scanner.linear() * rays.ray(ray).direction) > -kFacing) return false;
  // The table, and what was cut off just above it, says nothing.
  if (isBelowTable(on_.composite(), p, -2.0 * near_)) return false;
  if (!sees(view.T_object_scanner * rays.ray(ray).origin, p)) return false;
  const auto receivers = rays.receivers(ray);
  return receivers.empty() || std::any_of(receivers.begin(), receivers.end(), [&](const Vec3& receiver) {
           return sees(view.T_object_scanner * receiver, p);
         });
}

bool RayWitness::sees(const Vec3& eye, const Vec3& p) const {
  const double margin = kInTheWay * near_;
  return !on_.caster().occluded(eye, p, margin) && !from_.caster().occluded(T_from_on_ * eye, T_from_on_ * p, margin);
}

}  // namespace vantage
