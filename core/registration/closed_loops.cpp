#include "registration/closed_loops.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "registration/registration_target.h"

namespace vantage {
namespace {

// Points of one view that another is registered with.
constexpr std::size_t kPoints = 8000;
// Pairs with less in common say nothing of each other.
constexpr double kLeastOverlap = 0.1;
constexpr std::size_t kTried = 300;

double farthestMove(const ViewSurface& surface, const Pose& a, const Pose& b) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : surface.view().mesh.vertices) box.extend(p);
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    most = std::max(most, (a * p - b * p).norm());
  }
  return most;
}

bool isTied(const PreparedView& view, const PreparedView& other, const Pose& T_other_view, const IcpOptions& options,
            const Progress& progress) {
  const RegistrationScale scale = scaleOf(view.surface);
  const PairGates gates{fineGate(scale), *resolved(options, scale).hiddenDepth, options.finalAngle};
  if (overlapShare(view, other, T_other_view, gates, kTried) < kLeastOverlap) return false;
  OrientedPoints points;
  points.append(thinnedPoints(other.points, kPoints), Pose::Identity());
  const RegistrationResult result =
      registerView(view.surface, T_other_view, RegistrationTarget(std::move(points)), options, progress);
  const bool fits = result.verdict == Verdict::Good ||
                    (result.verdict == Verdict::Doubtful && result.finding.reason == VerdictReason::HeldByMechanics);
  return fits && farthestMove(view.surface, result.T_object_scanner, T_other_view) <= scale.spacing;
}

// Ties as a graph whose known views are one vertex, the first.
class TieGraph {
 public:
  TieGraph(std::span<const ViewTie> ties, const std::vector<bool>& known)
      : ends_(known.size() + 1),
        reached_(known.size() + 1, 0),
        lowest_(known.size() + 1, 0),
        parent_(known.size() + 1, 0) {
    const auto vertexOf = [&](std::size_t view) { return known[view] ? 0 : view + 1; };
    for (std::size_t k = 0; k < ties.size(); ++k) {
      const std::size_t a = vertexOf(ties[k].first);
      const std::size_t b = vertexOf(ties[k].second);
      if (a == b) continue;
      ends_[a].push_back({b, k});
      ends_[b].push_back({a, k});
    }
  }

  // One number per vertex, 0 for the first: those of one stay joined whichever tie is cut. Depth-first searches find
  // the bridges (Tarjan 1974). Without recursion: there may be many views.
  [[nodiscard]] std::vector<std::size_t> groups() {
    for (std::size_t root = 0; root < ends_.size(); ++root)
      if (reached_[root] == 0) searchFrom(root);
    std::vector<std::size_t> group(ends_.size(), 0);
    std::size_t count = 0;
    // Parents come before what was reached from them. The tie to the parent is a bridge where nothing below reaches the
    // parent or beyond.
    for (const std::size_t vertex : order_) {
      const bool joined = parent_[vertex] != vertex && lowest_[vertex] <= reached_[parent_[vertex]];
      group[vertex] = joined ? group[parent_[vertex]] : count++;
    }
    return group;
  }

 private:
  static constexpr std::size_t kNoTie = static_cast<std::size_t>(-1);
  struct End {
    std::size_t vertex;
    std::size_t tie;
  };
  struct Step {
    std::size_t vertex;
    std::size_t tie;  // that led to it
    std::size_t next;
  };

  void reach(std::size_t vertex, std::size_t from) {
    order_.push_back(vertex);
    parent_[vertex] = from;
    reached_[vertex] = lowest_[vertex] = order_.size();
  }

  void searchFrom(std::size_t root) {
    reach(root, root);
    std::vector<Step> path{{root, kNoTie, 0}};
    while (!path.empty()) {
      Step& step = path.back();
      if (step.next == ends_[step.vertex].size()) {
        const std::size_t done = step.vertex;
        path.pop_back();
        if (!path.empty()) lowest_[path.back().vertex] = std::min(lowest_[path.back().vertex], lowest_[done]);
        continue;
      }
      const End end = ends_[step.vertex][step.next++];
      if (end.tie == step.tie) continue;
      if (reached_[end.vertex] > 0) {
        lowest_[step.vertex] = std::min(lowest_[step.vertex], reached_[end.vertex]);
        continue;
      }
      reach(end.vertex, step.vertex);
      path.push_back({end.vertex, end.tie, 0});
    }
  }

  std::vector<std::vector<End>> ends_;
  std::vector<std::size_t> order_;    // in which they were reached
  std::vector<std::size_t> reached_;  // when, from 1
  std::vector<std::size_t> lowest_;   // the earliest that is reached from there and below
  std::vector<std::size_t> parent_;   // itself for roots
};

}  // namespace

std::vector<ViewTie> tiesAmong(std::span<const PreparedView> views, std::span<const Pose> poses,
                               const std::vector<bool>& wanted, const IcpOptions& options, const Progress& progress) {
  const std::size_t n = views.size();
  std::vector<std::uint8_t> tied(n * n, 0);
  parallelChunks(n * n, 1, progress, [&](std::size_t k, std::size_t) {
    const std::size_t i = k / n;
    const std::size_t j = k % n;
    if (i <= j || !wanted[i] || !wanted[j]) return;
    const Pose T_j_i = poses[j].inverse() * poses[i];
    tied[k] = isTied(views[i], views[j], T_j_i, options, Progress()) ? 1 : 0;
  });
  std::vector<ViewTie> ties;
  for (std::size_t k = 0; k < n * n; ++k)
    if (tied[k]) ties.push_back({k % n, k / n});
  return ties;
}

std::vector<std::size_t> heldTogether(std::span<const ViewTie> ties, const std::vector<bool>& known) {
  const std::vector<std::size_t> groups = TieGraph(ties, known).groups();
  std::vector<std::size_t> held;
  for (std::size_t i = 0; i < known.size(); ++i) held.push_back(known[i] ? 0 : groups[i + 1]);
  return held;
}

}  // namespace vantage
