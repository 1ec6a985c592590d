#include "composites/composite_union.h"

#include <utility>

#include "base/errors.h"

namespace vantage {

Composite united(const Composite& reference, const Composite& moved, const AlignedPose& pose,
                 const UnionOptions& options, const Progress& progress) {
  const auto& refined = pose.refinement;
  if (refined && (refined->reference.size() != reference.views.size() || refined->moved.size() != moved.views.size()))
    throw InvalidInput("the pose of two composites was refined with other views than they have");
  const Pose& T = pose.T_reference_moved;
  Composite all = reference;
  for (std::size_t i = 0; i < reference.views.size() && refined; ++i)
    all.views[i].T_object_scanner = refined->reference[i];
  for (std::size_t i = 0; i < moved.views.size(); ++i) {
    View view = moved.views[i];
    view.T_object_scanner = refined ? refined->moved[i] : T * view.T_object_scanner;
    all.views.push_back(std::move(view));
  }
  for (const TablePlane& table : moved.tables) {
    const Vec3 normal = T.linear() * table.normal;
    all.tables.push_back({normal, table.height + normal.dot(T.translation())});
  }
  for (const PoseTie& tie : moved.ties) {
    all.ties.push_back(movedTie(tie, T));
    all.ties.back().from += reference.views.size();
    all.ties.back().to += reference.views.size();
  }
  const Integration integration = zipper(all.views, options.zipper, progress.part(0.0, 0.7, "integrate"));
  all.model = std::make_shared<const Model>(
      applyConsensus(integration.model, all.views, options.consensus, progress.part(0.7, 1.0)));
  return all;
}

}  // namespace vantage
