#pragma once

#include "registration/aligner.h"

namespace vantage {

/// Another pose that fits about as well as the one found.
struct Rival {
  double distance = 0.0;  ///< how far the points lie from where the found pose puts them [mm]; 0: no rival
};

/// Starts again from either side of the found pose, along the motions that the surface holds least and as far as the
/// prior allows. Finds the neighbouring period of a repetitive shape, which no residual betrays.
/// @param points ids of the model points that the found pose was fitted to
/// @throws Cancelled
[[nodiscard]] Rival findRival(const Aligner& aligner, const Fit& found, const std::vector<std::uint32_t>& points,
                              const Stability& stability, const PosePrior& prior, const IcpOptions& options,
                              const Progress& progress);

}  // namespace vantage
