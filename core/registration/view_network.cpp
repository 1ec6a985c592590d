#include "registration/view_network.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/parallel.h"

namespace vantage {
namespace {

// Points tried to find out whether two views overlap, and fewest that must meet.
constexpr std::size_t kTried = 300;
constexpr std::size_t kFewest = 6;
// Views see a part of each other: this many times the wanted number of points are looked at.
constexpr std::size_t kLookAt = 3;

// Points of one view that are kept: links of a view choose from them, the more views there are the fewer.
constexpr std::size_t kMostPoints = 400'000;

using PointIds = std::vector<std::uint32_t>;

// About `count` points of every view: the same for all links of a view, so that they are drawn once.
std::vector<PointIds> someOfEach(std::span<const PreparedView> views, std::size_t count, const Progress& progress) {
  std::vector<PointIds> some(views.size());
  parallelChunks(views.size(), 1, progress,
                 [&](std::size_t i, std::size_t) { some[i] = thinned(allIndices(views[i].points.size()), count); });
  return some;
}

double shareThatMeets(const PreparedView& from, const PointIds& ids, const PreparedView& to, const Pose& T_to_from,
                      const PairGates& gates) {
  if (ids.empty()) return 0.0;
  std::vector<std::optional<GridPosition>> positions(ids.size());
  std::vector<Pair> pairs(ids.size());
  findPairs(from.points, ids, T_to_from, to.surface, gates, positions, Progress(), pairs);
  const auto met = static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [](const Pair& p) { return p.state == PairState::Paired; }));
  return met < kFewest ? 0.0 : static_cast<double>(met) / static_cast<double>(ids.size());
}

// Gives a link about `count` of the points `lookAt` of its first view that its second one sees.
void keepSeen(const PreparedView& from, const PointIds& lookAt, const PreparedView& to, const Pose& T_to_from,
              const PairGates& gates, std::size_t count, ViewLink& link) {
  link.ids = lookAt;
  link.positions.resize(link.ids.size());
  link.pairs.resize(link.ids.size());
  findPairs(from.points, link.ids, T_to_from, to.surface, gates, link.positions, Progress(), link.pairs);
  std::vector<std::uint32_t> seen;
  for (std::size_t k = 0; k < link.ids.size(); ++k)
    if (link.pairs[k].state != PairState::Unseen) seen.push_back(link.ids[k]);
  link.ids = thinned(std::move(seen), count);
  link.positions.assign(link.ids.size(), std::nullopt);
  link.pairs.assign(link.ids.size(), {});
}

}  // namespace

PreparedView::PreparedView(const View& view)
    : image(view.image), mesh(view.mesh), surface(*mesh, *image->rays), points(surface.pointsInside(kMostPoints)) {}

RegistrationScale scaleOf(std::span<const PreparedView> views) {
  std::vector<RegistrationScale> scales;
  for (const PreparedView& view : views)
    if (!view.surface.view().mesh.empty()) scales.push_back(scaleOf(view.surface));
  return scaleOf(scales);
}

std::vector<PreparedView> prepareViews(std::span<const View> views, const Progress& progress) {
  std::vector<std::optional<PreparedView>> slots(views.size());
  parallelChunks(views.size(), 1, progress, [&](std::size_t i, std::size_t) { slots[i].emplace(views[i]); });
  std::vector<PreparedView> prepared;
  prepared.reserve(slots.size());
  for (auto& slot : slots) prepared.push_back(std::move(*slot));
  return prepared;
}

double overlapShare(const PreparedView& from, const PreparedView& to, const Pose& T_to_from, const PairGates& gates,
                    std::size_t count) {
  return shareThatMeets(from, thinned(allIndices(from.points.size()), count), to, T_to_from, gates);
}

std::vector<ViewLink> findLinks(std::span<const PreparedView> views, std::span<const Pose> poses,
                                const PairGates& gates, double minOverlap, std::size_t points, std::size_t leastPoints,
                                const Progress& progress) {
  const std::size_t n = views.size();
  const std::vector<PointIds> tried = someOfEach(views, kTried, progress.part(0.0, 0.1));
  std::vector<double> overlap(n * n, 0.0);
  parallelChunks(n * n, 1, progress.part(0.1, 0.5), [&](std::size_t k, std::size_t) {
    const std::size_t i = k / n;
    const std::size_t j = k % n;
    if (i != j) overlap[k] = shareThatMeets(views[i], tried[i], views[j], poses[j].inverse() * poses[i], gates);
  });
  std::vector<ViewLink> links;
  for (std::size_t k = 0; k < n * n; ++k) {
    if (overlap[k] < minOverlap || overlap[k] <= 0.0) continue;
    ViewLink link;
    link.from = k / n;
    link.to = k % n;
    links.push_back(std::move(link));
  }
  const std::size_t share = std::max(leastPoints, points / std::max<std::size_t>(links.size(), 1));
  const std::vector<PointIds> lookAt = someOfEach(views, kLookAt * share, progress.part(0.5, 0.6));
  parallelChunks(links.size(), 1, progress.part(0.6, 1.0), [&](std::size_t l, std::size_t) {
    const Pose T_to_from = poses[links[l].to].inverse() * poses[links[l].from];
    keepSeen(views[links[l].from], lookAt[links[l].from], views[links[l].to], T_to_from, gates, share, links[l]);
  });
  return links;
}

void findPairs(std::span<const PreparedView> views, std::span<const Pose> poses, const PairGates& gates,
               const Progress& progress, std::vector<ViewLink>& links) {
  parallelChunks(links.size(), 1, progress, [&](std::size_t l, std::size_t) {
    ViewLink& link = links[l];
    findPairs(views[link.from].points, link.ids, poses[link.to].inverse() * poses[link.from], views[link.to].surface,
              gates, link.positions, Progress(), link.pairs);
  });
}

double deviation(std::span<const ViewLink> links) {
  std::vector<double> distances;
  for (const ViewLink& link : links)
    for (const Pair& pair : link.pairs)
      if (pair.state == PairState::Paired) distances.push_back(std::abs(pair.distance));
  if (distances.empty()) return 0.0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return 1.4826 * *middle;
}

double robustRms(std::span<const ViewLink> links, double gate) {
  double squares = 0.0;
  std::size_t count = 0;
  for (const ViewLink& link : links) {
    for (const Pair& pair : link.pairs) {
      if (pair.state == PairState::Unseen || pair.state == PairState::Border) continue;
      const double distance = pair.state == PairState::Paired ? std::min(std::abs(pair.distance), gate) : gate;
      squares += distance * distance;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
}

}  // namespace vantage
