#include "geometry/mesh_union.h"

#include <cstdint>

namespace vantage {

Mesh together(std::span<const Mesh* const> meshes) {
  Mesh all;
  for (const Mesh* mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh->vertices.begin(), mesh->vertices.end());
    for (Triangle triangle : mesh->triangles) {
      for (std::uint32_t& corner : triangle) corner += first;
      all.triangles.push_back(triangle);
    }
  }
  return all;
}

}  // namespace vantage
