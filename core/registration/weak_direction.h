#pragma once

#include <string>

#include "geometry/vectors.h"

namespace vantage {

/// A motion that is held badly, scaled so that rotation and translation compare: (radius * rotation, translation),
/// unit.
struct WeakDirection {
  Vec6 direction = Vec6::Zero();
  std::string name;
};

/// A motion in words. Its main part speaks: "slides along <axis>" if it moves the points more along one direction than
/// around an axis near them, "turns about <axis>" otherwise. The axis is "x", "y" or "z" when within 10 degrees of
/// these, else its unit vector with the largest part positive, "(0.7, 0.7, 0.0)".
[[nodiscard]] std::string nameMotion(const Vec6& scaledMotion);

/// The weakest direction of an information matrix given by its eigenvalues (ascending) and eigenvectors. Where several
/// eigenvalues are about equally small (a plane lets go of three motions at once) any mixture of them is as weak:
/// the simplest is named, slides before turns and x before y before z, and the others follow, joined by "and". Without
/// any information it "moves freely".
[[nodiscard]] WeakDirection weakestDirection(const Vec6& eigenvalues, const Mat6& eigenvectors);

}  // namespace vantage
