#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// A motion that points hold badly, as plainly as it can be said.
struct WeakMotion {
  enum class Kind : std::uint8_t {
    Slide,  ///< along the axis
    Turn,   ///< about the axis
    Free,   ///< nothing holds any motion; without an axis
  };
  Kind kind = Kind::Free;
  /// x, y or z when within 10 degrees of these, else the unit vector with its largest part positive, to a tenth:
  /// (0.7, 0.7, 0.0). Zero for Free.
  Vec3 axis = Vec3::Zero();

  friend bool operator==(const WeakMotion&, const WeakMotion&) = default;
};

/// "slide", "turn", "free".
[[nodiscard]] std::string_view name(WeakMotion::Kind kind);

/// What is held about equally badly, slides before turns and x before y before z; empty where nobody asked.
using WeakMotions = std::vector<WeakMotion>;

/// A motion that is held badly, scaled so that rotation and translation compare: (radius * rotation, translation),
/// unit.
struct WeakDirection {
  Vec6 direction = Vec6::Zero();
  WeakMotions motions;
};

/// The main part of a motion: a slide if it moves the points more along one direction than around an axis near them,
/// a turn otherwise.
[[nodiscard]] WeakMotion plainMotion(const Vec6& scaledMotion);

/// The weakest direction of an information matrix given by its eigenvalues (ascending) and eigenvectors. Where several
/// eigenvalues are about equally small (a plane lets go of three motions at once) any mixture of them is as weak:
/// the simplest comes first, slides before turns and x before y before z, and the others follow. Without any
/// information everything is Free.
[[nodiscard]] WeakDirection weakestDirection(const Vec6& eigenvalues, const Mat6& eigenvectors);

}  // namespace vantage
