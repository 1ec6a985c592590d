#pragma once

#include <cstddef>

#include "integration/model_editor.h"

namespace vantage {

/// Removes pieces that are smaller than the sampling can carry: no vertex of them lies four edges or more inside of
/// their border, where samples begin to be as good as elsewhere, and their area is less than a thousandth of that of
/// the largest piece.
/// @return how many triangles went.
std::size_t removeCrumbs(ModelEditor& editor);

}  // namespace vantage
