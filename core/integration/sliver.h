#pragma once

#include <cstddef>
#include <span>

#include "integration/model_editor.h"

namespace vantage {

struct SliverOptions {
  double shortestEdge = 0.3;  ///< [mm] shorter edges are collapsed
  /// A triangle less round than this is improved by a flip if one helps. Roundness is 4 sqrt(3) area / (sum of squared
  /// sides): 1 when equilateral, 0 when flat, 0.56 for an apex of 20 degrees between equal sides.
  double minRoundness = 0.5;
  double maxTurn = radians(50.0);  ///< neither may turn a triangle's normal farther than this
  int flipRounds = 2;
};

/// Makes the triangles at some vertices rounder (Turk & Levoy 1994, 3.3): collapses short edges onto their more
/// confident end and flips edges of needles. No vertex moves; the mesh stays manifold and oriented as it was.
/// @pre no bow ties
/// @return how many edges were collapsed or flipped.
std::size_t removeSlivers(ModelEditor& editor, std::span<const std::uint32_t> vertices, const SliverOptions& options);

}  // namespace vantage
