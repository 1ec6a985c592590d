#pragma once

#include <QImage>
#include <vector>

#include "report/html_report.h"
#include "scanner/range_image.h"

namespace vantage {

/// The picture of a scan, one pixel per ranging ray, upright: bright where the surface faces the scanner.
[[nodiscard]] QImage scanImage(const RangeImage& scan);

/// Pictures of all scans of a state, one per view.
[[nodiscard]] std::vector<ReportPicture> scanPictures(const AcquisitionState& state);

/// A picture as the bytes of a PNG file.
[[nodiscard]] ReportPicture toReportPicture(const QImage& image, const QString& caption);

}  // namespace vantage
