#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "composites/composite_model.h"
#include "registration/pair_finding.h"

namespace vantage {

/// How two composites lie on each other, as points alone tell. Shares are of the points of both, 0..1.
struct FitQuality {
  double overlap = 0.0;   ///< points with a partner: near, on surface that faces the same way
  double rms = 0.0;       ///< of those along the normals [mm]
  double conflict = 0.0;  ///< points in space that the other composite's rays passed through, by its field
  double table = 0.0;     ///< points below the table of the other composite
};

/// Point-to-plane fit of two composites to each other: the points of each look for partners on the other.
class TwoSidedFit {
 public:
  enum class Lookup : std::uint8_t {
    Field,  ///< the point nearest to the middle of a cube: fast, and good to a cube
    Exact,  ///< from there to the nearest point
  };

  /// Keeps referring to both. @param tableDepth surface farther below a table is in conflict with it [mm]
  TwoSidedFit(const CompositeModel& reference, const CompositeModel& moved, PointLevel level, Lookup lookup,
              double tableDepth);

  struct Schedule {
    double firstGate;  ///< largest distance of a pair along the normal, at first [mm]
    double lastGate;   ///< and in the last round [mm]
    int rounds;
  };
  /// Gauss-Newton with Geman-McClure weights, one step per round, the gate falling evenly in its logarithm. Motions
  /// that the pairs leave open are not made.
  [[nodiscard]] Pose run(const Pose& T_reference_moved, const Schedule& schedule) const;

  [[nodiscard]] FitQuality quality(const Pose& T_reference_moved, double gate) const;

  /// All pairs, in coordinates of the reference: of the moved points first.
  [[nodiscard]] std::vector<Pair> pairs(const Pose& T_reference_moved, double gate) const;

 private:
  [[nodiscard]] Pair pairOf(const CompositeModel& on, const Vec3& p, const Vec3& normal, double gate) const;

  const CompositeModel& reference_;
  const CompositeModel& moved_;
  PointLevel level_;
  Lookup lookup_;
  double tableDepth_;
  double aside_;  // how far beside a point its partner may lie [mm]
};

/// Whether a point lies farther below one of a composite's tables than `depth`.
[[nodiscard]] bool isBelowTable(const Composite& composite, const Vec3& p, double depth);

}  // namespace vantage
