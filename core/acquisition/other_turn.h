#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "acquisition/step_options.h"
#include "base/progress.h"

namespace vantage {

/// The turns of the table all around that a scan fits which does not fit where it was said to be taken: it would be a
/// good view there, and nothing speaks against it. Not asked of a scan by hand that shows next to nothing of the model
/// where it was said to be, and nothing against that.
/// OtherPosition where that is a position of the workspace and no person turned the table, else OtherTurn; more than
/// one that is as good are rivals. Nothing where it fits nowhere, or only where it was said to be.
/// @param scan with its mesh, at the pose where it is expected
/// @pre there is a model, the pose of the scan's stand is known. @throws Cancelled
[[nodiscard]] std::optional<Finding> otherTurnOf(const AcquisitionState& state, const KeptScan& scan,
                                                 const StepOptions& options, const Progress& progress);

/// A turn of the table as it is shown: from 0 to below 360 degrees, where the last half of a tenth is 0.
[[nodiscard]] double inOneTurn(double tableDeg);

/// The turns of the table that a refused scan was found to fit, counter-clockwise seen from above, in one turn [deg].
[[nodiscard]] std::vector<double> turnsThatFit(const AcquisitionState& state, const KeptScan& scan);
[[nodiscard]] bool fitsTurn(const AcquisitionState& state, const KeptScan& scan, double tableDeg);

/// Whether a view was taken elsewhere than its image says: nothing follows from that for others.
[[nodiscard]] bool takenElsewhere(const KeptScan& scan);

/// The position of the workspace nearest to where a view of a stand was taken; nothing where it has none.
/// @pre the state has a profile where the scan has a position
[[nodiscard]] std::optional<int> positionTaken(const AcquisitionState& state, const KeptScan& scan);

/// The pose T_object_scanner of a scan when the table stands at an angle, otherwise as it was said.
/// @pre the pose of the scan's stand is known, the state has a profile
[[nodiscard]] Pose poseAtTurn(const AcquisitionState& state, const KeptScan& scan, double tableDeg);

/// Looks for a refused scan around a turn of the table: it becomes a view, with its place, status and registration.
/// @return whether it fits there; otherwise it is as it was. @throws Cancelled
[[nodiscard]] bool placedAtTurn(const AcquisitionState& state, KeptScan& scan, double tableDeg,
                                const StepOptions& options, const Progress& progress);

}  // namespace vantage
