#include "geometry/mesh_border.h"

#include <algorithm>
#include <array>

#include "base/content_hash.h"

namespace vantage {

// About a vertex inside the surface every neighbour follows in one triangle and precedes in another: the hashes of
// those that follow less those of the ones that precede sum up to nothing.
std::vector<std::uint8_t> borderVertices(const Mesh& mesh) {
  std::vector<std::uint64_t> open(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    std::array<std::uint64_t, 3> code{};
    for (std::size_t k = 0; k < 3; ++k)
      code[k] = mixedBits((static_cast<std::uint64_t>(t[k]) + 1) * 0x9e3779b97f4a7c15ULL);
    for (std::size_t k = 0; k < 3; ++k) open[t[k]] += code[(k + 1) % 3] - code[(k + 2) % 3];
  }
  std::vector<std::uint8_t> border(open.size());
  std::transform(open.begin(), open.end(), border.begin(), [](std::uint64_t sum) { return sum != 0 ? 1 : 0; });
  return border;
}

}  // namespace vantage
