#include "registration/alignment.h"

#include <algorithm>
#include <utility>

#include "registration/list_search.h"
#include "registration/scan_set.h"

namespace vantage {
namespace {

// Another list of poses is believed when it brings so much more of the set together than the given one.
constexpr double kBetterBy = 1.0;

bool nobodySaidWhere(std::span<const View> views) {
  return std::all_of(views.begin(), views.end(),
                     [](const View& view) { return view.image->poseKnownBy == PoseSource::Unknown; });
}

VerdictReason reasonOf(PoseListFault fault) {
  switch (fault) {
    case PoseListFault::Turns:
      return VerdictReason::OtherTurns;
    case PoseListFault::Inverted:
      return VerdictReason::InverseList;
    case PoseListFault::Unit:
      return VerdictReason::OtherUnit;
    case PoseListFault::Frame:
      return VerdictReason::OtherFrame;
    case PoseListFault::Axis:
      break;
  }
  return VerdictReason::AxisBeside;
}

// Whether all views found their place without a doubt.
bool isWhole(const ScanSet& set) {
  return set.worth() == static_cast<double>(set.placement.views.size());
}

// The set under a list of poses that explains it where the given one does not; nothing where there is none.
std::optional<std::pair<ScanSet, PoseListFinding>> explained(std::span<const View> views,
                                                             std::span<const PreparedView> prepared,
                                                             std::span<const Pose> given, double worth,
                                                             const AlignmentOptions& options,
                                                             const Progress& progress) {
  std::optional<std::pair<ScanSet, PoseListFinding>> best;
  for (const MendedList& list : betterLists(prepared, given, progress.part(0.0, 0.3))) {
    ScanSet set = judgedSet(views, prepared, list.poses, options, progress.part(0.3, 1.0));
    if (set.worth() < worth + kBetterBy || (best && set.worth() <= best->first.worth())) continue;
    best.emplace(std::move(set), list.finding);
  }
  return best;
}

// The list is wrong and was mended: nothing is right before the operator says so.
void doubt(const PoseListFinding& finding, ScanSet& set) {
  for (const std::size_t i : set.placement.order) {
    ViewAlignment& view = set.placement.views[i];
    view.verdict = Verdict::Doubtful;
    view.finding = findingOf(finding);
  }
}

// Nothing holds what the surface lets go of; where that left some out, nothing says that the others are right.
void nameMissingList(ScanSet& set) {
  PlacedViews& placement = set.placement;
  if (placement.order.empty()) return;
  const std::size_t first = placement.order.front();
  for (std::size_t i = 0; i < placement.views.size(); ++i) {
    ViewAlignment& view = placement.views[i];
    if (i == first || view.verdict == Verdict::Good) continue;
    view.verdict = Verdict::Failed;
    view.finding = {VerdictReason::NoPoseGiven, std::nullopt, {}};
    std::erase(placement.order, i);
  }
  if (placement.order.size() == placement.views.size()) return;
  for (const std::size_t i : placement.order)
    if (i != first)
      placement.views[i] = {Verdict::Doubtful,
                            {VerdictReason::NoPoseGiven, std::nullopt, {}},
                            placement.views[i].rms,
                            placement.views[i].inlierShare};
}

}  // namespace

Finding findingOf(const PoseListFinding& finding) {
  return {reasonOf(finding.fault), finding.value, {}};
}

AlignmentResult registerViews(std::span<const View> views, const AlignmentOptions& options, const Progress& progress) {
  const std::vector<PreparedView> prepared = prepareViews(views, progress.part(0.0, 0.05, "prepare_views"));
  std::vector<Pose> given;
  for (const View& view : views) given.push_back(view.T_object_scanner);
  AlignmentResult result;
  ScanSet set = judgedSet(views, prepared, given, options, progress.part(0.05, 0.6));
  const bool unknown = nobodySaidWhere(views);
  if (unknown && views.size() > 1) {
    nameMissingList(set);
  } else if (!isWhole(set)) {
    if (auto other = explained(views, prepared, given, set.worth(), options, progress.part(0.6, 1.0))) {
      set = std::move(other->first);
      result.list = other->second;
      doubt(other->second, set);
    }
  }
  result.poses = std::move(set.placement.poses);
  result.views = std::move(set.placement.views);
  result.order = std::move(set.placement.order);
  result.refinement = std::move(set.refinement);
  return result;
}

}  // namespace vantage
