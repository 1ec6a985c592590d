#pragma once

#include <span>
#include <vector>

#include "void_space/void_patch.h"

namespace vantage {

/// How much unseen surface can stand behind each void patch, as a share of what stands behind an open one, in (0, 1].
///
/// Where another patch faces a patch across the void the unseen surface between them is narrow: a slit between two
/// scans attracts less than an open limb. The share is half the distance to the nearest patch that faces it, over
/// `reach`.
/// @param reach [mm] so far ahead a patch stands for unseen surface; beyond twice that the void counts as open.
/// @throws InvalidInput unless reach is positive.
[[nodiscard]] std::vector<double> voidExtents(std::span<const VoidPatch> patches, double reach);

}  // namespace vantage
