#pragma once

#include "io/file_bytes.h"
#include "io/polygon_soup.h"

namespace vantage {

// Own strict readers of the formats that operators bring. What only concerns one polygon (a vertex that does not exist,
// a coordinate that is no number) is left in the soup for the repair to drop and count; what says that the file is
// damaged or something else throws. All of them:
// @throws InvalidInput naming file, line (or byte) and what was expected
// @throws Cancelled

/// PLY with the elements vertex {x y z} and, unless it holds points only, face {vertex_indices | vertex_index} or
/// tristrips {vertex_indices}.
[[nodiscard]] PolygonSoup readPlySoup(const FileBytes& file, const Progress& progress = {});

/// STL, binary or ASCII (told by size and content, not by the word solid). Binary: the size must be the one that its
/// triangle count asks for. ASCII: every solid must be closed by endsolid, else the file is truncated.
[[nodiscard]] PolygonSoup readStlSoup(const FileBytes& file, const Progress& progress = {});

/// Wavefront OBJ: v and f with any corner form, relative indices and line continuations; other keywords are skipped.
/// Texture coordinates and normals are only checked to exist, and only if the file has any. Text may be UTF-16.
[[nodiscard]] PolygonSoup readObjSoup(const FileBytes& file, const Progress& progress = {});

/// OFF in text form with any of the prefixes ST, C, N before OFF; one vertex and one face per line.
[[nodiscard]] PolygonSoup readOffSoup(const FileBytes& file, const Progress& progress = {});

/// 3MF: the objects of the build, with their components, transformed and in millimetres. Materials, slices, beams and
/// other extensions are skipped; a file that requires an unknown extension is refused.
/// @param maxUnpacked limit of what the archive may unpack to [bytes].
[[nodiscard]] PolygonSoup readThreeMfSoup(const FileBytes& file, std::uintmax_t maxUnpacked,
                                          const Progress& progress = {});

}  // namespace vantage
