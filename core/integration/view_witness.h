#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "integration/consensus.h"
#include "integration/grid_surface.h"

namespace vantage {

/// What a view says about a place of a model.
struct Opinion {
  double offset = 0.0;  ///< of its surface from the place, along the normal there [mm]
  double weight = 0.0;  ///< 0: it has no say
  double confidence = 0.0;
  GridContact contact{};  ///< on its mesh, where it has a say
};

/// A view as the consensus asks it.
class ViewWitness {
 public:
  /// @throws InvalidInput when the view has no image or no mesh
  ViewWitness(const View& view, const ConsensusOptions& options);

  /// About a vertex and the unit normal there, in object coordinates. `hint` is where the vertex before was found in
  /// the view's grid, and becomes where this one is.
  [[nodiscard]] Opinion ask(const Vec3& vertex, const Vec3& normal, std::optional<GridPosition>& hint) const;

  [[nodiscard]] const GridSurface& surface() const { return surface_; }

 private:
  GridSurface surface_;
  double maxOffset_;
  double minNormalCosine_;
  double leastFacing_;
};

/// One per view, in their order. @throws InvalidInput when a view has no image or no mesh, Cancelled
[[nodiscard]] std::vector<ViewWitness> witnessesOf(std::span<const View> views, const ConsensusOptions& options,
                                                   const Progress& progress);

}  // namespace vantage
