#pragma once

#include <memory>

#include "acquisition/acquisition_state.h"
#include "planning/plan_images.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// What the views show: one moment of a session. Every part may be missing; the views show what there is. Parts are
/// immutable and shared.
struct ViewSnapshot {
  std::shared_ptr<const AcquisitionState> state;       ///< views, model, profile
  std::shared_ptr<const Plan> plan;                    ///< made after the last view
  std::shared_ptr<const ScannerImages> scannerImages;  ///< of the profile
  std::shared_ptr<const PlanImages> planImages;        ///< P_v and P_s of the plan

  [[nodiscard]] const ScannerProfile* profile() const { return state ? state->profile.get() : nullptr; }
  [[nodiscard]] const Model* model() const { return state ? state->model.get() : nullptr; }
  /// Position of the last view; -1 for none.
  [[nodiscard]] int current() const {
    return state && !state->views.empty() ? state->views.back().image->position : -1;
  }
  /// The next best view; -1 for none.
  [[nodiscard]] int proposed() const { return plan && plan->outcome == PlanOutcome::Found ? plan->position : -1; }
};

using SharedSnapshot = std::shared_ptr<const ViewSnapshot>;

/// A snapshot of a state with the plan that its last record holds.
[[nodiscard]] SharedSnapshot makeSnapshot(std::shared_ptr<const AcquisitionState> state,
                                          std::shared_ptr<const ScannerImages> scannerImages = nullptr,
                                          std::shared_ptr<const PlanImages> planImages = nullptr);

}  // namespace vantage
