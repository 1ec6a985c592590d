#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// What is known of a direction about an edge. In order of knowledge: the lower value wins a merge.
enum class Space : std::uint8_t { Free, ConditionallyFree, Unknown };

/// A range of angles about an edge [rad].
struct SpaceInterval {
  double begin = 0.0;
  double end = 0.0;
  Space space = Space::Unknown;

  [[nodiscard]] double width() const { return end - begin; }
  bool operator==(const SpaceInterval&) const = default;
};

/// theta_v, and whether it rests on a wedge that was taken for free.
struct VoidAngle {
  double angle = 0.0;  ///< [rad] in [0, 2 pi]
  bool bridged = false;
};

/// The free space about a boundary edge: a partition of [0, 2 pi) into free, conditionally free and unknown directions,
/// counted from the edge's own triangle over its outer side (Pito 1999, 4.3.1, Fig. 9). Exact interval sets; an end
/// that two intervals share belongs to the one of which more is known. A value.
class FreeSpaceMap {
 public:
  /// All unknown.
  FreeSpaceMap();

  /// @param intervals ascending and disjoint, begin <= end; clipped to [0, 2 pi); what they leave out is unknown.
  /// @param thinWedge widest gap that voidAngle bridges [rad].
  /// @throws InvalidInput when the intervals are not in order or not finite.
  explicit FreeSpaceMap(const std::vector<SpaceInterval>& intervals, double thinWedge = 0.0);

  /// Intervals that cover [0, 2 pi), ascending; neighbours differ in kind.
  [[nodiscard]] const std::vector<SpaceInterval>& intervals() const { return intervals_; }

  /// What is known of one direction. @pre angle in [0, 2 pi)
  [[nodiscard]] Space at(double angle) const;

  /// theta_v: the largest angle such that [0, theta_v] is all free. A gap between two free parts that is no wider than
  /// the thin wedge pi/2 - theta_b of the rays is bridged: read to the letter it would stop theta_v at the ray itself
  /// and turn the patch toward its own triangle.
  [[nodiscard]] VoidAngle voidAngle() const;

  /// The rule of 4.3.2, Fig. 11: OR of the free parts; a conditionally free part with no unknown part before it becomes
  /// free; OR of what stays conditional; the rest is unknown.
  [[nodiscard]] static FreeSpaceMap merged(const FreeSpaceMap& a, const FreeSpaceMap& b);

 private:
  void append(double end, Space space);

  std::vector<SpaceInterval> intervals_;
  double thinWedge_ = 0.0;
};

/// [0, rho + pi] free: the ray passed e and met something farther (Fig. 9b). rho is the angle toward the scanner.
[[nodiscard]] FreeSpaceMap outerJump(double rho);

/// [0, rho] free: something nearer than e keeps the light from what lies beside e (Fig. 10a).
[[nodiscard]] FreeSpaceMap innerJump(double rho);

/// [0, lambda] free: something keeps the receiver from seeing what lies beside e; lambda is the angle toward it (Fig.
/// 10b).
[[nodiscard]] FreeSpaceMap lineOfSightJump(double lambda);

/// Nothing that the ray could have sampled lies beside e (Fig. 10c). A surface attached at angle a faces a - pi/2, so
/// the ray would have sampled it iff |a - pi/2 - rho| <= theta_b: [0, rho] conditionally free, then unknown up to u =
/// rho + pi/2 - theta_b, free up to v = rho + pi/2 + theta_b, unknown beyond.
/// @param sampledEdgeItself the ray sampled e's own triangle: what lay in [0, rho] would have hidden it, so it is free.
[[nodiscard]] FreeSpaceMap regular(double rho, double breakdownAngle, bool sampledEdgeItself);

/// [0, rho] conditionally free (free when the ray sampled e's own triangle), unknown beyond: the ray beside e was never
/// shot.
[[nodiscard]] FreeSpaceMap samplingRim(double rho, bool sampledEdgeItself);

/// [0, kappa] free: the surface goes on beside e, at angle kappa, and was sampled there.
[[nodiscard]] FreeSpaceMap surfaceGoesOn(double kappa);

}  // namespace vantage
