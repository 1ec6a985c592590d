#pragma once

#include <cstddef>
#include <optional>

#include "forecast/closing_surface.h"
#include "forecast/forecast_ledger.h"
#include "planning/choice.h"
#include "planning/patch_history.h"
#include "void_space/void_patch_builder.h"

namespace vantage {

struct PlannerOptions {
  /// u: triangles sampled with less confidence attract views that would sample them with at least u (Appendix). 0: off.
  double tolerance = 0.0;
  /// t, least confidence-weighted overlap away from the model's border [mm^2]; unset: `overlapShare` of the model's
  /// area per view taken, but no less than the area of `overlapSamples` samples.
  std::optional<double> leastOverlap;
  double overlapShare = 0.1;
  double overlapSamples = 300.0;
  /// Rings of vertices next to the model's border whose triangles give no pairs, like those of the border itself.
  int borderRings = 2;
  /// How often t may be halved, and with it the pose error doubled, when no position satisfies them.
  int maxRelaxations = 3;
  /// When that does not help either, a view is proposed that the table alone places, if it promises more than this
  /// share of the model's area: the far side of a plate. 1: never.
  double tableAloneShare = 0.01;

  /// The overlap must fix the pose to within this share of the sample spacing.
  double poseSigmaShare = 0.2;
  /// Surface elements that predict a registration; more do not change its weak direction.
  std::size_t overlapElements = 2000;
  /// Pairs of a registration are not independent: neighbouring samples share errors. So many of them count as one.
  double pairsPerObservation = 20.0;
  /// Samples are taken to be no more exact than this, whatever the profile says [sample spacings].
  double leastRangeSigma = 0.05;

  /// Void patches look ahead to the surface behind them. Off: the objective of the paper.
  bool lookAhead = true;
  /// So far ahead an open void patch stands for unseen surface, and patches that face each other across no more than
  /// this bound one hole [sample spacings].
  double lookAheadReach = 3.0;
  double widestHole = 16.0;
  /// Patches face each other when either lies this near to where the other points [rad].
  double facingAngle = radians(60.0);
  /// Nearer to the plane of an opening than this angle from its normal a view hardly looks through it [rad].
  double openingAngle = radians(85.0);

  /// o_v forecasts new surface: what closes the model where nobody has looked is predicted and projected beside the
  /// void patches, corrected by what the forecasts of the run were worth. Off: o_v is void patch area.
  bool forecast = true;
  /// Void patches count beside the predicted surface by so much of their weight: along the border of the model they
  /// rank what the voxels of the prediction are too coarse for.
  double patchShare = 0.3;
  /// F of a forecast is no less than this share of the model's area.
  double forecastShare = 0.0016;
  /// When the last view showed more than F, a forecast of more than this share of F is worth one more: the prediction
  /// may miss what it has never seen. 1: never.
  double probeShare = 0.7;
  ClosingOptions closing;
  LedgerOptions ledger;

  /// Lines of sight and observation rays begin this far in front of the surface [sample spacings] ...
  double surfaceOffset = 0.25;
  /// ... and what blocks lines of sight within this distance of either end does not count [sample spacings].
  double sightMargin = 0.5;
  /// Positions that positional space ranks highest are judged with the scanner's own rays, this many at a time.
  int tracedPositions = 16;
  /// Triangles that stand for the model's surface when it is projected into positional space.
  std::size_t planningTriangles = 30000;
  /// A model of more triangles than this is decimated before rays are traced through it, by no more than the error
  /// [mm].
  std::size_t tracedTriangles = 300000;
  double planningError = 0.1;

  VoidOptions voidSpace;  ///< but for the breakdown angle, which is the scanner's
  PatchHistoryOptions history;
  TerminationOptions termination;
};

}  // namespace vantage
