#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "finishing/border_loops.h"
#include "geometry/mesh.h"

namespace vantage {

struct HoleClosingOptions {
  std::optional<double> maxWidth = {};  ///< [mm] wider openings stay open; unset: none does
  /// Only these openings, by their places in borderLoops; unset: all.
  std::optional<std::vector<std::size_t>> only = {};
  /// [mm] Edges of what fills an opening are about as long; unset: as those of its border.
  std::optional<double> spacing = {};
  /// Within so many edges of its border a lid continues the surface around it, farther inside it is as tight as a soap
  /// film.
  double reachInEdges = 10.0;
  /// A wide opening is filled with longer edges rather than with more triangles than about this.
  std::size_t mostTriangles = 100'000;
};

/// Why an opening is still one.
enum class StaysOpen : std::uint8_t {
  TooWide,    ///< wider than the limit
  NotAsked,   ///< not among those to be closed
  NoFilling,  ///< its border cannot be spanned
};
/// "too_wide", "not_asked", "no_filling".
[[nodiscard]] std::string_view name(StaysOpen reason);

/// An opening that was closed.
struct ClosedOpening {
  std::size_t opening = 0;    ///< its place in borderLoops
  std::size_t edges = 0;      ///< of its border
  double width = 0.0;         ///< [mm]
  double area = 0.0;          ///< of what fills it [mm^2]
  std::size_t crossings = 0;  ///< times that a triangle of it passes through another
};

struct OpeningLeft {
  std::size_t opening = 0;
  std::size_t edges = 0;
  double width = 0.0;  ///< [mm]
  StaysOpen reason = StaysOpen::TooWide;
};

/// A surface with lids. What was there keeps its place and number; what is invented follows.
struct ClosedMesh {
  Mesh mesh;
  std::uint32_t firstInventedVertex = 0;
  std::uint32_t firstInventedTriangle = 0;
  /// Per vertex from firstInventedVertex on: the measured vertex at the same place where it is a copy of one (bow ties
  /// are split), or kNoIndex where it is invented.
  std::vector<std::uint32_t> copyOf;
  std::vector<ClosedOpening> closed;
  std::vector<OpeningLeft> left;

  [[nodiscard]] double inventedArea() const;  ///< [mm^2]
  [[nodiscard]] std::size_t crossings() const;
};

/// Closes openings of a surface with smooth lids (Liepa, Filling Holes in Meshes, 2003): the border is triangulated,
/// the triangles are refined to the spacing around and moved to where the surface goes on. A lid that would pass
/// through the surface, or through another, is drawn tighter. The lids are made up: nothing of them was measured.
/// @throws InvalidInput when an edge has more than two triangles, neighbours do not agree in orientation, or a triangle
/// names a vertex that is not there; Cancelled
[[nodiscard]] ClosedMesh closeHoles(const Mesh& mesh, const HoleClosingOptions& options, const Progress& progress = {});

}  // namespace vantage
