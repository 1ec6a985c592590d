#pragma once

#include <string>

#include "base/progress.h"
#include "integration/model.h"
#include "integration/vertex_colours.h"

namespace vantage {

// All writers: the file appears whole or not at all, and what was there before stays when writing fails.
// @throws InvalidInput for an unknown extension, or a mesh with an index out of range
// @throws IoError when it cannot be written (no such folder, disk full, ...)
// @throws Cancelled

/// Writes a model in the format that the extension names: .ply (binary little endian: vertices float x y z confidence,
/// faces uchar/int list vertex_indices and int view), .stl (binary) or .obj. Coordinates in single precision,
/// millimetres.
/// @param offset is added to every vertex; with one, PLY and OBJ have double precision. STL, which has single precision
///        only, is written without: its header says so.
/// @param colours of the vertices, or none; in PLY as uchar red, green and blue after the confidence, in OBJ as shares
///        of 1 after the coordinates. STL has none. What has no colour is kGrey: a comment in PLY says how many are.
void exportModel(const Model& model, const std::string& path, const Progress& progress = {},
                 const Vec3& offset = Vec3::Zero(), const VertexColours& colours = {});

/// Whether a file of that name can hold an offset.
[[nodiscard]] bool holdsOffset(const std::string& path);
/// Or colours.
[[nodiscard]] bool holdsColours(const std::string& path);

/// Writes a mesh likewise, without confidence and view.
void exportMesh(const Mesh& mesh, const std::string& path, const Progress& progress = {});

}  // namespace vantage
