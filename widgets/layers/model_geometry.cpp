#include "layers/model_geometry.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "acquisition/model_colours.h"
#include "geometry/mesh_topology.h"

namespace vantage {
namespace {

using Place = std::array<float, 3>;

struct PlaceHash {
  std::size_t operator()(const Place& p) const {
    std::size_t hash = 0;
    for (const float c : p) hash = hash * 0x9E3779B97F4A7C15ULL + std::hash<float>()(c);
    return hash;
  }
};

Place placeOf(const Vec3& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

// A clustered mesh: in every cube of a grid that the surface passes through, one of its vertices stands for all.
vtkSmartPointer<vtkPolyData> clustered(vtkPolyData& surface, const BoundingBox& box, double cell) {
  const auto clustering = vtkSmartPointer<vtkQuadricClustering>::New();
  const auto cells = [&](int axis) { return std::max(2, static_cast<int>(std::ceil(box.size()[axis] / cell))); };
  // With points and cells of its own: what walks along them keeps notes in them, and the surface may be being drawn.
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(surface.GetPoints()->GetData());
  const auto triangles = vtkSmartPointer<vtkCellArray>::New();
  triangles->ShallowCopy(surface.GetPolys());
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(points);
  copy->SetPolys(triangles);
  clustering->SetInputData(copy);
  clustering->SetNumberOfDivisions(cells(0), cells(1), cells(2));
  clustering->AutoAdjustNumberOfDivisionsOff();
  clustering->UseInputPointsOn();
  clustering->Update();
  return clustering->GetOutput();
}

// The clustered mesh as one of ours, with the model's vertex that each of its vertices is, found by its place.
std::pair<Mesh, std::vector<std::uint32_t>> withOrigins(vtkPolyData& coarse, const Mesh& fine) {
  std::unordered_map<Place, std::uint32_t, PlaceHash> places;
  places.reserve(fine.vertices.size());
  for (std::size_t v = 0; v < fine.vertices.size(); ++v)
    places.emplace(placeOf(fine.vertices[v]), static_cast<std::uint32_t>(v));
  std::pair<Mesh, std::vector<std::uint32_t>> result;
  for (vtkIdType i = 0; i < coarse.GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    coarse.GetPoint(i, p.data());
    const std::uint32_t origin = places.at(placeOf(Vec3(p[0], p[1], p[2])));
    result.first.vertices.push_back(fine.vertices[origin]);
    result.second.push_back(origin);
  }
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  const auto cells = vtkSmartPointer<vtkCellArrayIterator>::Take(coarse.GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    cells->GetCurrentCell(count, corners);
    if (count == 3)
      result.first.triangles.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
                                        static_cast<std::uint32_t>(corners[2])});
  }
  return result;
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

Rgb standColour(int stand) {
  return categoryColour(static_cast<std::size_t>(stand));
}

ModelColouring ModelGeometry::shown(std::optional<ModelColouring> asked) const {
  const ModelColouring wanted = asked.value_or(ModelColouring::Colours);
  return wanted == ModelColouring::Colours && colours.empty() ? ModelColouring::Plain : wanted;
}

vtkSmartPointer<vtkPolyData> ModelGeometry::coloured(ModelColouring colouring, std::span<const int> stands) const {
  std::vector<Rgb> painted;
  switch (colouring) {
    case ModelColouring::Plain:
      return surface;
    case ModelColouring::Confidence:
      for (const float c : model->confidence) painted.push_back(confidenceColour(c));
      return withPointColours(*surface, painted);
    case ModelColouring::View:
      for (const std::uint32_t view : model->triangleView) painted.push_back(viewColour(view));
      break;
    case ModelColouring::Age:
      for (const std::uint32_t view : model->triangleView) painted.push_back(ageColour(view, stands.size()));
      break;
    case ModelColouring::Stand:
      for (const std::uint32_t view : model->triangleView) painted.push_back(standColour(stands[view]));
      break;
    case ModelColouring::Colours:
      for (const auto& colour : colours) painted.push_back(colour.value_or(kGrey));
      return withPointColours(*surface, painted);
  }
  return withCellColours(*surface, painted);
}

vtkSmartPointer<vtkPolyData> ModelGeometry::colouredCoarse(ModelColouring colouring,
                                                           std::span<const int> stands) const {
  if (colouring == ModelColouring::Plain || coarse == nullptr) return coarse;
  std::vector<Rgb> painted;
  for (const std::uint32_t v : coarseVertex) {
    if (colouring == ModelColouring::Confidence)
      painted.push_back(confidenceColour(model->confidence[v]));
    else if (colouring == ModelColouring::View)
      painted.push_back(viewColour(model->vertexView[v]));
    else if (colouring == ModelColouring::Colours)
      painted.push_back(colours[v].value_or(kGrey));
    else if (colouring == ModelColouring::Stand)
      painted.push_back(standColour(stands[model->vertexView[v]]));
    else
      painted.push_back(ageColour(model->vertexView[v], stands.size()));
  }
  return withPointColours(*coarse, painted);
}

std::shared_ptr<const ModelGeometry> prepareSurface(std::shared_ptr<const Model> model) {
  auto geometry = std::make_shared<ModelGeometry>();
  geometry->surface = toPolyData(model->mesh, true);
  geometry->box = boundingBox(model->mesh);
  geometry->model = std::move(model);
  return geometry;
}

std::shared_ptr<const ModelGeometry> withPicking(const std::shared_ptr<const ModelGeometry>& geometry,
                                                 const Progress& progress) {
  const Mesh& mesh = geometry->model->mesh;
  auto result = std::make_shared<ModelGeometry>(*geometry);
  progress.checkpoint(0.0);
  result->boundary = boundaryLines(mesh);
  progress.checkpoint(0.5);
  result->caster = std::make_shared<const RayCaster>(mesh);
  progress.checkpoint(1.0);
  return result;
}

std::shared_ptr<const ModelGeometry> prepareModelGeometry(std::shared_ptr<const Model> model,
                                                          const Progress& progress) {
  progress.checkpoint(0.0);
  return withPicking(prepareSurface(std::move(model)), progress.part(0.4, 1.0));
}

std::shared_ptr<const ModelGeometry> withColours(const std::shared_ptr<const ModelGeometry>& geometry,
                                                 const AcquisitionState& state, const Progress& progress) {
  VertexColours colours = coloursOf(state, progress);
  if (colours.empty()) return geometry;
  auto result = std::make_shared<ModelGeometry>(*geometry);
  result->colours = std::move(colours);
  return result;
}

std::shared_ptr<const ModelGeometry> prepareGeometryOf(const AcquisitionState& state, const Progress& progress) {
  if (!state.model) return nullptr;
  return withColours(prepareModelGeometry(state.model, progress.part(0.0, 0.5)), state, progress.part(0.5, 1.0));
}

bool needsStandIn(const Model& model, const StandInOptions& options) {
  return model.mesh.triangles.size() > options.mostTriangles;
}

std::shared_ptr<const ModelGeometry> withStandIn(const std::shared_ptr<const ModelGeometry>& geometry,
                                                 const StandInOptions& options, const Progress& progress) {
  if (!needsStandIn(*geometry->model, options)) return geometry;
  progress.checkpoint(0.0);
  // A surface of area A passes through about 1.5 A / h^2 cubes of edge h and leaves two triangles in each.
  const Mesh& mesh = geometry->model->mesh;
  const double cell = std::sqrt(3.0 * area(mesh) / static_cast<double>(options.targetTriangles));
  const auto coarse = clustered(*geometry->surface, geometry->box, cell);
  progress.checkpoint(0.5);
  auto [standIn, origins] = withOrigins(*coarse, mesh);
  auto result = std::make_shared<ModelGeometry>(*geometry);
  result->coarse = toPolyData(standIn, true);
  result->coarseVertex = std::move(origins);
  progress.checkpoint(1.0);
  return result;
}

}  // namespace vantage
