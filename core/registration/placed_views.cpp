#include "registration/placed_views.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/parallel.h"

namespace vantage {
namespace {

// Points of a view that are tried to find how much it overlaps with another.
constexpr std::size_t kTried = 400;
// A pose that is carried on from a neighbour is another one when it lies this share of a loose shift away.
constexpr double kAnother = 0.25;

// Shares of points that meet each other, [i * n + j] of i on j.
std::vector<double> overlaps(std::span<const PreparedView> views, std::span<const Pose> poses, const PairGates& gates,
                             const Progress& progress) {
  const std::size_t n = views.size();
  std::vector<double> shares(n * n, 0.0);
  parallelChunks(n * n, 1, progress, [&](std::size_t k, std::size_t) {
    const std::size_t i = k / n;
    const std::size_t j = k % n;
    if (i != j) shares[k] = overlapShare(views[i], views[j], poses[j].inverse() * poses[i], gates, kTried);
  });
  return shares;
}

Vec3 centreOf(const PreparedView& view) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < view.points.size(); ++k) sum += view.points.pointAt(k);
  return sum / static_cast<double>(std::max<std::size_t>(view.points.size(), 1));
}

// One set of views that hang together, grown from a first one.
class Growth {
 public:
  Growth(std::span<const PreparedView> views, std::span<const Pose> given, const std::vector<double>& overlap,
         const AlignmentOptions& options, const RegistrationScale& scale)
      : views_(views), given_(given), overlap_(overlap), options_(options), scale_(scale) {
    found.poses.assign(given.begin(), given.end());
    found.views.resize(views.size());
    placed_.assign(views.size(), false);
  }

  // Grows from a view over those that may be placed.
  void run(std::size_t first, const std::vector<bool>& may, const Progress& progress) {
    place(first, given_[first], {Verdict::Good, {VerdictReason::FirstImported, std::nullopt, {}}, 0.0, 1.0});
    std::vector<bool> waiting(views_.size(), false);
    bool sureOnly = true;
    while (true) {
      const double done = static_cast<double>(found.order.size()) / static_cast<double>(views_.size());
      const std::size_t next = bestOverlap(may, waiting);
      if (next == views_.size()) {
        if (!sureOnly) return;
        sureOnly = false;
        waiting = failed_;
        continue;
      }
      waiting[next] = true;
      if (!tryToPlace(next, sureOnly, progress.part(done, done + 1.0 / static_cast<double>(views_.size())))) continue;
      // Whatever waited may overlap with what was placed now.
      waiting.assign(views_.size(), false);
      failed_.assign(views_.size(), false);
      sureOnly = true;
    }
  }

  PlacedViews found;

 private:
  void place(std::size_t i, const Pose& pose, ViewAlignment alignment) {
    placed_[i] = true;
    found.poses[i] = pose;
    found.views[i] = std::move(alignment);
    found.order.push_back(i);
    failed_.resize(views_.size(), false);
    union_.append(thinnedPoints(views_[i].points, options_.sampling.pointsPerView), pose);
  }

  [[nodiscard]] RegistrationResult registered(std::size_t i, const Pose& start, const Progress& progress) const {
    IcpOptions icp = options_.icp;
    icp.finePoints = options_.sampling.finePoints;
    return registerView(views_[i].surface, start, RegistrationTarget(union_), icp, progress);
  }

  // Where the view would be if the list were wrong there by as much as for the placed view that it overlaps most.
  [[nodiscard]] std::optional<Pose> carriedOn(std::size_t i) const {
    const std::size_t n = views_.size();
    const auto shared = [&](std::size_t j) { return overlap_[i * n + j] + overlap_[j * n + i]; };
    std::size_t nearest = found.order.front();
    for (const std::size_t j : found.order)
      if (shared(j) > shared(nearest)) nearest = j;
    const Pose carried = found.poses[nearest] * given_[nearest].inverse() * given_[i];
    const Vec3 centre = centreOf(views_[i]);
    if ((carried * centre - given_[i] * centre).norm() < kAnother * looseShift(scale_)) return std::nullopt;
    return carried;
  }

  bool tryToPlace(std::size_t i, bool sureOnly, const Progress& progress) {
    RegistrationResult best = registered(i, given_[i], progress.part(0.0, 0.5));
    if (best.verdict != Verdict::Good) {
      if (const auto carried = carriedOn(i)) {
        RegistrationResult other = registered(i, *carried, progress.part(0.5, 1.0));
        if (other.verdict < best.verdict || (other.verdict == best.verdict && other.inlierShare > best.inlierShare))
          best = std::move(other);
      }
    }
    ViewAlignment alignment{best.verdict, best.finding, best.rms, best.inlierShare};
    found.views[i] = alignment;
    if (best.verdict == Verdict::Failed) failed_[i] = true;
    if (best.verdict == Verdict::Failed || (sureOnly && best.verdict != Verdict::Good)) return false;
    place(i, best.T_object_scanner, std::move(alignment));
    return true;
  }

  // The view that is still to be placed and meets most of those placed; as many as there are views for none.
  [[nodiscard]] std::size_t bestOverlap(const std::vector<bool>& may, const std::vector<bool>& waiting) const {
    const std::size_t n = views_.size();
    std::size_t best = n;
    double most = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!may[i] || placed_[i] || waiting[i]) continue;
      double sum = 0.0;
      for (const std::size_t j : found.order) sum += overlap_[i * n + j] + overlap_[j * n + i];
      if (best != n && sum <= most) continue;
      best = i;
      most = sum;
    }
    return best;
  }

  std::span<const PreparedView> views_;
  std::span<const Pose> given_;
  const std::vector<double>& overlap_;
  const AlignmentOptions& options_;
  RegistrationScale scale_;
  std::vector<bool> placed_;
  std::vector<bool> failed_;
  OrientedPoints union_;
};

}  // namespace

PlacedViews placeViews(std::span<const PreparedView> views, std::span<const Pose> given,
                       const AlignmentOptions& options, const Progress& progress) {
  const RegistrationScale scale = scaleOf(views);
  const IcpOptions icp = resolved(options.icp, scale);
  const std::vector<double> overlap =
      overlaps(views, given, {*icp.coarseGate, *icp.hiddenDepth, icp.coarseAngle}, progress.part(0.0, 0.1));
  std::optional<PlacedViews> best;
  std::vector<bool> left(views.size(), true);
  for (std::size_t first = 0; first < views.size(); ++first) {
    if (!left[first] || views[first].points.size() == 0) continue;
    Growth growth(views, given, overlap, options, scale);
    growth.run(first, left, progress.part(0.1, 1.0));
    for (const std::size_t i : growth.found.order) left[i] = false;
    if (!best || growth.found.order.size() > best->order.size()) {
      // What the larger set says of the views before it is what counts.
      const std::vector<bool> outside(views.size(), true);
      if (best) {
        Growth again(views, given, overlap, options, scale);
        again.run(first, outside, progress.part(0.1, 1.0));
        best = std::move(again.found);
        for (const std::size_t i : best->order) left[i] = false;
      } else {
        best = std::move(growth.found);
      }
    }
    const auto rest = static_cast<std::size_t>(std::count(left.begin(), left.end(), true));
    if (rest <= best->order.size()) break;
  }
  if (best) return std::move(*best);
  return {{given.begin(), given.end()}, std::vector<ViewAlignment>(views.size()), {}};
}

}  // namespace vantage
