#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "scanner/range_image.h"

namespace vantage {

/// How many of a scanner's samples are worked on. What is left out stays in the scan as it was taken.
struct ThinningOptions {
  /// Samples nearer to each other than this are thinned [mm]; 0: none are. Unset: those of a scanner with more than
  /// kWholeRays rays.
  std::optional<double> spacing;
  bool operator==(const ThinningOptions&) const = default;
};

/// Of a scanner with more rays than this not all are worked on unless a spacing is given: what registration, model and
/// plan gain from more of them is less than the noise of most scanners, and time and memory grow with their number.
inline constexpr std::size_t kWholeRays = 1'500'000;
/// As many at most are worked on then.
inline constexpr std::size_t kUsefulRays = 600'000;

/// Every n-th row and column of a grid is worked on, n >= 1: the largest step that leaves neighbours no farther apart
/// than the spacing, at the middle of what the image shows; without a spacing, of a grid of
/// more than kWholeRays rays, the smallest that leaves no more than kUsefulRays. At least 2 x 2 rays are left.
/// @pre the image has rays, and a distance for each
[[nodiscard]] int thinningStep(const RangeImage& image, const ThinningOptions& options);

/// Every step-th row and column of a grid, as many left out on one side as on the other; the grid itself for step 1.
/// @param like a grid that is handed out instead when it has the same rays; may be null
/// @throws InvalidInput when fewer than 2 x 2 rays are left
[[nodiscard]] std::shared_ptr<const RayGrid> thinnedRays(const std::shared_ptr<const RayGrid>& rays, int step,
                                                         const std::shared_ptr<const RayGrid>& like = nullptr);

/// The ray of the whole grid that ray i of the thinned one is.
[[nodiscard]] std::size_t rayBeforeThinning(const RayGrid& whole, int step, std::size_t i);

/// The samples of an image on every step-th row and column; the image itself for step 1.
/// @param like see thinnedRays: thinned images of one scanner share their rays
[[nodiscard]] std::shared_ptr<const RangeImage> thinned(const std::shared_ptr<const RangeImage>& image, int step,
                                                        const std::shared_ptr<const RayGrid>& like = nullptr);

}  // namespace vantage
