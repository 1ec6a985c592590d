#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// Whether an edge between two vertices of a patch's border is one of the surface around it.
using JoinedOutside = std::function<bool(std::uint32_t, std::uint32_t)>;

/// Refines a patch until no edge inside of it is longer than about 1.4 times an edge length, turns edges so that the
/// angles across every edge sum up to 180 degrees at most (Delaunay), and moves what it added amid its neighbours. The
/// vertices that were there stay, and edges on the border get no others between them; new vertices follow the old ones.
/// No two triangles get the same directed edge.
/// @param patch manifold, with the topology of a disc
/// @param edgeLength [mm], above 0
/// @param joined null: none are
/// @throws Cancelled
void refinePatch(Mesh& patch, double edgeLength, const JoinedOutside& joined, const Progress& progress = {});

/// Only turns edges as refinePatch does. @throws Cancelled
void turnEdges(Mesh& patch, const JoinedOutside& joined, const Progress& progress = {});

}  // namespace vantage
