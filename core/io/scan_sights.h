#pragma once

#include <vector>

#include "io/scan_evidence.h"
#include "io/scan_reader.h"

namespace vantage {

/// Decides for every scan where its scanner looks (sightKind, sight, sightKnownBy and placed of its reading): what an
/// operator says, what the file says, a grid around an axis, lines of sight that spread, and where the surface of all
/// scans lies. Where none of that tells, a scanner looks along -z if its lines of sight are about along z. Poses of
/// scans that are in the object's coordinates already become the identity.
/// @throws InvalidInput naming the file and the option --frame where it cannot be told
void decideSights(std::vector<RawScan>& scans, const ScanReadingOptions& options);

}  // namespace vantage
