#pragma once

#include <cstdint>
#include <span>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "geometry/mesh.h"
#include "scanner/length_unit.h"

namespace vantage {

/// Writes a mesh as 3MF (Core Specification 1.2): one object of one model in the unit that is said, coordinates in
/// single precision. The same mesh is the same file. The file is not committed.
/// @param invented per triangle 1 where it is invented, or none: such triangles have a material of their own
/// @pre the unit is one that 3MF knows: all of LengthUnit are
/// @throws InvalidInput when a coordinate is not finite or the file would become larger than 4 GB; IoError, Cancelled
void writeThreeMf(const Mesh& mesh, std::span<const std::uint8_t> invented, LengthUnit unit, AtomicFile& file,
                  const Progress& progress = {});

}  // namespace vantage
