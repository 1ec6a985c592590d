#pragma once

#include <functional>

#include "geometry/measures.h"
#include "geometry/mesh.h"

namespace vantage::testing {

/// The surface where `field` is zero inside `box`, by marching tetrahedra on a grid of `spacing` [mm]: closed if
/// the field is positive on the box, manifold, oriented toward positive values.
[[nodiscard]] Mesh polygonize(const std::function<double(const Vec3&)>& field, const BoundingBox& box, double spacing);

/// Takes the area-less triangles out of a closed mesh that decimation may leave: a corner that lies on the opposite
/// side (within `height` [mm]) is joined with the corner beyond that side, by turning the side round.
void flipFlatTriangles(Mesh& mesh, double height);

}  // namespace vantage::testing
