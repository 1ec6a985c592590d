#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "io/mesh_repair.h"
#include "scanner/length_unit.h"
#include "scanner/profile.h"

namespace vantage {

/// How a mesh gets into object coordinates (mm, z up, on the table plane z = 0, near the axis).
enum class Placement : std::uint8_t {
  AsIs,  ///< it is there already
  Fit,   ///< scaled and moved into the viewing volume
};

/// "as-is" or "fit". @throws InvalidInput for anything else.
[[nodiscard]] Placement parsePlacement(std::string_view text);
[[nodiscard]] std::string name(Placement placement);

/// p' = scale * p + translation. Axes stay as they are: a mesh with another axis up is scanned lying down.
struct PlacementTransform {
  double scale = 1.0;
  Vec3 translation = Vec3::Zero();  ///< [mm]
};

/// The share of the viewing volume's radius and height that a fitted object takes at most.
inline constexpr double kFittedShare = 0.9;

/// AsIs: the identity. Fit: the lowest vertex comes to stand on z = 0, the middle of the bounding box on the axis, and
/// the object is made as large as it can be inside a cylinder of kFittedShare times the volume's radius and height.
/// @throws InvalidInput when Fit is asked of a mesh without extent.
[[nodiscard]] PlacementTransform computePlacement(const Mesh& mesh, Placement placement, const ViewingVolume& volume);

[[nodiscard]] Mesh placed(Mesh mesh, const PlacementTransform& transform);

/// A mesh as a scanner will see it, and what was done to it.
struct PlacedMesh {
  Mesh mesh;  ///< in object coordinates
  MeshRepair repair;
  PlacementTransform transform;
};

/// How the file of an object is read.
struct PlacementOptions {
  Placement placement = Placement::AsIs;
  std::optional<double> unit;  ///< millimetres in a unit of the file; unset: 1
};

/// Reads a mesh and places it. @throws as loadMesh and computePlacement
[[nodiscard]] PlacedMesh loadPlacedMesh(const std::string& path, const PlacementOptions& options,
                                        const ViewingVolume& volume, const Progress& progress = {});

/// A unit in which a mesh would be an object for a scanner, and its longest side in it.
struct PossibleUnit {
  LengthUnit unit = LengthUnit::Millimetre;
  double size = 0.0;     ///< [mm]
  double samples = 0.0;  ///< of the scanner across it
};

/// When a mesh that is taken as millimetres is so small that fewer than ten samples of the scanner lie across it: the
/// units in which it has more and fits into the viewing volume, that as millimetres first. Empty for every other mesh,
/// and when no unit would do.
[[nodiscard]] std::vector<PossibleUnit> unitsInDoubt(const Mesh& mesh, const ScannerProfile& profile);

/// @throws InvalidInput naming file, sizes and option when no unit was given and unitsInDoubt has some for a mesh that
/// stays as it is
void requireClearUnit(const std::string& path, const PlacementOptions& options, const Mesh& mesh,
                      const ScannerProfile& profile);

/// Whether every vertex lies in the viewing volume, with `slack` [mm] to spare on all sides.
[[nodiscard]] bool isInside(const Mesh& mesh, const ViewingVolume& volume, double slack = 0.5);

}  // namespace vantage
