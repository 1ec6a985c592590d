#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "acquisition/kept_scan.h"
#include "acquisition/settings.h"
#include "acquisition/stand.h"
#include "integration/model.h"
#include "planning/plan.h"
#include "scanner/profile.h"

namespace vantage {

/// Why an acquisition ended.
enum class Termination : std::uint8_t {
  Running,             ///< it has not
  Finished,            ///< no position would show more than is worth a scan
  NoOverlap,           ///< void is left, but no position that shows it overlaps the model enough
  MaxViews,            ///< the greatest number of views was taken
  RegistrationFailed,  ///< scans did not find their place, several times in a row
  Cancelled,           ///< a run was stopped by a signal; never recorded
  EndedByOperator,     ///< the operator had enough
  Imported,            ///< recorded scans were put together; nothing was planned
};
inline constexpr Termination kLastTermination = Termination::Imported;
/// "running", "finished", "no_overlap", "max_views", "registration_failed", "cancelled", "ended_by_operator",
/// "imported".
[[nodiscard]] std::string_view name(Termination termination);

/// Who takes the next step: the program, or a person who turns the table and confirms every scan.
enum class Mode : std::uint8_t { Automatic, Assisted };
inline constexpr Mode kLastMode = Mode::Assisted;
/// "automatic", "assisted".
[[nodiscard]] std::string_view name(Mode mode);

/// The model of a composite that is not in work, see acquisition/stand_composites.h.
struct ModelAside {
  int composite = 0;
  std::shared_ptr<const Model> model;
};

/// Everything known at one moment of an acquisition. Commands make a new state; old ones share what did not change.
struct AcquisitionState {
  std::shared_ptr<const ScannerProfile> profile;  ///< null for recorded scans without one
  AcquisitionSettings settings;
  Mode mode = Mode::Automatic;
  std::vector<Stand> stands{{Pose::Identity()}};  ///< in the order in which the object was turned over; never empty
  std::vector<KeptScan> scans;                    ///< in the order in which they were added
  std::shared_ptr<const Model> model;             ///< of the scans that are in; null before the first one
  std::vector<ModelAside> aside;                  ///< of the scans that are aside, one per composite, in its order
  std::shared_ptr<const Plan> plan;               ///< for the stand of now; null without one
  std::optional<int> chosenPosition;              ///< where the operator wants the next scan from, else as proposed
  Termination termination = Termination::Running;

  /// The stand in which the object is now: the last one.
  [[nodiscard]] int stand() const { return static_cast<int>(stands.size()) - 1; }
};

/// The views of the model, in order: the model counts them so.
[[nodiscard]] std::vector<View> viewsOf(const AcquisitionState& state);

/// The scans of a status, in order. They live as long as the state.
[[nodiscard]] std::vector<const KeptScan*> scansOf(const AcquisitionState& state, ScanStatus status);
[[nodiscard]] std::size_t countScans(const AcquisitionState& state, ScanStatus status);

/// The last scan that is a view of the model, of one stand or of any; null when there is none.
[[nodiscard]] const KeptScan* lastView(const AcquisitionState& state, std::optional<int> stand = {});

/// The scan of that number; null when the state has none.
[[nodiscard]] const KeptScan* findScan(const AcquisitionState& state, std::int64_t number);

/// The pose of a position of the workspace as the object stands now, T_object_scanner. The object's frame is that of
/// the table as long as nobody knows how it was turned over. @pre the profile has the position
[[nodiscard]] Pose poseOf(const AcquisitionState& state, int position);

}  // namespace vantage
