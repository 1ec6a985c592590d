#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "registration/multi_view.h"
#include "registration/pair_finding.h"
#include "registration/registration_scale.h"

namespace vantage {

/// A view as multi-view registration works with it, wherever its pose is. Copies share what they are made of.
struct PreparedView {
  std::shared_ptr<const RangeImage> image;
  std::shared_ptr<const ViewMesh> mesh;
  ViewSurface surface;
  OrientedVertices points;  ///< inside the border, scanner coordinates

  /// @pre the view has its pieces
  explicit PreparedView(const View& view);
};

/// That of all views together.
[[nodiscard]] RegistrationScale scaleOf(std::span<const PreparedView> views);

/// @throws Cancelled
[[nodiscard]] std::vector<PreparedView> prepareViews(std::span<const View> views, const Progress& progress);

/// Two views that overlap: points of one are looked up on the other.
struct ViewLink {
  std::size_t from = 0;
  std::size_t to = 0;
  std::vector<std::uint32_t> ids;  ///< of points of `from`
  std::vector<std::optional<GridPosition>> positions;
  std::vector<Pair> pairs;  ///< in scanner coordinates of `to`
};

/// Share of the points of view `from` (about `count` are tried) that meet view `to`.
[[nodiscard]] double overlapShare(const PreparedView& from, const PreparedView& to, const Pose& T_to_from,
                                  const PairGates& gates, std::size_t count);

/// Ordered pairs of views that share at least `minOverlap` of the first one's points, with about `points` ids in all,
/// evenly shared but at least `leastPoints` each, of points that the second view sees.
/// @throws Cancelled
[[nodiscard]] std::vector<ViewLink> findLinks(std::span<const PreparedView> views, std::span<const Pose> poses,
                                              const PairGates& gates, double minOverlap, std::size_t points,
                                              std::size_t leastPoints, const Progress& progress);

/// Looks up the points of all links anew. @throws Cancelled
void findPairs(std::span<const PreparedView> views, std::span<const Pose> poses, const PairGates& gates,
               const Progress& progress, std::vector<ViewLink>& links);

/// Robust deviation of all links' pairs [mm].
[[nodiscard]] double deviation(std::span<const ViewLink> links);

/// RMS over all points that should have a partner, distances beyond the gate counting as the gate [mm].
[[nodiscard]] double robustRms(std::span<const ViewLink> links, double gate);

}  // namespace vantage
