#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "geometry/measures.h"
#include "geometry/vectors.h"
#include "measuring/surface_plane.h"

namespace vantage {

/// Checks for arguments of the form X,Y,Z.
[[nodiscard]] CLI::Validator pointText();
/// The point of such an argument. @pre pointText accepts it
[[nodiscard]] Vec3 pointOf(const std::string& text);

/// Checks for arguments of the form NX,NY,NZ,D: a plane of the points p with n . p = d, n of any length.
[[nodiscard]] CLI::Validator planeText();
/// The plane of such an argument. @pre planeText accepts it
[[nodiscard]] SurfacePlane planeOf(const std::string& text);

/// Checks for arguments of the form X1,Y1,Z1,X2,Y2,Z2: two opposite corners of a box along the axes, in any order.
[[nodiscard]] CLI::Validator boxText();
/// The box of such an argument. @pre boxText accepts it
[[nodiscard]] BoundingBox boxOf(const std::string& text);

}  // namespace vantage
