#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/progress.h"
#include "integration/model.h"
#include "integration/vertex_colours.h"
#include "scanner/length_unit.h"

namespace vantage {

// All writers: the file appears whole or not at all, and what was there before stays when writing fails.
// @throws InvalidInput for an unknown extension, or a mesh with an index out of range
// @throws IoError when it cannot be written (no such folder, disk full, ...)
// @throws Cancelled

/// Writes a model in the format that the extension names: .ply (binary little endian: vertices float x y z confidence,
/// faces uchar/int list vertex_indices and int view), .stl (binary) or .obj. Coordinates in single precision,
/// millimetres; or .3mf (3MF core specification, deflated).
/// @param offset is added to every vertex; with one, PLY and OBJ have double precision. STL, which has single precision
///        only, and 3MF, which is for printing, are written without: the header of STL says so.
/// @param colours of the vertices, or none; in PLY as uchar red, green and blue after the confidence, in OBJ as shares
///        of 1 after the coordinates. STL and 3MF have none. What has no colour is kGrey: a comment in PLY says how
///        many are.
void exportModel(const Model& model, const std::string& path, const Progress& progress = {},
                 const Vec3& offset = Vec3::Zero(), const VertexColours& colours = {});

/// How a model is written that was made ready to be handed over.
struct ExportOptions {
  Vec3 offset = Vec3::Zero();                      ///< [mm]
  std::span<const std::optional<Colour>> colours;  ///< of the vertices, or none
  /// Per vertex 1 where it is invented, or none: the property `invented` (uchar) of a PLY, where triangles that are
  /// invented have the view -1, and a material of its own in 3MF. STL and OBJ do not tell.
  std::span<const std::uint8_t> invented;
  /// Of the coordinates: millimetres or inches. 3MF says which; PLY, STL and OBJ in a comment.
  LengthUnit unit = LengthUnit::Millimetre;
};
/// Writes a model likewise. Triangles that are invented have the view kNoIndex.
void exportModelAs(const Model& model, const std::string& path, const ExportOptions& options,
                   const Progress& progress = {});

/// Whether a file of that name tells what is invented.
[[nodiscard]] bool holdsInvented(const std::string& path);

/// Whether a file of that name can hold an offset.
[[nodiscard]] bool holdsOffset(const std::string& path);
/// Or colours.
[[nodiscard]] bool holdsColours(const std::string& path);

/// Writes a mesh likewise, without confidence and view.
void exportMesh(const Mesh& mesh, const std::string& path, const Progress& progress = {});

}  // namespace vantage
