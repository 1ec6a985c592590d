#pragma once

#include "io/file_bytes.h"
#include "io/polygon_soup.h"

namespace vantage {

/// Reads Wavefront OBJ: v and f with any corner form, relative indices and line continuations; other keywords are
/// skipped. Texture coordinates and normals are only checked to exist, and only if the file has any. Text may be
/// UTF-16. What only concerns one polygon (a vertex that does not exist, a coordinate that is no number) is left in the
/// soup for the repair to drop and count.
/// @throws InvalidInput naming file, line (or byte) and what was expected, when the file is damaged or something else
/// @throws Cancelled
[[nodiscard]] PolygonSoup readObjSoup(const FileBytes& file, const Progress& progress = {});

}  // namespace vantage
