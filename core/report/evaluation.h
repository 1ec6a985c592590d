#pragma once

#include <cstdint>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "scanner/profile.h"

namespace vantage {

struct EvaluationOptions {
  int samples = 40000;                     ///< points drawn on either surface
  double tolerance = 0.75;                 ///< a point is covered by model surface this near [mm]
  double clearOfBreakdown = radians(2.0);  ///< scannable means this much inside the breakdown angle [rad]
  std::uint64_t seed = 7;
};

/// An acquired model against the object it was scanned from.
struct Evaluation {
  double scannableShare = 0.0;  ///< share of the object's surface that some position can sample, 0..1
  double coverage = 0.0;        ///< share of the scannable surface that the model covers, facing the same way, 0..1
  double wholeCoverage = 0.0;   ///< share of the whole surface that the model covers, also what stands showed, 0..1
  double rms = 0.0;             ///< of the model's distance from the object [mm]
  double percentile99 = 0.0;    ///< [mm]
  double falseSurface = 0.0;    ///< share of the model farther than the tolerance from the object, 0..1
};

/// Measures a model. The acquired frame is free up to the errors of the mechanics, so the model is first fitted rigidly
/// onto the object (point to plane).
/// @throws InvalidInput when either mesh has no triangles. @throws Cancelled
[[nodiscard]] Evaluation evaluate(const Mesh& model, const Mesh& object, const ScannerProfile& profile,
                                  const EvaluationOptions& options, const Progress& progress);

}  // namespace vantage
