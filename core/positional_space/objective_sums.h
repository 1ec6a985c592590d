#pragma once

#include <vector>

#include "positional_space/positional_image.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// For every position i the sum over its image, o(i) = sum of P_c^i * P (Pito 1999, eq. 5): o_v for P_v, o_s for P_s,
/// the confidence-weighted area that the scanner at x_i samples [mm^2].
/// @throws InvalidInput when the image belongs to other scanner images.
[[nodiscard]] std::vector<double> intersect(const PositionalImage& image, const ScannerImages& scanner);

}  // namespace vantage
