#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "acquisition/acquisition_state.h"
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
  std::size_t erasedHoles = 0;    ///< of those, what the operator erased was behind the larger part of their edges
};

/// @param plan of this mesh: one that forecasts tells, once no view is worth taking, what all positions together would
///        still show; of another an opening counts as scannable by the share of its edges along which some position
///        could show more (EdgeReason). All do without a plan.
/// @param erasedBorder 1 for vertices of the border beyond which the operator erased something, see erasedBorder; none:
///        nothing. By the share of these an opening is none: what was there is not the object.
[[nodiscard]] Completeness completenessOf(const Mesh& mesh, const Plan* plan,
                                          std::span<const std::uint8_t> erasedBorder = {});

/// Of the model of a state, with what is erased in its stand of now. Nothing is covered without a model.
[[nodiscard]] Completeness completenessOf(const AcquisitionState& state);

}  // namespace vantage
