#include "scanner/range_image.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"

namespace vantage {

std::size_t RangeImage::sampleCount() const {
  return static_cast<std::size_t>(std::count_if(range.begin(), range.end(), [](float r) { return !std::isnan(r); }));
}

void validate(const RangeImage& image) {
  if (!image.rays) throw InvalidInput("range image without ranging rays");
  if (image.range.size() != image.rays->size())
    throw InvalidInput("range image has " + std::to_string(image.range.size()) + " distances for " +
                       std::to_string(image.rays->size()) + " ranging rays");
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i) && (std::isinf(image.range[i]) || image.range[i] < 0.0F))
      throw InvalidInput("range image: distance " + std::to_string(i) + " is " + std::to_string(image.range[i]));
  if (!image.colours.empty() && image.colours.size() != image.range.size())
    throw InvalidInput("range image has " + std::to_string(image.colours.size()) + " colours for " +
                       std::to_string(image.range.size()) + " distances");
  if (const auto& u = image.poseUncertainty; u && !(std::isfinite(u->angleSigma) && u->angleSigma >= 0.0 &&
                                                    std::isfinite(u->positionSigma) && u->positionSigma >= 0.0))
    throw InvalidInput("range image: the uncertainty of its pose is no number of degrees and millimetres");
  const Eigen::Matrix3d& r = image.T_table_scanner.linear();
  if (!image.T_table_scanner.matrix().allFinite() || !(r * r.transpose()).isIdentity(1e-6) || r.determinant() < 0.0)
    throw InvalidInput("range image: the pose is not a rigid motion");
}

}  // namespace vantage
