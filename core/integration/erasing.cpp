#include "integration/erasing.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/errors.h"
#include "base/parallel.h"
#include "geometry/mesh_border.h"
#include "geometry/mesh_topology.h"
#include "integration/manifold.h"
#include "integration/model_editor.h"

namespace vantage {
namespace {

constexpr std::size_t kErasingGrain = 4096;
// What lies beyond an edge begins no farther away than an edge of the triangle that was beside it, and those are not
// longer than so many spacings where surface is as steep as a scanner can see.
constexpr double kBesideSpacings = 2.0;

int standOf(const View& view) {
  return view.image->station.stand;
}

void checkVertexViews(const Model& model, std::span<const View> views) {
  if (model.vertexView.size() != model.mesh.vertices.size())
    throw InvalidInput("model of " + std::to_string(model.mesh.vertices.size()) +
                       " vertices whose provenance is not complete");
  for (const std::uint32_t view : model.vertexView)
    if (view >= views.size())
      throw InvalidInput("model: a vertex is of view " + std::to_string(view) + " of " + std::to_string(views.size()));
}

// Per vertex of a view's mesh.
std::vector<std::uint8_t> erasedVertices(const View& view, const ErasedSpace& space) {
  const std::vector<Vec3>& vertices = view.mesh->mesh.vertices;
  std::vector<std::uint8_t> erased(vertices.size(), 0);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    erased[v] = space.holds(standOf(view), view.T_object_scanner * vertices[v]) ? 1 : 0;
  return erased;
}

bool anyOf(const Triangle& t, const std::vector<std::uint8_t>& marked) {
  return (marked[t[0]] | marked[t[1]] | marked[t[2]]) != 0;
}

}  // namespace

void ErasedSpace::add(int stand, std::shared_ptr<const RegionProbe> region, const Pose& T_object_table) {
  const bool moved = T_object_table.matrix() != Pose::Identity().matrix();
  regions_.push_back({stand, std::move(region), T_object_table.inverse(), moved});
}

bool ErasedSpace::isIn(int stand) const {
  return std::any_of(regions_.begin(), regions_.end(), [&](const Placed& r) { return r.stand == stand; });
}

bool ErasedSpace::holds(int stand, const Vec3& p, double margin) const {
  return std::any_of(regions_.begin(), regions_.end(), [&](const Placed& r) {
    return r.stand == stand && r.region->holds(r.moved ? r.T_table_object * p : p, margin);
  });
}

std::vector<std::uint8_t> erasedTriangles(const Model& model, std::span<const View> views, const ErasedSpace& space,
                                          const Progress& progress) {
  checkVertexViews(model, views);
  std::vector<std::uint8_t> vertices(model.mesh.vertices.size(), 0);
  parallelChunks(vertices.size(), kErasingGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      vertices[v] = space.holds(standOf(views[model.vertexView[v]]), model.mesh.vertices[v]) ? 1 : 0;
  });
  std::vector<std::uint8_t> erased;
  erased.reserve(model.mesh.triangles.size());
  for (const Triangle& t : model.mesh.triangles) erased.push_back(anyOf(t, vertices) ? 1 : 0);
  return erased;
}

Model withoutErased(const Model& model, std::span<const View> views, const ErasedSpace& space,
                    const Progress& progress) {
  if (space.empty()) return model;
  const std::vector<std::uint8_t> erased = erasedTriangles(model, views, space, progress);
  if (std::none_of(erased.begin(), erased.end(), [](std::uint8_t mark) { return mark != 0; })) return model;
  ModelEditor editor(model);
  for (std::uint32_t t = 0; t < erased.size(); ++t)
    if (erased[t] != 0) editor.removeTriangle(t);
  resolveBowTies(editor, {});
  return std::move(editor).take();
}

View withoutErased(const View& view, const ErasedSpace& space) {
  if (!space.isIn(standOf(view))) return view;
  const ViewMesh& whole = *view.mesh;
  const std::vector<std::uint8_t> erased = erasedVertices(view, space);
  if (std::none_of(erased.begin(), erased.end(), [](std::uint8_t mark) { return mark != 0; })) return view;
  auto left = std::make_shared<ViewMesh>();
  left->mesh.vertices = whole.mesh.vertices;
  for (const Triangle& t : whole.mesh.triangles)
    if (!anyOf(t, erased)) left->mesh.triangles.push_back(t);
  const std::vector<std::uint32_t> newIndex = removeUnusedVertices(left->mesh);
  left->vertexOfSample.assign(whole.vertexOfSample.size(), kNoIndex);
  for (std::size_t v = 0; v < newIndex.size(); ++v) {
    if (newIndex[v] == kNoIndex) continue;
    left->sample.push_back(whole.sample[v]);
    left->normals.push_back(whole.normals[v]);
    left->confidence.push_back(whole.confidence[v]);
    left->vertexOfSample[whole.sample[v]] = newIndex[v];
  }
  left->onBoundary = borderVertices(left->mesh);
  left->spacing = whole.spacing;
  return {view.image, std::move(left), view.T_object_scanner};
}

Mesh erasedSurface(std::span<const View> views, int stand, const ErasedSpace& space, std::vector<float>* confidence) {
  Mesh surface;
  if (!space.isIn(stand)) return surface;
  for (const View& view : views) {
    if (standOf(view) != stand) continue;
    const std::vector<std::uint8_t> erased = erasedVertices(view, space);
    const ViewMesh& seen = *view.mesh;
    std::vector<std::uint32_t> index(seen.mesh.vertices.size(), kNoIndex);
    for (Triangle t : seen.mesh.triangles) {
      if (!anyOf(t, erased)) continue;
      for (std::uint32_t& v : t) {
        if (index[v] == kNoIndex) {
          index[v] = static_cast<std::uint32_t>(surface.vertices.size());
          surface.vertices.push_back(view.T_object_scanner * seen.mesh.vertices[v]);
          if (confidence != nullptr) confidence->push_back(seen.confidence[v]);
        }
        v = index[v];
      }
      surface.triangles.push_back(t);
    }
  }
  return surface;
}

std::vector<std::uint8_t> erasedBorder(const Model& model, std::span<const View> views, int stand,
                                       const ErasedSpace& space) {
  if (!space.isIn(stand)) return {};
  checkVertexViews(model, views);
  const std::vector<Vec3>& vertices = model.mesh.vertices;
  std::vector<std::uint8_t> border(vertices.size(), 0);
  const MeshTopology topology(model.mesh);
  for (const BoundaryEdge& edge : topology.boundaryEdges()) {
    const Triangle& t = model.mesh.triangles[edge.triangle];
    double reach = 0.0;
    for (int k = 0; k < 3; ++k) reach = std::max(reach, (vertices[t[k]] - vertices[t[(k + 1) % 3]]).norm());
    for (const std::uint32_t v : {edge.from, edge.to}) {
      const double beside = std::max(reach, kBesideSpacings * views[model.vertexView[v]].mesh->spacing);
      if (border[v] == 0 && space.holds(stand, vertices[v], beside)) border[v] = 1;
    }
  }
  return border;
}

}  // namespace vantage
