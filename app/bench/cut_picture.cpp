#include "bench/cut_picture.h"

#include <algorithm>

#include "report_pictures.h"

namespace vantage {

QColor colourOf(CutReason reason) {
  switch (reason) {
    case CutReason::Table:
      return {0x8c, 0x6d, 0x46};
    case CutReason::Outside:
      return {0x4a, 0x6a, 0x8c};
    case CutReason::Flying:
      return {0xd6, 0x45, 0x45};
    case CutReason::Isolated:
      return {0xe0, 0x8a, 0x2e};
    case CutReason::Island:
      return {0x9b, 0x5f, 0xb5};
    case CutReason::Kept:
      return {0xd8, 0xd8, 0xd0};
    case CutReason::NoSample:
      break;
  }
  return {0x22, 0x27, 0x2e};
}

QImage cutPicture(const RangeImage& scan, std::span<const CutReason> reasons, int most) {
  const RayGrid& rays = *scan.rays;
  const int step = std::max(1, (std::max(rays.rows(), rays.columns()) + most - 1) / std::max(1, most));
  return scanImage(scan, step, [&](std::size_t ray, QRgb surface) {
    return reasons[ray] == CutReason::Kept || reasons[ray] == CutReason::NoSample ? surface
                                                                                  : colourOf(reasons[ray]).rgb();
  });
}

}  // namespace vantage
