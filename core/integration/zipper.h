#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/progress.h"
#include "integration/model.h"
#include "integration/zipper_options.h"
#include "scanner/view.h"

namespace vantage {

/// What zippering did, in triangles unless said otherwise; sums over the views.
struct ZipperStatistics {
  std::size_t removedFromModel = 0;  ///< redundant: a newer view has seen it better
  std::size_t removedFromViews = 0;  ///< redundant: the model had it
  std::size_t added = 0;             ///< taken over from the views as they are
  std::size_t seam = 0;              ///< new, between the borders
  std::size_t slivers = 0;           ///< edges collapsed or flipped
  std::size_t holesClosed = 0;       ///< small holes
  std::size_t bowTies = 0;           ///< removed so that every vertex has one fan
  std::size_t islands = 0;           ///< removed because their piece was too small

  ZipperStatistics& operator+=(const ZipperStatistics& other);
};

struct Integration {
  Model model;
  ZipperStatistics statistics;
};

/// Adds views[newView] to a model that was made of other views (Turk & Levoy 1994): removes redundant surface on either
/// side, clips, stitches, removes slivers. Vertices are samples where the registered views put them: what later views
/// are added to; `applyConsensus` makes the geometry to publish. The model stays manifold and consistently oriented,
/// with boundaries where nothing was seen. An empty model becomes the view's mesh, made manifold.
///
/// A view that faces the surface far better than the model's own samples replaces them; else the model's stay, and the
/// view adds what lies beyond its border.
/// @param views by the model's provenance; with poses as the model has them (see `reposed`).
/// @throws InvalidInput when newView or the provenance names no view, or a view lacks its pieces; Cancelled
[[nodiscard]] Integration integrateView(const Model& model, std::span<const View> views, std::uint32_t newView,
                                        const ZipperOptions& options, const Progress& progress = {});

/// All views, one after the other, and mended at the end if the options say so.
[[nodiscard]] Integration zipper(std::span<const View> views, const ZipperOptions& options,
                                 const Progress& progress = {});

/// The model with every vertex where its sample lies under the views' present poses. Topology stays: for poses that a
/// refinement has moved by less than the sample spacing.
/// @throws InvalidInput when the provenance names no view or sample.
[[nodiscard]] Model reposed(const Model& model, std::span<const View> views);

}  // namespace vantage
