#pragma once

#include <cstddef>

#include "geometry/mesh.h"
#include "planning/plan.h"

namespace vantage {

/// How much of an object its model shows, as far as that can be told without the object: what is missing is what its
/// openings would take to be spanned. Where an opening leads to more than that (a model of one side only, a deep
/// cavity), more is missing.
struct Completeness {
  double scannableCovered = 0.0;  ///< share of what the scanner can show, 0..1
  double wholeCovered = 0.0;      ///< share of all, 0..1
  std::size_t holes = 0;          ///< openings
  std::size_t pieces = 0;         ///< connected over edges
  bool closed = false;            ///< one surface without any opening
};

/// @param plan of this mesh: one that forecasts tells, once no view is worth taking, what all positions together would
///        still show; of another an opening counts as scannable by the share of its edges along which some position
///        could show more (EdgeReason). All do without a plan.
[[nodiscard]] Completeness completenessOf(const Mesh& mesh, const Plan* plan);

}  // namespace vantage
