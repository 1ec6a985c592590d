#include "vtk/poly_data.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace vantage {
namespace {

vtkSmartPointer<vtkFloatArray> toTriples(std::span<const Vec3> values) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  float* out = array->GetPointer(0);
  for (const Vec3& v : values)
    for (int c = 0; c < 3; ++c) *out++ = static_cast<float>(v[c]);
  return array;
}

vtkSmartPointer<vtkPoints> toPoints(std::span<const Vec3> values) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(toTriples(values));
  return points;
}

vtkSmartPointer<vtkTypeInt32Array> cornerArray(std::size_t size) {
  auto array = vtkSmartPointer<vtkTypeInt32Array>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(size));
  return array;
}

// Cells of `corners` corners each, from a list of corners.
vtkSmartPointer<vtkCellArray> toCells(vtkTypeInt32Array* list, int corners) {
  const auto count = static_cast<std::size_t>(list->GetNumberOfValues() / corners);
  const auto offsets = cornerArray(count + 1);
  for (std::size_t i = 0; i <= count; ++i) offsets->SetValue(static_cast<vtkIdType>(i), static_cast<int>(i) * corners);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, list);
  return cells;
}

// Points that cells use in order, `Corners` each.
template <std::size_t Corners>
std::pair<vtkSmartPointer<vtkPoints>, vtkSmartPointer<vtkCellArray>> separateCells(
    std::span<const std::array<Vec3, Corners>> cells) {
  std::vector<Vec3> points;
  points.reserve(cells.size() * Corners);
  for (const auto& cell : cells) points.insert(points.end(), cell.begin(), cell.end());
  const auto list = cornerArray(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) list->SetValue(static_cast<vtkIdType>(i), static_cast<int>(i));
  return {toPoints(points), toCells(list, static_cast<int>(Corners))};
}

vtkSmartPointer<vtkUnsignedCharArray> toColourArray(const std::vector<Rgb>& colours) {
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName("colour");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
  for (std::size_t i = 0; i < colours.size(); ++i)
    std::copy(colours[i].begin(), colours[i].end(), array->GetPointer(3 * static_cast<vtkIdType>(i)));
  return array;
}

}  // namespace

vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh, bool smooth) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(toPoints(mesh.vertices));
  const auto list = cornerArray(mesh.triangles.size() * 3);
  int* corner = list->GetPointer(0);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) *corner++ = static_cast<int>(v);
  data->SetPolys(toCells(list, 3));
  if (smooth) data->GetPointData()->SetNormals(toTriples(computeVertexNormals(mesh)));
  return data;
}

vtkSmartPointer<vtkPolyData> toSegments(std::span<const std::array<Vec3, 2>> segments) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const auto [points, cells] = separateCells(segments);
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> toQuads(std::span<const std::array<Vec3, 4>> quads) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const auto [points, cells] = separateCells(quads);
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> withCellColours(vtkPolyData& data, const std::vector<Rgb>& colours) {
  auto coloured = vtkSmartPointer<vtkPolyData>::New();
  coloured->ShallowCopy(&data);
  coloured->GetCellData()->SetScalars(toColourArray(colours));
  return coloured;
}

vtkSmartPointer<vtkPolyData> withPointColours(vtkPolyData& data, const std::vector<Rgb>& colours) {
  auto coloured = vtkSmartPointer<vtkPolyData>::New();
  coloured->ShallowCopy(&data);
  coloured->GetPointData()->SetScalars(toColourArray(colours));
  return coloured;
}

vtkSmartPointer<vtkActor> makeActor() {
  auto actor = vtkSmartPointer<vtkActor>::New();
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetColorModeToDirectScalars();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.12);
  actor->GetProperty()->SetDiffuse(0.88);
  actor->GetProperty()->SetSpecular(0.0);
  setData(*actor, nullptr);
  return actor;
}

void setData(vtkActor& actor, vtkPolyData* data) {
  auto& mapper = *static_cast<vtkPolyDataMapper*>(actor.GetMapper());
  // What stays is not sent to the graphics card again.
  if (data != nullptr && mapper.GetNumberOfInputConnections(0) > 0 && mapper.GetInput() == data) return;
  const vtkSmartPointer<vtkPolyData> shown = data != nullptr ? data : vtkSmartPointer<vtkPolyData>::New().Get();
  mapper.SetInputData(shown);
  // An actor without cells has no bounds and must not take part in fitting.
  actor.SetUseBounds(shown->GetNumberOfCells() > 0);
}

void setColour(vtkActor& actor, const Rgb& colour) {
  actor.GetProperty()->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
}

void setUnlit(vtkActor& actor) {
  actor.GetProperty()->SetLighting(false);
}

// VTK keeps what is on the side that the normal points to.
void setClip(vtkActor& actor, const std::optional<SurfacePlane>& plane) {
  vtkMapper& mapper = *actor.GetMapper();
  mapper.RemoveAllClippingPlanes();
  if (!plane) return;
  const auto kept = vtkSmartPointer<vtkPlane>::New();
  const Vec3 origin = plane->offset * plane->normal;
  const Vec3 normal = -plane->normal;
  kept->SetOrigin(origin.x(), origin.y(), origin.z());
  kept->SetNormal(normal.x(), normal.y(), normal.z());
  mapper.AddClippingPlane(kept);
}

void setInFront(vtkActor& actor, double units) {
  vtkMapper& mapper = *actor.GetMapper();
  mapper.SetResolveCoincidentTopologyToPolygonOffset();
  mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(-units, -units);
  mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-units, -units);
}

}  // namespace vantage
