#pragma once

#include <span>

#include "registration/pair_finding.h"

namespace vantage {

/// How far pairs lie apart.
struct PairNoise {
  double sigma = 0.0;        ///< robust deviation of the distances [mm]
  double robustScale = 0.0;  ///< of Geman-McClure [mm]: three sigmas, more while poses are still far off
};

/// That of pairs looked up within a gate. Far from the final gate what disagrees with the many still pulls: a small
/// part that is off does not count as noise of the large plate that fits.
[[nodiscard]] PairNoise pairNoise(double sigma, double gate, double finalGate);

/// What pairs say about a small motion x (rotation [rad] about a centre, then translation [mm]) of the view that they
/// were found on: the quadratic sum w (r - J x)^2 / sigma^2 with the pairs' distances r, J = ((p - centre) x n, n) and
/// w = confidence times Geman-McClure, has its minimum where information * x = pull.
///
/// Motions whose information is not clearly more than what the noise of normals pretends are left out of both: a smooth
/// cylinder says nothing about turns around its axis. Clearly is five deviations of that, between 1.25 and 2 times.
struct PairTerm {
  Mat6 information = Mat6::Zero();
  Vec6 pull = Vec6::Zero();
  int leftOut = 0;  ///< number of independent motions that were left out
};

/// @param T_object_view takes the pairs to object coordinates, in which the motion is described
/// @param radius at which rotations are compared with translations [mm]
[[nodiscard]] PairTerm pairTerm(std::span<const Pair> pairs, const Pose& T_object_view, const Vec3& centre,
                                double radius, const PairNoise& noise);

/// Centroid of the believed pairs in object coordinates and their RMS distance from it (at least 1e-6 mm).
struct Extent {
  Vec3 centre = Vec3::Zero();
  double radius = 1e-6;
};
[[nodiscard]] Extent extentOf(std::span<const Pair> pairs, const Pose& T_object_view);

/// Collects believed pairs to ask how firmly they hold.
class PairStability {
 public:
  void add(std::span<const Pair> pairs, const Pose& T_object_view);
  [[nodiscard]] Stability analyse(double noiseSigma) const;

 private:
  std::vector<Vec3> points_;
  std::vector<Vec3> normals_;
  std::vector<double> weights_;
  std::vector<double> normalSigmas_;
};

}  // namespace vantage
