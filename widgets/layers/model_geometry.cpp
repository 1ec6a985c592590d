#include "layers/model_geometry.h"

#include <vtkPolyData.h>

#include <cstring>
#include <unordered_map>

#include "geometry/decimation.h"
#include "geometry/mesh_topology.h"

namespace vantage {
namespace {

struct PointHash {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::size_t hash = 0;
    for (const double c : p) hash = hash * 0x9E3779B97F4A7C15ULL + std::hash<double>()(c);
    return hash;
  }
};

std::array<double, 3> key(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

// Decimation keeps some of the vertices as they are: by their place they are found again.
std::vector<std::uint32_t> originsOf(const Mesh& coarse, const Mesh& fine) {
  std::unordered_map<std::array<double, 3>, std::uint32_t, PointHash> places;
  places.reserve(fine.vertices.size());
  for (std::size_t v = 0; v < fine.vertices.size(); ++v)
    places.emplace(key(fine.vertices[v]), static_cast<std::uint32_t>(v));
  std::vector<std::uint32_t> origins;
  origins.reserve(coarse.vertices.size());
  for (const Vec3& p : coarse.vertices) origins.push_back(places.at(key(p)));
  return origins;
}

vtkSmartPointer<vtkPolyData> boundaryLines(const Mesh& mesh) {
  std::vector<std::array<Vec3, 2>> lines;
  const MeshTopology topology(mesh);
  for (const BoundaryEdge& edge : topology.boundaryEdges())
    lines.push_back({mesh.vertices[edge.from], mesh.vertices[edge.to]});
  return toSegments(lines);
}

Rgb confidenceColour(float confidence) {
  return colourAt(ColourMap::Cividis, static_cast<double>(confidence));
}

}  // namespace

Rgb viewColour(std::size_t view) {
  return categoryColour(view);
}

Rgb ageColour(std::size_t view, std::size_t views) {
  return colourAt(ColourMap::Viridis, views > 1 ? static_cast<double>(view) / static_cast<double>(views - 1) : 1.0);
}

vtkSmartPointer<vtkPolyData> ModelGeometry::coloured(ModelColouring colouring, std::size_t views) const {
  std::vector<Rgb> colours;
  switch (colouring) {
    case ModelColouring::Plain:
      return surface;
    case ModelColouring::Confidence:
      for (const float c : model->confidence) colours.push_back(confidenceColour(c));
      return withPointColours(*surface, colours);
    case ModelColouring::View:
      for (const std::uint32_t view : model->triangleView) colours.push_back(viewColour(view));
      break;
    case ModelColouring::Age:
      for (const std::uint32_t view : model->triangleView) colours.push_back(ageColour(view, views));
      break;
  }
  return withCellColours(*surface, colours);
}

vtkSmartPointer<vtkPolyData> ModelGeometry::colouredCoarse(ModelColouring colouring, std::size_t views) const {
  if (colouring == ModelColouring::Plain || coarse == nullptr) return coarse;
  std::vector<Rgb> colours;
  for (const std::uint32_t v : coarseVertex) {
    if (colouring == ModelColouring::Confidence)
      colours.push_back(confidenceColour(model->confidence[v]));
    else if (colouring == ModelColouring::View)
      colours.push_back(viewColour(model->vertexView[v]));
    else
      colours.push_back(ageColour(model->vertexView[v], views));
  }
  return withPointColours(*coarse, colours);
}

std::shared_ptr<const ModelGeometry> prepareModelGeometry(std::shared_ptr<const Model> model,
                                                          const Progress& progress) {
  auto geometry = std::make_shared<ModelGeometry>();
  const Mesh& mesh = model->mesh;
  progress.checkpoint(0.0);
  geometry->surface = toPolyData(mesh, true);
  progress.checkpoint(0.3);
  geometry->boundary = boundaryLines(mesh);
  geometry->box = boundingBox(mesh);
  progress.checkpoint(0.6);
  geometry->caster = std::make_shared<const RayCaster>(mesh);
  geometry->model = std::move(model);
  progress.checkpoint(1.0);
  return geometry;
}

bool needsStandIn(const Model& model, const StandInOptions& options) {
  return model.mesh.triangles.size() > options.mostTriangles;
}

std::shared_ptr<const ModelGeometry> withStandIn(const std::shared_ptr<const ModelGeometry>& geometry,
                                                 const StandInOptions& options, const Progress& progress) {
  if (!needsStandIn(*geometry->model, options)) return geometry;
  const Mesh& mesh = geometry->model->mesh;
  DecimationOptions decimation;
  decimation.targetTriangles = options.targetTriangles;
  decimation.maxError = options.maxError;
  decimation.keepBoundary = false;
  const Mesh coarse = decimate(mesh, decimation, progress.part(0.0, 0.9));
  auto result = std::make_shared<ModelGeometry>(*geometry);
  result->coarse = toPolyData(coarse, true);
  result->coarseVertex = originsOf(coarse, mesh);
  progress.checkpoint(1.0);
  return result;
}

}  // namespace vantage
