#pragma once

#include <vtkSmartPointer.h>

#include <memory>
#include <span>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "base/progress.h"
#include "geometry/measures.h"
#include "geometry/ray_caster.h"
#include "integration/model.h"
#include "integration/vertex_colours.h"
#include "layers/model_options.h"
#include "vtk/poly_data.h"

namespace vantage {

/// A model made ready to be drawn and picked. Immutable.
struct ModelGeometry {
  std::shared_ptr<const Model> model;
  vtkSmartPointer<vtkPolyData> surface;
  BoundingBox box;
  VertexColours colours;  ///< that the scans saw; empty where they saw none, and while they are not ready

  vtkSmartPointer<vtkPolyData> boundary;    ///< null while only the surface is ready
  std::shared_ptr<const RayCaster> caster;  ///< null while only the surface is ready

  vtkSmartPointer<vtkPolyData> coarse;      ///< drawn while the camera moves; null for a small model
  std::vector<std::uint32_t> coarseVertex;  ///< per vertex of it the model's vertex

  /// What is shown where a colouring is asked for: colours only where there are some.
  [[nodiscard]] ModelColouring shown(std::optional<ModelColouring> asked) const;

  /// The surface and its coarse stand-in in colours; with the plain colouring without. @pre colours, for Colours
  /// @param stands of the model's views, one for each
  [[nodiscard]] vtkSmartPointer<vtkPolyData> coloured(ModelColouring colouring, std::span<const int> stands) const;
  [[nodiscard]] vtkSmartPointer<vtkPolyData> colouredCoarse(ModelColouring colouring,
                                                            std::span<const int> stands) const;
};

/// Makes a model ready to be drawn, but not to be picked: a tenth of a second for a million triangles.
[[nodiscard]] std::shared_ptr<const ModelGeometry> prepareSurface(std::shared_ptr<const Model> model);

/// The same with boundary and caster: some tenths of a second for a million triangles. @throws Cancelled
[[nodiscard]] std::shared_ptr<const ModelGeometry> withPicking(const std::shared_ptr<const ModelGeometry>& geometry,
                                                               const Progress& progress = {});

/// Makes a model ready to be drawn and picked. @throws Cancelled
[[nodiscard]] std::shared_ptr<const ModelGeometry> prepareModelGeometry(std::shared_ptr<const Model> model,
                                                                        const Progress& progress = {});

/// The same with the colours of its scans, where they have some: about as long as a consensus takes. @throws Cancelled
[[nodiscard]] std::shared_ptr<const ModelGeometry> withColours(const std::shared_ptr<const ModelGeometry>& geometry,
                                                               const AcquisitionState& state,
                                                               const Progress& progress = {});

/// Makes the model of a state ready to be drawn and picked, in its colours; null without one. @throws Cancelled
[[nodiscard]] std::shared_ptr<const ModelGeometry> prepareGeometryOf(const AcquisitionState& state,
                                                                     const Progress& progress = {});

/// Large models are drawn coarsely while the camera moves.
struct StandInOptions {
  std::size_t mostTriangles = 120000;   ///< models up to this size stay as they are
  std::size_t targetTriangles = 60000;  ///< about
};

/// Whether a model is so large that it gets a stand-in.
[[nodiscard]] bool needsStandIn(const Model& model, const StandInOptions& options = {});

/// The same with a coarse stand-in where the model is large, its vertices clustered: about a second for a million
/// triangles. @throws Cancelled
[[nodiscard]] std::shared_ptr<const ModelGeometry> withStandIn(const std::shared_ptr<const ModelGeometry>& geometry,
                                                               const StandInOptions& options = {},
                                                               const Progress& progress = {});

/// The colour of the surface that a view brought, among so many views.
[[nodiscard]] Rgb viewColour(std::size_t view);
[[nodiscard]] Rgb ageColour(std::size_t view, std::size_t views);
/// The colour of the surface that a stand brought.
[[nodiscard]] Rgb standColour(int stand);

}  // namespace vantage
