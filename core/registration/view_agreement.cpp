#include "registration/view_agreement.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/parallel.h"

namespace vantage {
namespace {

// A point faces a scanner that must have seen it by at least this cosine.
constexpr double kPlainlyFacing = 0.6;
// So few points that were looked through may be flying ones.
constexpr double kMayFly = 8.0;
// Fewer expected points say nothing.
constexpr double kFewest = 25.0;

// Whether a receiver is on the side of a surface that the scanner saw: none can measure what turns away from all.
bool facesReceiver(const Vec3& point, const Vec3& normal, const RayGrid& rays, std::size_t ray) {
  if (!rays.triangulates()) return true;
  const auto receivers = rays.receivers(ray);
  return std::any_of(receivers.begin(), receivers.end(),
                     [&](const Vec3& receiver) { return normal.dot(receiver - point) > 0.0; });
}

Agreement between(std::span<const Agreement> agreements, std::size_t n, std::size_t i, std::size_t j) {
  Agreement both = agreements[i * n + j];
  both += agreements[j * n + i];
  return both;
}

}  // namespace

Agreement& Agreement::operator+=(const Agreement& other) {
  paired += other.paired;
  through += other.through;
  empty += other.empty;
  turned += other.turned;
  behind += other.behind;
  return *this;
}

double Agreement::contradiction(double mayMiss) const {
  const double all = expected();
  return all > 0.0 ? through / all + std::max(0.0, empty / all - mayMiss) : 0.0;
}

Agreement agreementOf(const PreparedView& from, const PreparedView& to, const Pose& T_to_from, const PairGates& gates,
                      std::size_t count, const Hiding& hiding) {
  const auto ids = thinned(allIndices(from.points.size()), count);
  std::vector<std::optional<GridPosition>> positions(ids.size());
  std::vector<Pair> pairs(ids.size());
  findPairs(from.points, ids, T_to_from, to.surface, gates, positions, Progress(), pairs);
  Agreement found;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (pairs[k].state == PairState::Paired) found.paired += 1.0;
    if (pairs[k].state == PairState::InFront) found.through += 1.0;
    if (pairs[k].state == PairState::Turned) found.turned += 1.0;
    if (pairs[k].state == PairState::Behind) found.behind += 1.0;
    if (pairs[k].state != PairState::Unseen || !positions[k]) continue;
    const Vec3 normal = T_to_from.linear() * from.points.normalAt(ids[k]);
    if (normal.dot(to.surface.directionAt(*positions[k])) > -kPlainlyFacing) continue;
    if (!to.surface.isEmptyAround(*positions[k])) continue;
    const RayGrid& rays = *to.image->rays;
    const std::size_t ray = rays.nearest(*positions[k]);
    const Vec3 point = T_to_from * from.points.pointAt(ids[k]);
    if (!facesReceiver(point, normal, rays, ray)) continue;
    if (hiding.surface != nullptr && hiding.surface->hides(point, rays, ray, hiding.T_surface_to)) continue;
    found.empty += 1.0;
  }
  return found;
}

std::vector<Agreement> agreements(std::span<const PreparedView> views, std::span<const Pose> poses,
                                  const PairGates& gates, std::size_t count, const Progress& progress) {
  const std::size_t n = views.size();
  std::vector<Agreement> all(n * n);
  parallelChunks(n * n, 1, progress, [&](std::size_t k, std::size_t) {
    const std::size_t i = k / n;
    const std::size_t j = k % n;
    if (i != j) all[k] = agreementOf(views[i], views[j], poses[j].inverse() * poses[i], gates, count);
  });
  return all;
}

Agreement agreementWithOthers(std::span<const PreparedView> views, std::span<const Pose> poses, std::size_t view,
                              const PairGates& gates, std::size_t count, const KnownSurface* known,
                              const Progress& progress) {
  std::vector<Agreement> each(views.size());
  parallelChunks(views.size(), 1, progress, [&](std::size_t i, std::size_t) {
    if (i == view) return;
    each[i] = agreementOf(views[i], views[view], poses[view].inverse() * poses[i], gates, count, {known, poses[view]});
    each[i] += agreementOf(views[view], views[i], poses[i].inverse() * poses[view], gates, count, {known, poses[i]});
  });
  Agreement all;
  for (const Agreement& agreement : each) all += agreement;
  return all;
}

bool contradict(const Agreement& both, double most, double mayMiss) {
  const bool plainly = both.through >= kMayFly || both.empty > mayMiss * both.expected();
  return plainly && both.expected() >= kFewest && both.contradiction(mayMiss) > most;
}

std::vector<std::optional<double>> contradicting(std::span<const Agreement> agreements, std::span<const int> trust,
                                                 double most) {
  const std::size_t n = trust.size();
  std::vector<std::size_t> in;
  for (std::size_t i = 0; i < n; ++i)
    if (trust[i] >= 0) in.push_back(i);
  const auto withSet = [&](std::size_t i) {
    Agreement sum;
    for (const std::size_t j : in)
      if (j != i) sum += between(agreements, n, i, j);
    return sum;
  };
  std::vector<std::size_t> out;
  while (true) {
    std::tuple<int, int, double, std::size_t> worst{0, 0, 0.0, 0};
    for (const std::size_t i : in) {
      int count = 0;
      for (const std::size_t j : in)
        if (j != i && contradict(between(agreements, n, i, j), most)) ++count;
      worst = std::max(worst, {count, -trust[i], withSet(i).contradiction(), i});
    }
    if (std::get<0>(worst) == 0) break;
    out.push_back(std::get<3>(worst));
    std::erase(in, out.back());
  }
  std::vector<std::optional<double>> result(n);
  for (const std::size_t i : out) result[i] = withSet(i).contradiction();
  return result;
}

}  // namespace vantage
