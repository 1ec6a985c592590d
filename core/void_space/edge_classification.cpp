#include "void_space/edge_classification.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

// A ray that samples nothing but the flat continuation still frees an interval of this half width [rad].
constexpr double kLeastBreakdownAngle = 1e-3;

}  // namespace

EdgeClassifier::EdgeClassifier(const RayCaster& model, const RayIndex& rays, const ClassificationOptions& options)
    : model_(model), rays_(rays), options_(options) {}

EdgeVerdict EdgeClassifier::classify(const EdgeFrame& e, const RayPassage& r, bool sampledEdge) const {
  const double rho = e.angleOf(-r.line.direction);
  const Vec3 step = r.spacing * e.direction(rho + 0.5 * kPi);
  const auto neighbour = rays_.through(r.view, e.middle + step, r.position);
  if (!neighbour) return {EdgeClass::Rim, rho, samplingRim(rho, sampledEdge)};

  const Meeting met = follow(*neighbour);
  switch (met.beside) {
    case Beside::Nearer:
      return {EdgeClass::InnerJump, rho, innerJump(rho)};
    case Beside::Farther:
      return {EdgeClass::OuterJump, rho, outerJump(rho)};
    case Beside::GoesOn: {
      // In the plane of the frame the surface is met at right angles to r, one spacing on, and `depth` behind e.
      const double kappa = rho + 0.5 * kPi + std::atan2(met.depth * e.across(r.line.direction), r.spacing);
      return {EdgeClass::Regular, rho, surfaceGoesOn(kappa)};
    }
    case Beside::Nothing:
      break;
  }
  const std::vector<Vec3> receivers = rays_.receivers(r);
  const EdgeClass cause = shadow(e, *neighbour, step, receivers);
  if (cause == EdgeClass::InnerJump) return {cause, rho, innerJump(rho)};
  if (cause == EdgeClass::LineOfSightJump) {
    // What lay between ray and triangle would have hidden e_T, however the line of sight runs.
    const double lambda = lineOfSightAngle(e, r, receivers);
    return {cause, rho, lineOfSightJump(sampledEdge ? std::max(rho, lambda) : lambda)};
  }
  return {EdgeClass::Regular, rho, regular(rho, breakdownAbout(e, r, sampledEdge), sampledEdge)};
}

// Why nothing was sampled beside e: the light (InnerJump) or the line of sight is blocked there, or neither (Regular).
EdgeClass EdgeClassifier::shadow(const EdgeFrame& e, RayPassage neighbour, const Vec3& step,
                                 const std::vector<Vec3>& receivers) const {
  for (int k = 1;; ++k) {
    const Vec3 place = e.middle + k * step;
    if (!seenByReceiver(place, receivers, neighbour.spacing)) return EdgeClass::LineOfSightJump;
    if (k >= options_.shadowReach) return EdgeClass::Regular;
    const auto next = rays_.through(neighbour.view, place + step, neighbour.position);
    if (!next) return EdgeClass::Regular;
    neighbour = *next;
    if (neighbour.sampleDepth)
      return compare(*neighbour.sampleDepth - neighbour.depth, neighbour) == Beside::Nearer ? EdgeClass::InnerJump
                                                                                            : EdgeClass::Regular;
  }
}

EdgeClassifier::Beside EdgeClassifier::compare(double depth, const RayPassage& neighbour) const {
  const double jump = options_.jumpFactor * std::tan(options_.breakdownAngle) * neighbour.spacing;
  if (depth < -jump) return Beside::Nearer;
  return depth > jump ? Beside::Farther : Beside::GoesOn;
}

EdgeClassifier::Meeting EdgeClassifier::follow(const RayPassage& neighbour) const {
  if (neighbour.sampleDepth) {
    const double depth = *neighbour.sampleDepth - neighbour.depth;
    return {compare(depth, neighbour), depth};
  }
  const auto hit = model_.intersect(neighbour.line.origin, neighbour.line.direction);
  if (!hit) return {};
  const double depth = hit->distance - neighbour.depth;
  const Beside beside = compare(depth, neighbour);
  if (beside == Beside::Nearer) return {beside, depth};
  // The back of the model says that the ray runs through the unseen.
  if (hit->normal.dot(neighbour.line.direction) >= 0.0) return {};
  if (beside == Beside::GoesOn) return {beside, depth};
  const std::vector<double> measuredDepths = rays_.depthsAround(neighbour);
  const bool sampledThere = std::any_of(measuredDepths.begin(), measuredDepths.end(), [&](double d) {
    return compare(d - hit->distance, neighbour) == Beside::GoesOn;
  });
  return sampledThere ? Meeting{beside, depth} : Meeting{};
}

bool EdgeClassifier::measured(const EdgeFrame& e, const RayPassage& r) const {
  return r.sampleDepth && r.line.direction.dot(e.n) < 0.0 && compare(*r.sampleDepth - r.depth, r) == Beside::GoesOn;
}

bool EdgeClassifier::sees(const EdgeFrame& e, const RayPassage& r) const {
  if (e.across(r.line.direction) < std::cos(options_.breakdownAngle)) return false;
  if (r.sampleDepth && compare(*r.sampleDepth - r.depth, r) == Beside::Nearer) return false;
  const std::vector<Vec3> receivers = rays_.receivers(r);
  return visible(e.from(), r, receivers) || visible(e.to(), r, receivers);
}

bool EdgeClassifier::visible(const Vec3& p, const RayPassage& r, const std::vector<Vec3>& receivers) const {
  // The rays through the middle and the ends of an edge are parallel for all purposes.
  const Vec3 source = p - r.depth * r.line.direction;
  return !model_.occluded(p, source, r.spacing) && seenByReceiver(p, receivers, r.spacing);
}

bool EdgeClassifier::seenByReceiver(const Vec3& p, const std::vector<Vec3>& receivers, double margin) const {
  return receivers.empty() || std::any_of(receivers.begin(), receivers.end(),
                                          [&](const Vec3& at) { return !model_.occluded(p, at, margin); });
}

// The smallest angle of the lines of sight that are free at e, the tightest bound; without any, the ray's own.
double EdgeClassifier::lineOfSightAngle(const EdgeFrame& e, const RayPassage& r,
                                        const std::vector<Vec3>& receivers) const {
  double lambda = 2.0 * kPi;
  for (const Vec3& at : receivers)
    if (seenByReceiver(e.middle, {at}, r.spacing)) lambda = std::min(lambda, e.angleOf(at - e.middle));
  return lambda < 2.0 * kPi ? lambda : e.angleOf(-r.line.direction);
}

// theta_b as it appears in the plane across e. A surface through e at angle a has the normal a - pi/2 in that plane, so
// its angle to r, of which only the share s lies in the plane, has the cosine s * cos(a - pi/2 - rho); r samples it iff
// |a - pi/2 - rho| <= acos(cos(theta_b) / s). A ray that sampled e_T would have sampled its flat continuation as well,
// even where noise has tilted e_T beyond theta_b.
double EdgeClassifier::breakdownAbout(const EdgeFrame& e, const RayPassage& r, bool sampledEdge) const {
  double cosine = std::cos(options_.breakdownAngle);
  if (sampledEdge) cosine = std::min(cosine, -r.line.direction.dot(e.n));
  const double inPlane = std::acos(std::clamp(cosine / e.across(r.line.direction), 0.0, 1.0));
  return std::max(inPlane, kLeastBreakdownAngle);
}

}  // namespace vantage
