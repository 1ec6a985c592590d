#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// A part of a surface of which some vertices may move.
struct FairedPart {
  Mesh mesh;                          ///< the patch, and two rings of triangles of the surface around it
  std::vector<std::uint8_t> mayMove;  ///< per vertex: 1 inside of the patch
  std::vector<std::uint8_t> onSeam;   ///< per vertex: 1 where the patch meets the surface around it
};

/// Moves the inside of a patch to where
///   reach^2 |Laplace x|^2 + |grad x|^2
/// over the patch and its seam is least, by the angles and areas of the triangles as they are (cotangent weights):
/// within about the reach of its border it continues the surface around it (thin plate), farther inside it is as tight
/// as a soap film. With reach 0 it is a soap film. Repeated calls come nearer to the shape as it would be by its own
/// angles.
/// @param reach [mm]
/// @return whether there was such a place; the vertices stay where they are when not
/// @throws Cancelled
bool fairPatch(FairedPart& part, double reach, const Progress& progress = {});

}  // namespace vantage
