#pragma once

#include <string>
#include <vector>

#include "positional_space/positional_image.h"
#include "scanner/profile.h"

namespace vantage::testing {

/// Small scanners on turntables, one of each kind, with the viewing volume 150 x 300 mm.
[[nodiscard]] ScannerProfile rotatingStripe(int steps = 45);
[[nodiscard]] ScannerProfile linearStripe(int steps = 45);
[[nodiscard]] ScannerProfile pinhole(int steps = 45);
/// The pinhole's rays as a table.
[[nodiscard]] ScannerProfile rayTable(int steps = 45);
/// A pinhole that looks at the volume from several tilts [deg].
[[nodiscard]] ScannerProfile tiltedPinhole(const std::string& tilts, int steps = 45);

/// One of every kind.
[[nodiscard]] std::vector<ScannerProfile> everyKind();

/// Sources spread over a cylinder about the middle of the volume [mm], with all kinds of normals.
[[nodiscard]] std::vector<ObservationSource> scatteredSources(int count, double radius = 110.0,
                                                              double halfHeight = 90.0);

/// One source per triangle: centre, normal and area. Degenerate triangles have weight 0.
[[nodiscard]] std::vector<ObservationSource> sourcesOf(const Mesh& mesh);

}  // namespace vantage::testing
