#pragma once

#include <cstdint>
#include <string_view>

#include "geometry/ray_caster.h"
#include "scanner/profile.h"

namespace vantage {

/// Whether a scanner samples a point of a surface, and if not, the first thing that keeps it from doing so, in the
/// order in which a scan meets them.
enum class Visibility : std::uint8_t { OutOfReach, TooSteep, LightBlocked, ReceiverBlocked, Seen };

/// "out_of_reach", "too_steep", "light_blocked", "receiver_blocked", "seen".
[[nodiscard]] std::string_view name(Visibility visibility);

/// What a scanner at one pose makes of one point.
struct Sight {
  Visibility visibility = Visibility::OutOfReach;
  double cosine = 0.0;            ///< between normal and the direction to the light source
  Vec3 direction = Vec3::Zero();  ///< unit, from the point to the light source, object coordinates
};

/// How a point is looked at. Planning takes offset and margin from the sample spacing: see PlannerOptions.
struct SightOptions {
  double breakdownAngle = radians(60.0);  ///< [rad]
  double offset = 0.0;                    ///< lines of sight begin this far in front of the surface [mm]
  double margin = 0.0;                    ///< and what blocks them within this distance does not count [mm]
};

/// Looks at a point with the scanner's own ranging rays: the ray through it, its range limits, its angle, and the lines
/// to light and receivers through the obstacles. Exact where positional space is quantised; its cost grows with the
/// number of poses, so it serves to judge the few positions that positional space proposes.
class SightTest {
 public:
  /// All must outlive the test.
  /// @param assumed what blocks the sight as well, though nobody has seen it; may be null
  SightTest(const ScannerProfile& profile, const RayCaster& obstacles, const SightOptions& options,
            const RayCaster* assumed = nullptr);

  /// @param normal unit, object coordinates like `point`.
  [[nodiscard]] Sight look(const Pose& T_object_scanner, const Vec3& point, const Vec3& normal) const {
    return look(T_object_scanner, point, normal, options_.breakdownAngle);
  }
  /// The same up to another angle than the breakdown angle [rad].
  [[nodiscard]] Sight look(const Pose& T_object_scanner, const Vec3& point, const Vec3& normal,
                           double widestAngle) const;

  /// Whether a receiver of the ranging ray of that index sees the point; true for a scanner that does not triangulate.
  [[nodiscard]] bool received(const Pose& T_object_scanner, std::size_t ray, const Vec3& point,
                              const Vec3& normal) const;

  [[nodiscard]] const SightOptions& options() const { return options_; }

 private:
  [[nodiscard]] bool blocked(const Vec3& from, const Vec3& to) const;

  const ScannerProfile& profile_;
  const RayCaster& obstacles_;
  const RayCaster* assumed_;
  SightOptions options_;
};

}  // namespace vantage
