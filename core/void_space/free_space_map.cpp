#include "void_space/free_space_map.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kTurn = 2.0 * kPi;
// Rounding of sums of angles [rad].
constexpr double kAngleTolerance = 1e-9;

}  // namespace

FreeSpaceMap::FreeSpaceMap() : intervals_{{0.0, kTurn, Space::Unknown}} {}

FreeSpaceMap::FreeSpaceMap(const std::vector<SpaceInterval>& intervals, double thinWedge) : thinWedge_(thinWedge) {
  double reached = -kTurn;
  for (const SpaceInterval& i : intervals) {
    if (!(std::isfinite(i.begin) && std::isfinite(i.end) && i.begin <= i.end && i.begin >= reached))
      throw InvalidInput("the intervals of a free space map must be finite, ascending and disjoint");
    reached = i.end;
    append(i.begin, Space::Unknown);
    append(i.end, i.space);
  }
  append(kTurn, Space::Unknown);
}

// Extends the map from where it ends, if `end` lies beyond that.
void FreeSpaceMap::append(double end, Space space) {
  const double begin = intervals_.empty() ? 0.0 : intervals_.back().end;
  end = std::min(end, kTurn);
  if (end <= begin) return;
  if (!intervals_.empty() && intervals_.back().space == space)
    intervals_.back().end = end;
  else
    intervals_.push_back({begin, end, space});
}

Space FreeSpaceMap::at(double angle) const {
  Space known = Space::Unknown;
  for (const SpaceInterval& i : intervals_)
    if (i.begin <= angle && angle <= i.end) known = std::min(known, i.space);
  return known;
}

VoidAngle FreeSpaceMap::voidAngle() const {
  if (intervals_.front().space != Space::Free) return {};
  VoidAngle result{intervals_.front().end, false};
  for (std::size_t i = 1; i < intervals_.size(); ++i) {
    const SpaceInterval& part = intervals_[i];
    if (part.space != Space::Free) continue;
    if (part.begin - result.angle > thinWedge_ + kAngleTolerance) break;
    result = {part.end, true};
  }
  return result;
}

FreeSpaceMap FreeSpaceMap::merged(const FreeSpaceMap& a, const FreeSpaceMap& b) {
  FreeSpaceMap result;
  result.intervals_.clear();
  result.thinWedge_ = std::max(a.thinWedge_, b.thinWedge_);
  bool unknownBefore = false;
  auto i = a.intervals_.begin();
  auto j = b.intervals_.begin();
  while (i != a.intervals_.end() && j != b.intervals_.end()) {
    Space space = std::min(i->space, j->space);
    unknownBefore = unknownBefore || space == Space::Unknown;
    if (space == Space::ConditionallyFree && !unknownBefore) space = Space::Free;
    const double end = std::min(i->end, j->end);
    result.append(end, space);
    if (i->end == end) ++i;
    if (j->end == end) ++j;
  }
  return result;
}

FreeSpaceMap outerJump(double rho) {
  return FreeSpaceMap({{0.0, rho + kPi, Space::Free}});
}

FreeSpaceMap innerJump(double rho) {
  return FreeSpaceMap({{0.0, rho, Space::Free}});
}

FreeSpaceMap lineOfSightJump(double lambda) {
  return FreeSpaceMap({{0.0, lambda, Space::Free}});
}

FreeSpaceMap regular(double rho, double breakdownAngle, bool sampledEdgeItself) {
  const double wedge = 0.5 * kPi - breakdownAngle;
  return FreeSpaceMap({{0.0, rho, sampledEdgeItself ? Space::Free : Space::ConditionallyFree},
                       {rho + wedge, rho + 0.5 * kPi + breakdownAngle, Space::Free}},
                      wedge);
}

FreeSpaceMap samplingRim(double rho, bool sampledEdgeItself) {
  return FreeSpaceMap({{0.0, rho, sampledEdgeItself ? Space::Free : Space::ConditionallyFree}});
}

FreeSpaceMap surfaceGoesOn(double kappa) {
  return FreeSpaceMap({{0.0, kappa, Space::Free}});
}

}  // namespace vantage
