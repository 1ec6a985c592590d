#pragma once

#include "acquisition/settings.h"
#include "devices/rig_description.h"
#include "scanner/profile.h"

namespace vantage {

/// Whether scans are taken of a mesh. @throws InvalidInput when sensor and table do not belong together
[[nodiscard]] bool isSimulated(const RigDescription& rig);

/// The profile with its calibration, as the session keeps it. @throws InvalidInput, IoError
[[nodiscard]] ProfileSource profileOf(const RigDescription& rig);

/// The settings to begin with where devices see more than the object: that is cut away, as the file says.
/// @throws InvalidInput for a setting that the file misspells
[[nodiscard]] AcquisitionSettings withCut(AcquisitionSettings settings, const RigFile& file);

}  // namespace vantage
