#pragma once

#include <QColor>
#include <QImage>
#include <span>

#include "scanner/scan_cut.h"

namespace vantage {

/// The colour in which samples that are cut for a reason are shown.
[[nodiscard]] QColor colourOf(CutReason reason);

/// The picture of a scan, upright, one pixel per ranging ray: what is kept as bright as it faces the scanner, what is
/// cut in the colour of its reason.
/// @param reasons one for every ray
/// @param most pixels along either side; of finer grids every n-th row and column is shown
[[nodiscard]] QImage cutPicture(const RangeImage& scan, std::span<const CutReason> reasons, int most = 640);

}  // namespace vantage
