#pragma once

#include <span>

#include "geometry/mesh.h"

namespace vantage {

/// All meshes as one, in order; what they share is there as often as they share it.
[[nodiscard]] Mesh together(std::span<const Mesh* const> meshes);

}  // namespace vantage
