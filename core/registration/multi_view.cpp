#include "registration/multi_view.h"

#include "registration/prepared_refinement.h"

namespace vantage {

MultiViewResult refineViews(std::span<const View> views, const MultiViewOptions& options, const Progress& progress) {
  std::vector<PreparedView> prepared;
  if (views.size() > 1) prepared = prepareViews(views, progress.part(0.0, 0.1, "refine"));
  return refinePrepared(views, prepared, options, progress.part(0.1, 1.0));
}

}  // namespace vantage
