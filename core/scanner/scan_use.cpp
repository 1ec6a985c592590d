#include "scanner/scan_use.h"

#include <utility>

namespace vantage {

UsedImage usedImage(const std::shared_ptr<const RangeImage>& image, const ScanUse& use,
                    const std::shared_ptr<const RayGrid>& like, const Progress& progress) {
  validate(*image);
  CutImage cut = cutImage(image, use.cut, progress.part(0.0, 0.9));
  UsedImage used{nullptr, cut.counts, cut.image->sampleCount(), thinningStep(*cut.image, use.thinning)};
  progress.checkpoint(0.9);
  used.image = thinned(std::move(cut.image), used.everyNth, like);
  return used;
}

}  // namespace vantage
