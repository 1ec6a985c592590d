#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"

namespace vantage {

/// What keeps a surface from being printed as it is.
enum class PrintFault : std::uint8_t {
  Empty,        ///< no triangle
  Open,         ///< it has openings
  NonManifold,  ///< edges with more than two triangles, or with two that face opposite ways
  BowTies,      ///< vertices where surfaces only touch
  Inward,       ///< pieces that are turned inside out
  Crossings,    ///< triangles that pass through each other
  Pieces,       ///< more than one piece
};
/// "empty", "open", "non_manifold", "bow_ties", "inward", "crossings", "pieces".
[[nodiscard]] std::string_view name(PrintFault fault);

/// What a surface is, for printing.
struct PrintCheck {
  std::size_t openings = 0;
  double widestOpening = 0.0;  ///< [mm]
  std::size_t nonManifoldEdges = 0;
  std::size_t bowTies = 0;
  std::size_t crossings = 0;  ///< pairs of triangles
  std::size_t pieces = 0;
  std::size_t inwardPieces = 0;  ///< closed pieces with a negative volume
  std::optional<double> volume;  ///< [mm^3], where the surface is closed
  std::vector<PrintFault> faults;

  /// Whether it encloses a volume: no openings, and every edge has two triangles that agree.
  [[nodiscard]] bool closed() const { return volume.has_value(); }
  /// Whether nothing keeps it from being printed. Several pieces can be printed as well, but not as one.
  [[nodiscard]] bool printable() const { return faults.empty(); }
};

/// @throws InvalidInput when a triangle names a vertex that the mesh does not have; Cancelled
[[nodiscard]] PrintCheck checkForPrint(const Mesh& mesh, const Progress& progress = {});

/// The same surface, as far as it can be put right without making anything up: no triangle without three vertices,
/// every fan at a bow tie with a vertex of its own, and pieces turned so that their outside is outside.
struct RepairedSurface {
  Mesh mesh;
  std::vector<std::uint32_t> vertexOf;    ///< per vertex: the one that it was
  std::vector<std::uint32_t> triangleOf;  ///< per triangle: the one that it was
  std::size_t dropped = 0;                ///< triangles that were no surface
  std::size_t split = 0;                  ///< vertices that were added at bow ties
  std::size_t turned = 0;                 ///< triangles
};
[[nodiscard]] RepairedSurface repairForPrint(const Mesh& mesh, const Progress& progress = {});

}  // namespace vantage
