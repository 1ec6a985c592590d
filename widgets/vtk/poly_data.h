#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "look/colour_map.h"
#include "measuring/surface_plane.h"

class vtkActor;
class vtkPolyData;

namespace vantage {

/// A mesh as VTK draws it; with smooth normals at the vertices or flat.
[[nodiscard]] vtkSmartPointer<vtkPolyData> toPolyData(const Mesh& mesh, bool smooth);

/// Lines from pairs of points.
[[nodiscard]] vtkSmartPointer<vtkPolyData> toSegments(std::span<const std::array<Vec3, 2>> segments);

/// Separate flat quads.
[[nodiscard]] vtkSmartPointer<vtkPolyData> toQuads(std::span<const std::array<Vec3, 4>> quads);

/// The same geometry with a colour per cell or per point; geometry is shared, not copied.
/// @pre one colour per cell (point)
[[nodiscard]] vtkSmartPointer<vtkPolyData> withCellColours(vtkPolyData& data, const std::vector<Rgb>& colours);
[[nodiscard]] vtkSmartPointer<vtkPolyData> withPointColours(vtkPolyData& data, const std::vector<Rgb>& colours);

/// An actor that draws nothing yet.
[[nodiscard]] vtkSmartPointer<vtkActor> makeActor();
void setData(vtkActor& actor, vtkPolyData* data);  ///< null draws nothing
void setColour(vtkActor& actor, const Rgb& colour);
/// Draws the actor's colours as they are, without light.
void setUnlit(vtkActor& actor);
/// Moves an actor toward the eye in depth, so that it is seen on a surface that it lies in.
void setInFront(vtkActor& actor, double units);
/// Draws nothing of the actor that is before a plane; without one all of it.
void setClip(vtkActor& actor, const std::optional<SurfacePlane>& plane);

}  // namespace vantage
