#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "io/mesh_repair.h"

namespace vantage {

struct MeshReadOptions {
  std::size_t maxUnpackedBytes = 1ULL << 30;  ///< a zipped mesh (3MF) that unpacks to more is refused
};

/// A mesh that can be scanned, and what was done to it.
struct LoadedMesh {
  Mesh mesh;           ///< in the axes of the file and its units, which are taken as millimetres; 3MF is converted
  std::string format;  ///< "ply", "stl", ...
  MeshRepair repair;
};

/// Reads a mesh in PLY, STL, OBJ, OFF or 3MF with readers of our own, in any other format with assimp (in a child
/// process, see importWithAssimp), and repairs it (see repairedMesh).
/// @throws IoError when the file is missing, a folder, empty, larger than kMaxFileBytes or cannot be read
/// @throws InvalidInput in one sentence with file, place and expectation when it is damaged, is something else, or has
/// no
///         usable triangle (points only, everything dropped)
/// @throws Cancelled
[[nodiscard]] LoadedMesh loadMesh(const std::string& path, const MeshReadOptions& options = {},
                                  const Progress& progress = {});

/// Extensions of the files that loadMesh reads, lower case without the dot, in alphabetical order.
[[nodiscard]] std::vector<std::string> readableMeshExtensions();

}  // namespace vantage
