#include "integration/zipper.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/errors.h"
#include "integration/grid_surface.h"
#include "integration/hole.h"
#include "integration/manifold.h"
#include "integration/mending.h"
#include "integration/model_editor.h"
#include "integration/model_projection.h"
#include "integration/redundancy.h"
#include "integration/seam.h"
#include "integration/sliver.h"

namespace vantage {
namespace {

void checkProvenance(const Model& model, std::span<const View> views) {
  for (std::size_t v = 0; v < model.vertexView.size(); ++v) {
    const std::uint32_t view = model.vertexView[v];
    if (view >= views.size() || !views[view].image || !views[view].mesh ||
        model.vertexSample[v] >= views[view].image->range.size() || !views[view].image->valid(model.vertexSample[v]))
      throw InvalidInput("vertex " + std::to_string(v) + " of the model is sample " +
                         std::to_string(model.vertexSample[v]) + " of view " + std::to_string(view) +
                         ", which is not there");
  }
}

double sliverLength(const ZipperOptions& options, const GridSurface& surface) {
  return options.shortestEdge * surface.mesh().spacing;
}

}  // namespace

ZipperStatistics& ZipperStatistics::operator+=(const ZipperStatistics& other) {
  removedFromModel += other.removedFromModel;
  removedFromViews += other.removedFromViews;
  added += other.added;
  seam += other.seam;
  slivers += other.slivers;
  holesClosed += other.holesClosed;
  bowTies += other.bowTies;
  islands += other.islands;
  return *this;
}

Integration integrateView(const Model& model, std::span<const View> views, std::uint32_t newView,
                          const ZipperOptions& options, const Progress& progress) {
  if (newView >= views.size())
    throw InvalidInput("view " + std::to_string(newView) + " is to be integrated, but there are " +
                       std::to_string(views.size()));
  checkProvenance(model, views);
  progress.checkpoint(0.0);
  const GridSurface surface(views[newView]);
  progress.checkpoint(0.05);
  const std::vector<ProjectedVertex> projected = projectModel(model, surface, options, progress.part(0.05, 0.4));

  Integration result;
  ZipperStatistics& statistics = result.statistics;
  Model edited = model;
  progress.checkpoint(0.41);
  ModelEditor editor(std::move(edited));
  progress.checkpoint(0.42);
  statistics.removedFromModel = removeRedundantTriangles(editor, projected, views, options, progress.part(0.42, 0.5));
  for (std::uint32_t v = 0; v < projected.size(); ++v)
    if (projected[v].contact == Contact::On) editor.raiseConfidence(v, projected[v].confidence);
  progress.checkpoint(0.5);
  const OverlapIndex overlap(editor, projected, surface, progress.part(0.5, 0.55));
  progress.checkpoint(0.55);
  const ViewCut cut = cutView(editor, projected, surface, overlap, options, progress.part(0.55, 0.6));
  progress.checkpoint(0.6);
  const Seam seam = stitch(editor, projected, surface, cut, overlap, views, newView, options, progress.part(0.6, 0.8));
  statistics.added = seam.viewTriangles;
  statistics.removedFromViews = surface.mesh().mesh.triangles.size() - seam.viewTriangles;
  statistics.seam = seam.seamTriangles;
  progress.checkpoint(0.8);
  statistics.bowTies = resolveBowTies(editor, seam.vertices);
  progress.checkpoint(0.82);
  statistics.islands = removeIslands(editor, options.minIslandTriangles);
  progress.checkpoint(0.85);
  statistics.slivers = removeSlivers(editor, seam.vertices, {.shortestEdge = sliverLength(options, surface)});
  progress.checkpoint(0.87);
  statistics.holesClosed = closeSmallHoles(editor, surface, newView, options);
  progress.checkpoint(0.9);
  result.model = std::move(editor).take();
  return result;
}

Integration zipper(std::span<const View> views, const ZipperOptions& options, const Progress& progress) {
  Integration result;
  const Progress adding = progress.part(0.0, 0.9);
  const auto count = static_cast<double>(views.size());
  for (std::uint32_t k = 0; k < views.size(); ++k) {
    Integration step =
        integrateView(result.model, views, k, options, adding.part(k / count, (k + 1) / count, "zippering"));
    result.model = std::move(step.model);
    result.statistics += step.statistics;
  }
  if (!options.mend) return result;
  MendedModel mended = mend(result.model, views, options, progress.part(0.9, 1.0));
  result.model = std::move(mended.model);
  result.statistics.islands += mended.crumbTriangles;
  result.statistics.holesClosed += mended.holesClosed;
  return result;
}

Model reposed(const Model& model, std::span<const View> views) {
  checkProvenance(model, views);
  Model result = model;
  for (std::size_t v = 0; v < result.mesh.vertices.size(); ++v) {
    const View& view = views[model.vertexView[v]];
    result.mesh.vertices[v] = view.T_object_scanner * view.image->point(model.vertexSample[v]);
  }
  return result;
}

}  // namespace vantage
