#pragma once

#include <optional>

#include "acquisition/acquisition_state.h"
#include "scanner/scan_use.h"
#include "void_space/void_patch_builder.h"

namespace vantage {

/// Options of every operation that a step runs.
struct StepOptions {
  std::optional<Mechanics> mechanics;  ///< of the moves between scans; unset: nothing is known of them
  ScanCut cut;
  ThinningOptions thinning;
  TriangulationOptions triangulation;
  IcpOptions registration;
  MultiViewOptions refinement;
  ZipperOptions zipper;
  ConsensusOptions consensus;
  PlannerOptions planner;
};

/// The settings with what follows from a scanner: its breakdown angle, and the errors of its turntable as what is known
/// of a pose. Of a state without a profile those of an import.
[[nodiscard]] StepOptions stepOptionsFor(const ScannerProfile& profile, const AcquisitionSettings& settings);
[[nodiscard]] StepOptions stepOptionsFor(const AcquisitionState& state);

/// Options of an import of recorded scans.
struct ImportOptions {
  ScanCut cut;
  ThinningOptions thinning;
  TriangulationOptions triangulation;
  AlignmentOptions alignment;
  ZipperOptions zipper;
  ConsensusOptions consensus;
  VoidOptions voidSpace;
};

/// The settings with what follows from the scanner. Recorded scans without a profile reach farther round than most
/// scanners do: their breakdown angle is 75 degrees, and the angle slack, unless it is set, 5 degrees.
[[nodiscard]] ImportOptions importOptionsFor(const AcquisitionState& state);

}  // namespace vantage
