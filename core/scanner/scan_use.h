#pragma once

#include <memory>

#include "base/progress.h"
#include "scanner/scan_cut.h"
#include "scanner/thinning.h"

namespace vantage {

/// How a scan becomes what is worked on: cut as it came, and thinned then.
struct ScanUse {
  ScanCut cut;
  ThinningOptions thinning;
};

/// What is worked on of a scan.
struct UsedImage {
  std::shared_ptr<const RangeImage> image;
  CutCounts cut{};          ///< of the scan as it came; all 0 where nothing is ever cut
  std::size_t samples = 0;  ///< of the scan as it came, that were not cut
  int everyNth = 1;         ///< row and column is left; 1: all are
};

/// The same image where nothing is cut and nothing thinned.
/// @param like rays that are shared where they are the same, see thinnedRays; may be null
/// @throws InvalidInput for a range image that is not one; Cancelled
[[nodiscard]] UsedImage usedImage(const std::shared_ptr<const RangeImage>& image, const ScanUse& use,
                                  const std::shared_ptr<const RayGrid>& like = nullptr, const Progress& progress = {});

}  // namespace vantage
