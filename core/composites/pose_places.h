#pragma once

#include <vector>

#include "base/progress.h"
#include "composites/ray_witness.h"

namespace vantage {

/// What every vertex of two composites is to the other at a pose: where they lie on each other, and where rays, tables
/// or missing samples speak against it. Vertices are those of the composites' models.
struct PosePlaces {
  std::vector<PlaceWord> reference;  ///< per vertex of the reference
  std::vector<PlaceWord> moved;      ///< per vertex of the moved composite
};

/// As evidenceOf counts them, for all vertices and not for a few thousand of them. OnIt where the surfaces also face
/// the same way within the gate of a fine fit: what is merely near is Nothing, what lies
/// on the other's border counts. Deterministic for any thread count.
/// @throws Cancelled
[[nodiscard]] PosePlaces placesAt(const CompositeModel& reference, const CompositeModel& moved,
                                  const Pose& T_reference_moved, const AlignmentLimits& limits,
                                  const Progress& progress = {});

}  // namespace vantage
