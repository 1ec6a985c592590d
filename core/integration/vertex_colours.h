#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "scanner/range_image.h"

namespace vantage {

/// A colour per vertex of a model, nothing where no scan with colours has a say; empty where no scan has colours.
using VertexColours = std::vector<std::optional<Colour>>;

/// A neutral grey: files and pictures have it where a model has no colour.
inline constexpr Colour kGrey{128, 128, 128};

/// How many vertices have none.
[[nodiscard]] inline std::size_t countColourless(const VertexColours& colours) {
  return static_cast<std::size_t>(std::count(colours.begin(), colours.end(), std::nullopt));
}

}  // namespace vantage
