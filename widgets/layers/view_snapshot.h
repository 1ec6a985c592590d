#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "planning/plan_images.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// What the views show: one moment of a session. Every part may be missing; the views show what there is. Parts are
/// immutable and shared.
struct ViewSnapshot {
  std::shared_ptr<const AcquisitionState> state;       ///< views, model, profile
  std::shared_ptr<const Plan> plan;                    ///< that holds then
  std::shared_ptr<const ScannerImages> scannerImages;  ///< of the profile
  std::shared_ptr<const PlanImages> planImages;        ///< P_v and P_s of the plan

  [[nodiscard]] const ScannerProfile* profile() const { return state ? state->profile.get() : nullptr; }
  [[nodiscard]] const Model* model() const { return state ? state->model.get() : nullptr; }
  std::shared_ptr<const Mesh> expected;  ///< what stands before the simulated scanner; null where nobody knows
  std::optional<int> table;              ///< the position where the table stands
  std::optional<int> next;  ///< the position of the next scan, once there is a plan: proposed, or the operator's choice
  /// The same once the acquisition has ended: the position that would come next if it went on.
  std::optional<int> further;
  bool operatorsChoice = false;  ///< the next position is the operator's
  std::vector<View> views;       ///< of the model, in order

  [[nodiscard]] std::optional<int> current() const { return table; }
  [[nodiscard]] std::optional<int> proposed() const { return next; }
  /// The position that is spoken of first: the next one, else where the table stands.
  [[nodiscard]] std::optional<int> foremost() const { return next ? next : table; }
};

/// In which stands views were taken, one for each.
[[nodiscard]] std::vector<int> standsOf(const std::vector<View>& views);
/// Whether they were taken in more than one.
[[nodiscard]] bool haveStands(const std::vector<View>& views);

using SharedSnapshot = std::shared_ptr<const ViewSnapshot>;

/// A snapshot of a state with its plan. The table stands where the state's last scan was taken.
[[nodiscard]] SharedSnapshot makeSnapshot(std::shared_ptr<const AcquisitionState> state,
                                          std::shared_ptr<const ScannerImages> scannerImages = nullptr,
                                          std::shared_ptr<const PlanImages> planImages = nullptr);

}  // namespace vantage
