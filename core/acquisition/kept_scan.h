#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "acquisition/phase_times.h"
#include "planning/plan.h"
#include "registration/icp.h"
#include "registration/view_network.h"
#include "scanner/scan_reading.h"
#include "scanner/scan_use.h"
#include "scanner/triangulation.h"

namespace vantage {

/// What became of a scan.
enum class ScanStatus : std::uint8_t {
  In,        ///< a view of the model
  Rejected,  ///< it did not find its place
  LeftOut,   ///< a view that the operator took out of the model
  Waiting,   ///< of a stand that is not worked on: nothing was made of it yet
  Aside,     ///< a view of another composite than the one in work
};
inline constexpr ScanStatus kLastScanStatus = ScanStatus::Aside;
/// "in", "rejected", "left_out", "waiting", "aside".
[[nodiscard]] std::string_view name(ScanStatus status);

/// What one scan brought.
struct ScanRecord {
  std::size_t samples = 0;                 ///< of the scan as it came, that were not cut
  int everyNth = 1;                        ///< row and column of it is worked on
  CutCounts cut{};                         ///< why rays give none; all 0 where nothing is ever cut
  std::size_t triangles = 0;               ///< of the scan's own mesh
  std::optional<PositionScore> predicted;  ///< by the plan that chose it
  std::optional<ScanReading> reading;      ///< of a recorded scan: as what its file was read
  RegistrationResult registration;         ///< against the model before it; of the first view trivially good
  double newArea = 0.0;                    ///< what the model's area grew by [mm^2]
  double overlapArea = 0.0;                ///< of the scan's area what the model had already [mm^2]
  std::shared_ptr<const Plan> planAfter;   ///< made when it was added; null for baselines and scans that are no views
  PhaseTimes seconds;                      ///< for the report only
};

/// A scan of the session with what is known of it.
struct KeptScan {
  std::int64_t number = 0;  ///< in its session: commands name a scan by it
  ScanStatus status = ScanStatus::In;
  /// The image without what was cut and thinned out and, for views, those aside and what was left out, its mesh and its
  /// place. Of other scans the mesh is null and the place what was expected. The journal has the image as it came.
  View view;
  ScanRecord record;
  /// The view as registration works with it; nothing before that was needed, see `prepareScans`.
  std::optional<PreparedView> prepared = {};

  [[nodiscard]] const Station& station() const { return view.image->station; }
};

/// A scan with its number in the session.
struct NumberedScan {
  std::int64_t number = 0;
  std::shared_ptr<const RangeImage> image;
};

/// What the rays of a further scan may be shared with; null without scans.
[[nodiscard]] std::shared_ptr<const RayGrid> raysOfLast(const std::vector<KeptScan>& scans);

/// A scan that is about to become a view: cut, thinned and triangulated, where it was reached.
/// @param like rays that are shared where they are the same; may be null
/// @throws InvalidInput for a range image that is not one; Cancelled
[[nodiscard]] KeptScan keepAsView(const NumberedScan& scan, const ScanUse& use,
                                  const TriangulationOptions& triangulation,
                                  const std::shared_ptr<const RayGrid>& like = nullptr, const Progress& progress = {});

}  // namespace vantage
