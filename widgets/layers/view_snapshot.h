#pragma once

#include <memory>
#include <optional>

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
  /// Position of the last view; unset for none, or when it was recorded elsewhere.
  [[nodiscard]] std::optional<int> current() const {
    if (!state || state->views.empty() || state->views.back().image->position < 0) return std::nullopt;
    return state->views.back().image->position;
  }
  /// Position of the next best view; unset for none.
  [[nodiscard]] std::optional<int> proposed() const {
    if (!plan || plan->outcome != PlanOutcome::Found) return std::nullopt;
    return plan->position;
  }
  /// The position that is spoken of first: the proposed one, else that of the last view.
  [[nodiscard]] std::optional<int> foremost() const { return proposed() ? proposed() : current(); }
};

using SharedSnapshot = std::shared_ptr<const ViewSnapshot>;

/// A snapshot of a state with the plan that its last record holds.
[[nodiscard]] SharedSnapshot makeSnapshot(std::shared_ptr<const AcquisitionState> state,
                                          std::shared_ptr<const ScannerImages> scannerImages = nullptr,
                                          std::shared_ptr<const PlanImages> planImages = nullptr);

}  // namespace vantage
