#pragma once

#include "geometry/vectors.h"

namespace vantage {

struct ZipperOptions {
  /// Two surfaces that face the same way and are no farther apart than this are one [mm]; or than
  double surfaceTolerance = 1.0;
  /// this many sample spacings of the new view, whichever is more.
  double spacingTolerance = 1.0;
  /// Two surfaces face the same way when their normals enclose no more than this [rad].
  double normalTolerance = radians(72.0);
  /// Surface that leans farther than this from the new view's rays is not compared with it [rad].
  double steepest = radians(85.0);
  /// By how much the new view's confidence must exceed the model's for its surface to replace the model's.
  double confidenceMargin = 0.1;
  /// Samples of the new view nearer than this to the model's border are left out of the seam [grid cells].
  double clearance = 0.35;
  /// As in TriangulationOptions: a seam edge longer than this many sample spacings divided by the cosine of the
  /// breakdown angle is a gap, not surface.
  double discontinuityFactor = 1.4;
  double breakdownAngle = radians(60.0);
  /// Edges at the seam shorter than this many sample spacings are collapsed.
  double shortestEdge = 0.3;
  /// Holes with no more edges than this are closed where the views have seen surface,
  int maxHoleEdges = 16;
  /// if that takes no edge longer than this many sample spacings.
  double maxHoleChord = 2.5;
  /// Pieces of fewer triangles are dropped: six are one sample with all its neighbours.
  int minIslandTriangles = 6;
  /// No more views come: the model is mended once all are in it, see `mend`.
  bool mend = false;
};

}  // namespace vantage
