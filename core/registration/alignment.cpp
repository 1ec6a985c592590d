#include "registration/alignment.h"

#include <algorithm>

#include "base/parallel.h"
#include "registration/view_network.h"

namespace vantage {
namespace {

// Points of a view that are tried to find how much it overlaps with another.
constexpr std::size_t kTried = 400;

// Places the views one after the other.
class Placement {
 public:
  Placement(std::span<const View> views, const AlignmentOptions& options, const Progress& progress)
      : options_(options), views_(prepareViews(views, progress.part(0.0, 0.4))), placed_(views.size(), false) {
    for (const View& view : views) poses.push_back(view.T_object_scanner);
    alignments.resize(views.size());
    measureOverlaps(progress.part(0.4, 1.0));
  }

  void run(const Progress& progress) {
    if (views_.empty()) return;
    place(0, {Verdict::Good, {VerdictReason::FirstImported, std::nullopt, {}}, 0.0, 1.0});
    std::vector<bool> failed(views_.size(), false);
    while (true) {
      const double done = static_cast<double>(order.size()) / static_cast<double>(views_.size());
      std::size_t next = bestOverlap(failed);
      if (next == views_.size()) return;
      const bool found = tryToPlace(next, progress.part(done, done + 1.0 / static_cast<double>(views_.size())));
      // Whatever failed before may overlap with what was placed now.
      if (found) failed.assign(views_.size(), false);
      failed[next] = !found;
    }
  }

  std::vector<Pose> poses;
  std::vector<ViewAlignment> alignments;
  std::vector<std::size_t> order;

 private:
  void place(std::size_t i, ViewAlignment alignment) {
    placed_[i] = true;
    alignments[i] = std::move(alignment);
    order.push_back(i);
    OrientedPoints some;
    for (const std::uint32_t k : thinned(allIndices(views_[i].points.size()), options_.sampling.pointsPerView)) {
      some.points.push_back(views_[i].points.points[k]);
      some.normals.push_back(views_[i].points.normals[k]);
      some.confidence.push_back(views_[i].points.confidence[k]);
    }
    union_.append(some, poses[i]);
  }

  bool tryToPlace(std::size_t i, const Progress& progress) {
    IcpOptions icp = options_.icp;
    icp.finePoints = options_.sampling.finePoints;
    const RegistrationResult result =
        registerView(views_[i].surface, poses[i], RegistrationTarget(union_), icp, progress);
    ViewAlignment alignment{result.verdict, result.finding, result.rms, result.inlierShare};
    if (result.verdict == Verdict::Failed) {
      alignments[i] = std::move(alignment);
      return false;
    }
    poses[i] = result.T_object_scanner;
    place(i, std::move(alignment));
    return true;
  }

  // Shares of points that meet each other, under the poses given.
  void measureOverlaps(const Progress& progress) {
    const std::size_t n = views_.size();
    const PairGates gates{options_.icp.coarseGate, options_.icp.hiddenDepth, options_.icp.coarseAngle};
    overlap_.assign(n * n, 0.0);
    parallelChunks(n * n, 1, progress, [&](std::size_t k, std::size_t) {
      const std::size_t i = k / n;
      const std::size_t j = k % n;
      if (i != j) overlap_[k] = overlapShare(views_[i], views_[j], poses[j].inverse() * poses[i], gates, kTried);
    });
  }

  // The view that is still to be placed and meets most of those placed; as many as there are views for none.
  [[nodiscard]] std::size_t bestOverlap(const std::vector<bool>& failed) const {
    const std::size_t n = views_.size();
    std::size_t best = n;
    double most = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      if (placed_[i] || failed[i]) continue;
      double sum = 0.0;
      for (const std::size_t j : order) sum += overlap_[i * n + j] + overlap_[j * n + i];
      if (best != n && sum <= most) continue;
      best = i;
      most = sum;
    }
    return best;
  }

  const AlignmentOptions& options_;
  std::vector<PreparedView> views_;
  std::vector<bool> placed_;
  std::vector<double> overlap_;
  OrientedPoints union_;
};

}  // namespace

AlignmentResult registerViews(std::span<const View> views, const AlignmentOptions& options, const Progress& progress) {
  Placement placement(views, options, progress.part(0.0, 0.1, "prepare_views"));
  placement.run(progress.part(0.1, 0.6));

  std::vector<std::size_t> placed = placement.order;
  std::sort(placed.begin(), placed.end());
  std::vector<View> toRefine;
  for (const std::size_t i : placed) {
    toRefine.push_back(views[i]);
    toRefine.back().T_object_scanner = placement.poses[i];
  }
  AlignmentResult result;
  result.refinement = refineViews(toRefine, options.refinement, progress.part(0.6, 1.0));
  result.poses = placement.poses;
  for (std::size_t k = 0; k < placed.size(); ++k) result.poses[placed[k]] = result.refinement.poses[k];
  result.views = placement.alignments;
  result.order = placement.order;
  return result;
}

}  // namespace vantage
