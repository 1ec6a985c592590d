#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "scanner/profile.h"
#include "scanner/range_image.h"

namespace vantage {

/// What is taken out of a scan before it is used, because it is not the object. By default nothing is.
struct CutOptions {
  bool volume = false;  ///< what lies outside of the viewing volume: the table, a wall
  /// [mm] What lies lower than this above the table plane is the table. Unset: half a sample spacing plus four standard
  /// deviations of the samples' noise, as far as the ray looks down.
  std::optional<double> tableMargin;
  double radiusMargin = 0.0;  ///< [mm] by which the cut is narrower than the viewing volume
  bool flyingPixels = false;  ///< samples between front and back of a depth edge
  /// Neighbours are apart by a jump when they are farther from each other than so many times what surface at the
  /// breakdown angle explains, beyond their noise.
  double flyingJump = 1.4;
  bool isolated = false;           ///< samples without a neighbour that is not a jump away
  std::size_t smallestIsland = 0;  ///< pieces of fewer samples are dropped; up to 1: none is
  bool operator==(const CutOptions&) const = default;
};

/// What suits a scanner that sees more than its object.
[[nodiscard]] CutOptions cutForRealScanners();

/// Whether nothing is ever cut.
[[nodiscard]] bool cutsNothing(const CutOptions& options);

/// Why a ray's sample is not used.
enum class CutReason : std::uint8_t {
  Kept,      ///< it is
  NoSample,  ///< there is none
  Table,     ///< inside the radius, lower than the margin above the table plane
  Outside,   ///< outside of the viewing volume's radius or height
  Flying,    ///< between front and back of a depth edge
  Isolated,  ///< no neighbour belongs to it
  Island,    ///< of a piece that is too small
};
inline constexpr std::size_t kCutReasons = 7;
/// "kept", "no_sample", "table", "outside", "flying", "isolated", "island".
[[nodiscard]] std::string_view name(CutReason reason);

/// What is known of a scanner and of what stands before it.
struct CutScene {
  std::optional<ViewingVolume> volume;    ///< unset: nothing lies outside
  double breakdownAngle = radians(60.0);  ///< [rad]
  double rangeSigma = 0.0;                ///< [mm] of the samples along the ray, at least; the image tells, too
};
[[nodiscard]] CutScene cutSceneOf(const ScannerProfile& profile);

/// How a scanner's images are cut.
struct ScanCut {
  CutScene scene;
  CutOptions options;
};

/// Standard deviation of the samples along their rays [mm], as the second differences of neighbours tell: the median of
/// the grid, so that edges do not count. 0 without three samples in a row.
/// @param counts per ray whether its sample counts; empty: all do
[[nodiscard]] double rangeSigmaOf(const RangeImage& image, std::span<const std::uint8_t> counts = {},
                                  const Progress& progress = {});

/// Why every ray's sample is not used, in this order: a sample outside of the viewing volume is one whatever else it
/// is. The volume stands on the table plane z = 0 about the z axis of the table's frame, see
/// RangeImage::T_table_scanner; of a scan whose place before the table nobody knows nothing lies outside.
///
/// A sample is flying when, along a row, a column or a diagonal of the grid, one neighbour is nearer and the opposite
/// one farther, both by a jump: surface up to the breakdown angle has none, and a rod before a wall has two that are
/// farther. Pieces are what hangs together in the grid without a jump, across one lost sample at most, once all others
/// are taken out.
/// @throws InvalidInput for a range image that is not one; Cancelled
[[nodiscard]] std::vector<CutReason> cutOf(const RangeImage& image, const ScanCut& cut, const Progress& progress = {});

/// How many rays are of each reason.
using CutCounts = std::array<std::size_t, kCutReasons>;
[[nodiscard]] CutCounts countsOf(std::span<const CutReason> reasons);
/// Of samples that were taken out.
[[nodiscard]] std::size_t cutSamples(const CutCounts& counts);

/// The image with no sample where one is cut. @pre a reason for every ray
[[nodiscard]] RangeImage withoutCut(const RangeImage& image, std::span<const CutReason> reasons);

/// An image that was cut, and how much of it.
struct CutImage {
  std::shared_ptr<const RangeImage> image;
  CutCounts counts{};  ///< all 0 where nothing is ever cut
};
/// The same image where nothing is cut. @throws InvalidInput for a range image that is not one; Cancelled
[[nodiscard]] CutImage cutImage(const std::shared_ptr<const RangeImage>& image, const ScanCut& cut,
                                const Progress& progress = {});

}  // namespace vantage
