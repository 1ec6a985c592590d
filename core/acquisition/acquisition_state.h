#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "acquisition/phase_times.h"
#include "acquisition/settings.h"
#include "integration/model.h"
#include "planning/plan.h"
#include "registration/icp.h"
#include "scanner/profile.h"
#include "scanner/view.h"

namespace vantage {

/// What one scan brought.
struct ViewRecord {
  std::int64_t scan = -1;  ///< number of the scan in its session: commands name a view by it
  int position = -1;
  std::size_t samples = 0;
  std::size_t triangles = 0;               ///< of the scan's own mesh
  std::optional<PositionScore> predicted;  ///< by the plan that chose it
  RegistrationResult registration;         ///< against the model before it; of the first view trivially good
  double newArea = 0.0;                    ///< what the model's area grew by [mm^2]
  double overlapArea = 0.0;                ///< of the scan's area what the model had already [mm^2]
  std::shared_ptr<const Plan> plan;        ///< made after it; none for baselines
  PhaseTimes seconds;                      ///< for the report only
};

/// Why an acquisition ended.
enum class Termination : std::uint8_t { Running, Finished, NoOverlap, MaxViews, RegistrationFailed, Cancelled };
[[nodiscard]] std::string_view name(Termination termination);

/// A scan whose registration failed: it is kept, but not integrated.
struct RejectedScan {
  std::int64_t scan = -1;
  std::shared_ptr<const RangeImage> image;
  RegistrationResult registration;
};

/// A view that the operator took out of the model, with the place that it had.
struct LeftOutView {
  View view;
  ViewRecord record;
};

/// Everything known at one moment of an acquisition. Commands make a new state; old ones share what did not change.
struct AcquisitionState {
  std::shared_ptr<const ScannerProfile> profile;  ///< null for recorded scans without one
  AcquisitionSettings settings;
  std::vector<View> views;
  std::vector<ViewRecord> records;     ///< one per view
  std::shared_ptr<const Model> model;  ///< null before the first view
  std::vector<RejectedScan> rejected;
  std::vector<LeftOutView> leftOut;  ///< by number of the scan
  int chosenPosition = -1;           ///< where the operator wants the next scan from; -1: as proposed
  Termination termination = Termination::Running;
};

/// The plan that holds now: that of the last view. Null before the first view and for baselines.
[[nodiscard]] std::shared_ptr<const Plan> currentPlan(const AcquisitionState& state);

}  // namespace vantage
