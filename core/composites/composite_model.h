#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/progress.h"
#include "composites/composite.h"
#include "composites/composite_surface.h"
#include "composites/voxel_field.h"
#include "geometry/ray_caster.h"
#include "registration/registration_scale.h"
#include "registration/view_network.h"

namespace vantage {

/// How many points of a composite a step of an alignment looks at: about 300, 1500 and 8000.
enum class PointLevel : std::uint8_t { Coarse, Medium, Fine };
inline constexpr int kPointLevels = 3;

/// A composite ready to be aligned with any number of others: points spread by area, surface, field, rays. A second of
/// work, done once per composite. Immutable; cheap to copy.
class CompositeModel {
 public:
  /// Steps reported: prepare.
  /// @throws InvalidInput for a composite without views or surface, for provenance or ties that name no view; Cancelled
  explicit CompositeModel(Composite composite, const Progress& progress = {});

  [[nodiscard]] const Composite& composite() const { return composite_; }
  [[nodiscard]] const CompositeSurface& surface() const { return *surface_; }
  /// Points of the surface, away from its border; neighbours in the list are near each other.
  [[nodiscard]] std::span<const std::uint32_t> points(PointLevel level) const {
    return (*points_)[static_cast<std::size_t>(level)];
  }
  [[nodiscard]] const VoxelField& field() const { return *field_; }
  [[nodiscard]] const RayCaster& caster() const { return *caster_; }
  /// Of the views; the extent is that of the whole composite about its centroid.
  [[nodiscard]] const RegistrationScale& scale() const { return scale_; }
  /// How far its views lie off each other where they overlap, robust deviation [mm]; 0 for a single one. What is wrong
  /// with a real scanner beyond its noise shows here.
  [[nodiscard]] double residual() const { return residual_; }
  [[nodiscard]] const Vec3& centroid() const { return centroid_; }  ///< of the surface [mm]
  [[nodiscard]] double radius() const { return radius_; }           ///< RMS distance of the surface from it [mm]
  [[nodiscard]] const std::vector<PreparedView>& prepared() const { return *prepared_; }

  /// The same composite after its views have moved by a little in themselves: the surface goes with them, what is
  /// coarse (field, occlusion) stays.
  /// @param poses one per view, T_composite_scanner
  [[nodiscard]] CompositeModel withPoses(std::span<const Pose> poses) const;

 private:
  void measure();

  Composite composite_;
  std::shared_ptr<const CompositeSurface> surface_;
  std::shared_ptr<const std::array<std::vector<std::uint32_t>, kPointLevels>> points_;
  std::shared_ptr<const VoxelField> field_;
  std::shared_ptr<const RayCaster> caster_;
  std::shared_ptr<const std::vector<PreparedView>> prepared_;
  RegistrationScale scale_;
  double residual_ = 0.0;
  Vec3 centroid_ = Vec3::Zero();
  double radius_ = 1.0;
};

}  // namespace vantage
