#pragma once

#include "forecast/free_space.h"

namespace vantage {

/// Fills in the levels of the unseen: each the mean of its six neighbours' and, as far as silent rays pull, 1. Between
/// the model's surface, which is negative behind, and free space the field is harmonic, and its zero level the surface
/// that closes the model most smoothly (a membrane). Goes on from the levels that are there, in so many sweeps of
/// over-relaxation over alternate voxels.
void relaxLevels(FreeSpace& space, int sweeps);

}  // namespace vantage
