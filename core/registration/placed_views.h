#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "registration/alignment.h"
#include "registration/view_network.h"

namespace vantage {

/// Where views found their places one after the other.
struct PlacedViews {
  std::vector<Pose> poses;           ///< one per view; those that failed as given
  std::vector<ViewAlignment> views;  ///< one per view
  std::vector<std::size_t> order;    ///< of the views placed; the first of them has its given pose
};

/// Brings views with rough poses together. From a first view on always the view that overlaps most with those placed
/// already is registered against their union, from its given pose and, where that is not good, from where the view
/// placed next to it was found to be; views that are placed for sure come before doubtful ones. What is left over
/// begins anew from another first view; the most views that hang together are the result, of as many those with the
/// earlier view.
/// @param given T_object_scanner, one per view
/// @throws InvalidInput as registerView, Cancelled
[[nodiscard]] PlacedViews placeViews(std::span<const PreparedView> views, std::span<const Pose> given,
                                     const AlignmentOptions& options, const Progress& progress);

}  // namespace vantage
