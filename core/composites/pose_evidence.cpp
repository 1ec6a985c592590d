#include "composites/pose_evidence.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "composites/two_sided_fit.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 512;
// Surface that turns away from a ray by more may be missed by it.
const double kFacing = std::cos(radians(41.0));
// What may lie in the way of a ray begins so far from where it should have measured [conflict distances].
constexpr double kInTheWay = 1.5;

struct Counts {
  std::size_t conflict = 0;
  std::size_t table = 0;
  std::size_t missing = 0;
};

// What one view says about a place.
enum class Word { Nothing, Passed, Empty };

// The points of one composite against the rays of another.
class RayWitness {
 public:
  RayWitness(const CompositeModel& from, const CompositeModel& on, const Pose& T_on_from, const AlignmentLimits& limits)
      : from_(from), on_(on), T_on_from_(T_on_from), T_from_on_(T_on_from.inverse()), near_(limits.conflict()) {
    for (const View& view : on.composite().views) T_scanner_on_.push_back(view.T_object_scanner.inverse());
  }

  [[nodiscard]] Counts ask(std::size_t begin, std::size_t end) const {
    Counts counts;
    std::vector<std::optional<GridPosition>> places(on_.composite().views.size());
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = from_.points(PointLevel::Fine)[k];
      const Vec3 p = T_on_from_ * from_.surface().point(i);
      if (isBelowTable(on_.composite(), p, near_)) {
        ++counts.table;
        continue;
      }
      if (isOnSurface(p)) continue;
      bool passed = false;
      bool missing = false;
      for (std::size_t v = 0; v < places.size() && !passed; ++v) {
        const Word word = wordOf(v, p, places[v]);
        passed = word == Word::Passed;
        if (word == Word::Empty && !missing) missing = isExpected(v, i, p, *places[v]);
      }
      if (passed) ++counts.conflict;
      if (missing && !passed) ++counts.missing;
    }
    return counts;
  }

 private:
  [[nodiscard]] bool isOnSurface(const Vec3& p) const {
    const auto start = on_.field().nearest(p);
    if (!start) return false;
    const std::uint32_t nearest = on_.surface().walkTo(p, *start);
    return (on_.surface().point(nearest) - p).squaredNorm() < near_ * near_;
  }

  // Of the ray through p and its eight neighbours.
  [[nodiscard]] Word wordOf(std::size_t v, const Vec3& p, std::optional<GridPosition>& place) const {
    const RangeImage& image = *on_.composite().views[v].image;
    const RayGrid& rays = *image.rays;
    const Vec3 q = T_scanner_on_[v] * p;
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
  [[nodiscard]] bool isExpected(std::size_t v, std::uint32_t i, const Vec3& p, const GridPosition& place) const {
    const View& view = on_.composite().views[v];
    const RayGrid& rays = *view.image->rays;
    const std::size_t ray = rays.nearest(place);
    const Vec3 normal = T_on_from_.linear() * from_.surface().normal(i);
    if (normal.dot(view.T_object_scanner.linear() * rays.ray(ray).direction) > -kFacing) return false;
    // The table, and what was cut off just above it, says nothing.
    if (isBelowTable(on_.composite(), p, -2.0 * near_)) return false;
    if (!sees(view.T_object_scanner * rays.ray(ray).origin, p)) return false;
    const auto receivers = rays.receivers(ray);
    return receivers.empty() || std::any_of(receivers.begin(), receivers.end(), [&](const Vec3& receiver) {
             return sees(view.T_object_scanner * receiver, p);
           });
  }

  [[nodiscard]] bool sees(const Vec3& eye, const Vec3& p) const {
    const double margin = kInTheWay * near_;
    return !on_.caster().occluded(eye, p, margin) && !from_.caster().occluded(T_from_on_ * eye, T_from_on_ * p, margin);
  }

  const CompositeModel& from_;
  const CompositeModel& on_;
  Pose T_on_from_;
  Pose T_from_on_;
  double near_;
  std::vector<Pose> T_scanner_on_;
};

Counts askAll(const CompositeModel& from, const CompositeModel& on, const Pose& T_on_from,
              const AlignmentLimits& limits, const Progress& progress) {
  const RayWitness witness(from, on, T_on_from, limits);
  const std::size_t count = from.points(PointLevel::Fine).size();
  std::vector<Counts> chunks(count / kGrain + 1);
  parallelChunks(count, kGrain, progress,
                 [&](std::size_t begin, std::size_t end) { chunks[begin / kGrain] = witness.ask(begin, end); });
  Counts all;
  for (const Counts& chunk : chunks) {
    all.conflict += chunk.conflict;
    all.table += chunk.table;
    all.missing += chunk.missing;
  }
  return all;
}

}  // namespace

PoseEvidence evidenceOf(const CompositeModel& reference, const CompositeModel& moved, const Pose& T_reference_moved,
                        const AlignmentLimits& limits, const Progress& progress) {
  const FitQuality fit = TwoSidedFit(reference, moved, PointLevel::Fine, TwoSidedFit::Lookup::Exact, limits.conflict())
                             .quality(T_reference_moved, limits.sampleGate());
  const Counts a = askAll(moved, reference, T_reference_moved, limits, progress.part(0.0, 0.5));
  const Counts b = askAll(reference, moved, T_reference_moved.inverse(), limits, progress.part(0.5, 1.0));
  const auto all =
      static_cast<double>(reference.points(PointLevel::Fine).size() + moved.points(PointLevel::Fine).size());
  PoseEvidence evidence;
  evidence.overlap = fit.overlap;
  evidence.rms = fit.rms;
  evidence.conflict = static_cast<double>(a.conflict + b.conflict) / all;
  evidence.table = static_cast<double>(a.table + b.table) / all;
  evidence.missing = static_cast<double>(a.missing + b.missing) / all;
  return evidence;
}

}  // namespace vantage
