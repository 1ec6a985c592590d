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

// Ties as a graph whose known views are one vertex.
class TieGraph {
 public:
  TieGraph(std::span<const ViewTie> ties, const std::vector<bool>& known)
      : ends_(known.size() + 1), reached_(known.size() + 1, 0), lowest_(known.size() + 1, 0) {
    const std::size_t place = known.size();
    for (std::size_t k = 0; k < ties.size(); ++k) {
      const std::size_t a = known[ties[k].first] ? place : ties[k].first;
      const std::size_t b = known[ties[k].second] ? place : ties[k].second;
      if (a == b) continue;
      ends_[a].push_back({b, k});
      ends_[b].push_back({a, k});
    }
  }

  // The vertices that stay joined with the last one whichever tie is cut: a depth-first search that does not pass the
  // bridges (Tarjan 1974). Without recursion: there may be many views.
  [[nodiscard]] std::vector<bool> joinedWithLast() {
    const std::size_t last = ends_.size() - 1;
    std::vector<std::size_t> order;
    std::vector<std::size_t> parent(ends_.size(), last);
    std::vector<Step> path{{last, kNoTie, 0}};
    std::size_t time = reached_[last] = lowest_[last] = 1;
    while (!path.empty()) {
      Step& step = path.back();
      if (step.next == ends_[step.vertex].size()) {
        order.push_back(step.vertex);
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
      reached_[end.vertex] = lowest_[end.vertex] = ++time;
      parent[end.vertex] = step.vertex;
      path.push_back({end.vertex, end.tie, 0});
    }
    std::vector<bool> joined(ends_.size(), false);
    joined[last] = true;
    // From the root outwards: the tie to the parent is a bridge where nothing below reaches the parent or beyond.
    for (auto vertex = order.rbegin(); vertex != order.rend(); ++vertex)
      if (*vertex != last) joined[*vertex] = joined[parent[*vertex]] && lowest_[*vertex] <= reached_[parent[*vertex]];
    return joined;
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

  std::vector<std::vector<End>> ends_;
  std::vector<std::size_t> reached_;  // when, from 1
  std::vector<std::size_t> lowest_;   // the earliest that is reached from there and below
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

std::vector<bool> heldByLoops(std::span<const ViewTie> ties, const std::vector<bool>& known) {
  std::vector<bool> held = TieGraph(ties, known).joinedWithLast();
  held.pop_back();
  for (std::size_t i = 0; i < known.size(); ++i) held[i] = held[i] || known[i];
  return held;
}

}  // namespace vantage
