#pragma once

#include <cstddef>
#include <vector>

#include "geometry/vectors.h"

namespace vantage {

/// So many rotations spread evenly over all that there are, by super-Fibonacci spirals (Alexa, CVPR 2022): about 20
/// degrees from one to the next for 1000. The same for the same count.
[[nodiscard]] std::vector<Eigen::Quaterniond> evenRotations(std::size_t count);

}  // namespace vantage
