#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "composites/alignment_limits.h"
#include "composites/composite_model.h"

namespace vantage {

/// What the surface of one composite is to another composite at a pose.
enum class PlaceWord : std::uint8_t {
  Nothing,   ///< nothing is known of it there
  OnIt,      ///< it lies on the other's surface
  Conflict,  ///< off the other's surface where a ray of the other passed
  Table,     ///< below a table of the other
  Missing,   ///< off the other's surface though a scan of the other should have seen it
};

/// Asks the rays of one composite about the surface of another at a pose; see PoseEvidence for what the words mean.
/// One thread at a time.
class RayWitness {
 public:
  /// Keeps referring to both.
  /// @param from whose surface is asked about @param on whose rays answer
  RayWitness(const CompositeModel& from, const CompositeModel& on, const Pose& T_on_from,
             const AlignmentLimits& limits);

  /// @param point of the surface of `from`; fastest for points that are near the one before
  [[nodiscard]] PlaceWord ask(std::uint32_t point);

  /// Whether it lies on the other's surface within a distance and faces the same way.
  [[nodiscard]] bool agrees(std::uint32_t point, double distance) const;

 private:
  // What one view says about a place.
  enum class Word : std::uint8_t { Nothing, Passed, Empty };

  [[nodiscard]] std::optional<std::uint32_t> nearestOnSurface(const Vec3& p) const;
  [[nodiscard]] Word wordOf(std::size_t view, const Vec3& p);
  [[nodiscard]] bool isExpected(std::size_t view, std::uint32_t point, const Vec3& p) const;
  [[nodiscard]] bool sees(const Vec3& eye, const Vec3& p) const;

  const CompositeModel& from_;
  const CompositeModel& on_;
  Pose T_on_from_;
  Pose T_from_on_;
  double near_;
  std::vector<Pose> T_scanner_on_;
  std::vector<std::optional<GridPosition>> places_;  // per view: where the point before was in its grid
};

}  // namespace vantage
