#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "finishing/hole_closing.h"
#include "finishing/print_check.h"
#include "finishing/simplification.h"
#include "integration/model.h"
#include "integration/vertex_colours.h"

namespace vantage {

/// What is done to a model before it is handed over. Nothing of it is kept in the session.
struct FinishingOptions {
  /// [mm^2] Loose pieces up to this area are left out; infinite: all but the largest piece. Unset: none.
  std::optional<double> leaveOut = {};
  std::optional<HoleClosingOptions> close = {};        ///< unset: openings stay
  std::optional<SimplificationOptions> simplify = {};  ///< unset: every triangle stays
  bool repair = false;  ///< for printing: bow ties are split and pieces turned so that their outside is outside

  [[nodiscard]] bool nothing() const { return !leaveOut && !close && !simplify && !repair; }
};

/// A model that is handed over, and what was done to it.
struct FinishedModel {
  /// Vertices and triangles that are invented have the view kNoIndex, and confidence 0.
  Model model;
  std::vector<std::uint32_t> vertexOf;  ///< per vertex: the one of the model before; kNoIndex where it is invented
  std::size_t piecesLeftOut = 0;
  double areaLeftOut = 0.0;  ///< [mm^2]
  std::size_t trianglesTurned = 0;
  std::vector<ClosedOpening> closed;
  std::vector<OpeningLeft> left;             ///< openings that stayed, when some were to be closed
  std::optional<SimplifiedMesh> simplified;  ///< without its mesh, when it was simplified
  double measuredArea = 0.0;                 ///< [mm^2]
  double inventedArea = 0.0;                 ///< [mm^2]
  PrintCheck check;                          ///< of what it is now

  /// 1 for the vertices that are invented; empty when none is.
  [[nodiscard]] std::vector<std::uint8_t> invented() const;
  /// The colours of the model before, for the vertices that it has now; what is invented has none.
  [[nodiscard]] VertexColours coloursOf(const VertexColours& before) const;
};

/// Leaves out loose pieces, puts right what can be put right, closes openings and simplifies, in this order.
/// @throws InvalidInput for limits that are none or a model without surface; Cancelled
[[nodiscard]] FinishedModel finish(const Model& model, const FinishingOptions& options, const Progress& progress = {});

}  // namespace vantage
