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

/// @param plan of this mesh: once no view is worth taking it tells what all positions together would still show
///        (Plan::voidLeft). Before, and without one, all that is missing counts as scannable.
[[nodiscard]] Completeness completenessOf(const Mesh& mesh, const Plan* plan);

}  // namespace vantage
