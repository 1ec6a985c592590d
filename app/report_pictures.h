#pragma once

#include <QImage>
#include <functional>
#include <vector>

#include "report/html_report.h"
#include "scanner/range_image.h"

namespace vantage {

/// The picture of a scan, upright: bright where the surface faces the scanner.
/// @param step every so many rows and columns of ranging rays there is a pixel
/// @param repaint gets every ray that has a sample, and its colour; what it returns is shown. Empty: as it is.
[[nodiscard]] QImage scanImage(const RangeImage& scan, int step = 1,
                               const std::function<QRgb(std::size_t ray, QRgb surface)>& repaint = {});

/// Pictures of all scans of a state, one per view.
[[nodiscard]] std::vector<ReportPicture> scanPictures(const AcquisitionState& state);

/// How the object stood in each stand, on the table and as far as it was known then or is now; none for an object that
/// was not turned over. Drawn without a graphics card, on any thread.
[[nodiscard]] std::vector<ReportPicture> standPictures(const AcquisitionState& state);

/// A picture as the bytes of a PNG file.
[[nodiscard]] ReportPicture toReportPicture(const QImage& image, const QString& caption);

}  // namespace vantage
