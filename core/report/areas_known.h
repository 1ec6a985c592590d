#pragma once

#include "acquisition/kept_scan.h"

namespace vantage {

/// Whether the areas of a scan were measured. Those of recorded scans that were put together all at once were not.
[[nodiscard]] inline bool areasKnown(const ScanRecord& record) {
  return record.newArea > 0.0 || record.overlapArea > 0.0;
}

}  // namespace vantage
