#include "integration/mending.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "integration/crumb.h"
#include "integration/measured_hole.h"
#include "integration/sliver.h"

namespace vantage {

MendedModel mend(const Model& model, std::span<const View> views, const ZipperOptions& options,
                 const Progress& progress) {
  MendedModel result;
  if (model.mesh.empty()) return result;
  const Witnesses witnesses(views, options, progress.part(0.0, 0.3));
  ModelEditor editor(model);
  result.crumbTriangles = removeCrumbs(editor);
  const ClosedHoles holes = closeMeasuredHoles(editor, witnesses, options, progress.part(0.3, 1.0));
  result.holesClosed = holes.count;
  double spacing = std::numeric_limits<double>::infinity();
  for (std::uint32_t v = 0; v < views.size(); ++v) spacing = std::min(spacing, witnesses.spacing(v));
  (void)removeSlivers(editor, holes.vertices, {.shortestEdge = options.shortestEdge * spacing});
  result.model = std::move(editor).take();
  return result;
}

}  // namespace vantage
