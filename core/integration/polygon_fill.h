#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "integration/model_editor.h"

namespace vantage {

/// The border of a hole through a vertex, counter-clockwise about the hole; empty when the vertex is not on a border or
/// the loop has more edges.
/// @pre no bow ties
[[nodiscard]] std::vector<std::uint32_t> borderLoop(const ModelEditor& editor, std::uint32_t vertex, int maxEdges);

/// Whether a triangle, of which the area vector is given, may be part of the filling.
using FillTest = std::function<bool(const Triangle&, const Vec3&)>;

/// Triangles of least area that fill a loop of few edges; none when there are no such triangles that all pass the test.
/// Chords are no longer than `maxChord` and no edges of the model; an infinite length allows any, for a shape that is
/// not to be built.
[[nodiscard]] std::vector<Triangle> fillPolygon(const ModelEditor& editor, std::span<const std::uint32_t> loop,
                                                double maxChord, const FillTest& mayFill);

}  // namespace vantage
