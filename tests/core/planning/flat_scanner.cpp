#include "core/planning/flat_scanner.h"

namespace vantage::testing {

ScannerProfile flatScanner() {
  ProfileSource source{"profile.json",
                       R"({
    "name": "test",
    "scanner": { "type": "linear_stripe", "position": [300, 0, 100], "stripe_height_mm": 200, "samples_per_stripe": 101,
      "stripes": 101, "travel_mm": 200, "receivers": [[60, 0, 0]], "breakdown_angle_deg": 60, "range_mm": [100, 400] },
    "workspace": { "type": "turntable", "steps": 4 } })",
                       {}};
  return parseProfile(source);
}

}  // namespace vantage::testing
