#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "forecast/closing_surface.h"
#include "forecast/forecast_ledger.h"
#include "geometry/ray_caster.h"
#include "integration/erasing.h"
#include "integration/model.h"
#include "planning/patch_history.h"
#include "planning/planner_options.h"
#include "planning/turn_spread.h"
#include "scanner/profile.h"
#include "scanner/sight.h"
#include "scanner/view.h"
#include "void_space/void_patch.h"

namespace vantage {

/// What is not the object of what scans see in the stand that is planned for: the operator erased it. It hides as
/// before, but nothing of it is looked for.
struct ErasedInStand {
  ErasedSpace space;                    ///< empty where nothing is erased
  int stand = 0;                        ///< that is planned for
  std::vector<std::uint8_t> border;     ///< one per vertex of the model, see erasedBorder; or none
  std::shared_ptr<const Mesh> surface;  ///< what views saw of it, object coordinates; null for nothing
};

/// What a plan is made from. Parts are immutable and shared.
struct PlanInput {
  std::shared_ptr<const ScannerProfile> profile;
  std::shared_ptr<const Model> model;
  std::vector<View> views;     ///< all that the model is made of, in every stand of the object
  std::vector<int> taken;      ///< positions that scans were taken from, in the stand that is planned for
  std::optional<int> current;  ///< where the scanner is, which a tie is broken by
  /// How the object stands. Poses of the workspace are taken relative to the table: a position sees the object from
  /// T_object_table times its pose.
  Pose T_object_table = Pose::Identity();
  /// How well the next move meets its position; nothing for as well as the profile says.
  std::optional<Mechanics> mechanics = {};
  std::vector<ForecastEntry> ledger = {};  ///< what was forecast of the views so far, and what they showed; in order
  ErasedInStand erased = {};
};

/// Surface that nobody has seen, as a plan expects it.
struct ExpectedSurface {
  ClosingSurface closing;  ///< in the table's frame
  RayCaster obstacles;     ///< the closing surface
  RayCaster all;           ///< the model's surface and the closing surface
  ForecastTrust trust;     ///< of the run's forecasts
  /// Per face the cosine at which the view saw it most squarely that should have sampled it, if only just: like a
  /// patch, a face attracts only views that see it clearly more squarely. 0 where none did.
  std::vector<double> seenAt;
};

/// What a plan is made with: everything that plan, images, sights, pictures and certificate have in common, put
/// together once, so that what explains a plan agrees with it. Immutable; any number of threads may ask it.
///
/// It lives in the table's frame, in which workspace, scanner images and positional space are: model, views and patches
/// are moved there, unless both frames are the same.
class PlanningScene {
 public:
  /// Finds the void patches of the model.
  /// @throws InvalidInput when there is no view yet, or a model that does not fit its views; Cancelled
  PlanningScene(const PlanInput& input, const PlannerOptions& options, const Progress& progress);

  /// The scene of a plan that was made of the same input and options.
  /// @param voids the void patches of that plan
  /// @throws InvalidInput when there is no view yet; Cancelled
  PlanningScene(PlanInput input, std::shared_ptr<const VoidSurface> voids, const PlannerOptions& options,
                const Progress& progress);

  PlanningScene(const PlanningScene&) = delete;
  PlanningScene& operator=(const PlanningScene&) = delete;

  [[nodiscard]] const PlanInput& input() const { return input_; }
  [[nodiscard]] const ScannerProfile& profile() const { return *input_.profile; }
  [[nodiscard]] const PlannerOptions& options() const { return options_; }
  /// Mean sample spacing of the views [mm].
  [[nodiscard]] double spacing() const { return spacing_; }
  /// theta_b of the scanner [rad].
  [[nodiscard]] double breakdownAngle() const { return profile().breakdownAngle; }

  /// The void patches in the object's frame, weighted by their extents.
  [[nodiscard]] const std::shared_ptr<const VoidSurface>& voids() const { return voids_; }
  /// The same in the table's frame.
  [[nodiscard]] std::span<const VoidPatch> patches() const {
    return turnedPatches_ ? *turnedPatches_ : voids_->patches;
  }
  /// Whether what lies beyond a patch was erased: no view looks for it.
  [[nodiscard]] bool erased(std::size_t patch) const { return !erased_.empty() && erased_[patch] != 0; }
  /// What the views say about the patches.
  [[nodiscard]] const PatchHistory& history() const { return history_; }

  /// The model's surface, decimated when it is large, in the table's frame.
  [[nodiscard]] const Mesh& surface() const { return surface_; }
  /// What blocks the sight: the surface, and what was erased from it.
  [[nodiscard]] const RayCaster& obstacles() const { return obstacles_; }
  /// Looks at points in the table's frame up to the breakdown angle.
  [[nodiscard]] const SightTest& sight() const { return sight_; }

  /// What is expected where nobody has looked; null where nothing is forecast.
  [[nodiscard]] const ExpectedSurface* expected() const { return expected_.get(); }
  /// Looks at expected surface, a little clear of the breakdown angle. @pre expected() is not null
  [[nodiscard]] const SightTest& sightOfExpected() const { return *sightOfExpected_; }
  /// Whether a face of it attracts a view that sees it at that cosine. @pre expected() is not null
  [[nodiscard]] bool expectedAttracts(std::size_t face, double cosine) const {
    const double before = expected_->seenAt[face];
    return before == 0.0 || cosine > before + options_.history.cosineGain;
  }

  /// T_table_scanner of a position.
  /// @throws InvalidInput for a position that the workspace does not have
  [[nodiscard]] const Pose& pose(int position) const;
  /// How well a move meets a position.
  [[nodiscard]] const Mechanics& mechanics() const {
    return input_.mechanics ? *input_.mechanics : profile().mechanics;
  }
  /// Where a move may end.
  [[nodiscard]] const TurnSpread& spread() const { return spread_; }
  /// A second scan from the same place finds what the first one found.
  [[nodiscard]] bool taken(int position) const;
  /// The same point and direction in the table's frame.
  [[nodiscard]] Vec3 pointOnTable(const Vec3& inObject) const;
  [[nodiscard]] Vec3 directionOnTable(const Vec3& inObject) const;

 private:
  PlanInput input_;
  PlannerOptions options_;
  double spacing_;
  std::optional<Pose> T_table_object_;  // nothing when the frames are the same
  std::shared_ptr<const VoidSurface> voids_;
  std::optional<std::vector<VoidPatch>> turnedPatches_;
  std::vector<std::uint8_t> erased_;  // per patch, or none
  Mesh surface_;
  Mesh beside_;  // what was erased
  RayCaster obstacles_;
  SightTest sight_;
  PatchHistory history_;
  TurnSpread spread_;
  std::unique_ptr<const ExpectedSurface> expected_;
  std::unique_ptr<const SightTest> sightOfExpected_;
};

}  // namespace vantage
