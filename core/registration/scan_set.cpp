#include "registration/scan_set.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "registration/view_agreement.h"

namespace vantage {
namespace {

// Points of a view that are looked up on another one to find whether they contradict.
constexpr std::size_t kAsked = 1000;
// Share of contradicting points beyond which two views are not of the same thing in the same place.
constexpr double kMostContradiction = 0.015;
// What lies so many spacings in front was looked through.
constexpr double kThroughSpacings = 2.0;
// What lies nearer to a point, in these distances, is the point's own surface and does not hide it.
constexpr double kHidesBeyond = 2.0;
// Where the pose is doubtful less emptiness speaks against it: right scans miss a twentieth of what others saw.
constexpr double kMayMissInDoubt = 0.15;
constexpr int kMostRounds = 3;
constexpr int kGood = 2;
constexpr int kDoubtful = 1;
constexpr int kOut = -1;

// How far off what was looked up may lie.
PairGates gatesFor(const RegistrationScale& scale, const IcpOptions& options) {
  return {std::max(kThroughSpacings * scale.spacing, fineGate(scale)), *resolved(options, scale).hiddenDepth,
          options.finalAngle};
}

class Judge {
 public:
  Judge(std::span<const View> views, std::span<const PreparedView> prepared, const AlignmentOptions& options)
      : views_(views), prepared_(prepared), options_(options), scale_(scaleOf(prepared)) {}

  ScanSet run(std::span<const Pose> given, const Progress& progress) {
    given_ = given;
    known_ = std::all_of(views_.begin(), views_.end(),
                         [](const View& view) { return view.image->poseKnownBy != PoseSource::Unknown; });
    set_.placement = placeViews(prepared_, given, options_, progress.part(0.0, 0.5));
    for (int round = 0; round < kMostRounds; ++round) {
      const Progress part = progress.part(0.5 + 0.15 * round, 0.65 + 0.15 * round);
      refine(part.part(0.0, 0.8));
      if (!removeContradictions(given, part.part(0.8, 1.0))) break;
    }
    liftDoubts(progress.part(0.95, 1.0));
    return std::move(set_);
  }

 private:
  [[nodiscard]] std::vector<std::size_t> sorted() const {
    std::vector<std::size_t> placed = set_.placement.order;
    std::sort(placed.begin(), placed.end());
    return placed;
  }

  void refine(const Progress& progress) {
    const std::vector<std::size_t> placed = sorted();
    std::vector<View> toRefine;
    for (const std::size_t i : placed) {
      toRefine.push_back(views_[i]);
      toRefine.back().T_object_scanner = set_.placement.poses[i];
    }
    MultiViewOptions refinement = options_.refinement;
    if (known_)
      for (const std::size_t i : placed) refinement.given.push_back(given_[i]);
    set_.refinement = refineViews(toRefine, refinement, progress);
    for (std::size_t k = 0; k < placed.size(); ++k) set_.placement.poses[placed[k]] = set_.refinement.poses[k];
  }

  // @return whether there were any
  bool removeContradictions(std::span<const Pose> given, const Progress& progress) {
    PlacedViews& placement = set_.placement;
    std::vector<int> trust(views_.size(), kOut);
    for (const std::size_t i : placement.order)
      trust[i] = placement.views[i].verdict == Verdict::Good ? kGood : kDoubtful;
    const auto all = agreements(prepared_, placement.poses, gatesFor(scale_, options_.icp), kAsked, progress);
    const auto out = contradicting(all, trust, kMostContradiction);
    bool any = false;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      if (!out[i]) continue;
      any = true;
      placement.views[i].verdict = Verdict::Failed;
      placement.views[i].finding = {VerdictReason::ContradictsOthers, *out[i], {}};
      placement.poses[i] = given[i];
      std::erase(placement.order, i);
    }
    return any;
  }

  // All others together may hold what those placed before a view did not.
  void liftDoubts(const Progress& progress) {
    PlacedViews& placement = set_.placement;
    for (const std::size_t i : sorted()) {
      const VerdictReason reason = placement.views[i].finding.reason;
      if (placement.views[i].verdict != Verdict::Doubtful || reason == VerdictReason::Motion) continue;
      OrientedPoints others;
      for (const std::size_t j : placement.order)
        if (j != i)
          others.append(thinnedPoints(prepared_[j].points, options_.sampling.pointsPerView), placement.poses[j]);
      IcpOptions icp = options_.icp;
      icp.finePoints = options_.sampling.finePoints;
      const RegistrationResult again =
          registerView(prepared_[i].surface, placement.poses[i], RegistrationTarget(std::move(others)), icp, progress);
      if (again.verdict == Verdict::Good)
        placement.views[i] = {again.verdict, again.finding, again.rms, again.inlierShare};
    }
  }

  std::span<const View> views_;
  std::span<const PreparedView> prepared_;
  const AlignmentOptions& options_;
  RegistrationScale scale_;
  std::span<const Pose> given_;
  bool known_ = false;  // whether somebody said where the scans were taken
  ScanSet set_;
};

}  // namespace

double ScanSet::worth() const {
  double sum = 0.0;
  for (const std::size_t i : placement.order) sum += placement.views[i].verdict == Verdict::Good ? 1.0 : 0.5;
  return sum;
}

std::optional<double> contradictionOfLast(std::span<const View> views, std::span<const PreparedView> prepared,
                                          bool isDoubtful, const Mesh& known, const IcpOptions& options,
                                          const Progress& progress) {
  if (views.size() < 2) return std::nullopt;
  std::vector<Pose> poses;
  for (const View& view : views) poses.push_back(view.T_object_scanner);
  const PairGates gates = gatesFor(scaleOf(prepared), options);
  const double mayMiss = isDoubtful ? kMayMissInDoubt : kMayMiss;
  const auto withOthers = [&](const KnownSurface* surface, const Progress& part) {
    return agreementWithOthers(prepared, poses, views.size() - 1, gates, kAsked, surface, part);
  };
  const auto contradicts = [&](const Agreement& all) { return contradict(all, kMostContradiction, mayMiss); };
  Agreement all = withOthers(nullptr, progress.part(0.0, 0.3));
  Agreement withoutEmpty = all;
  withoutEmpty.empty = 0.0;
  if (contradicts(all) && !contradicts(withoutEmpty)) {
    Mesh last = views.back().mesh->mesh;
    for (Vec3& vertex : last.vertices) vertex = poses.back() * vertex;
    const std::array<const Mesh*, 2> meshes{&known, &last};
    const KnownSurface surface(meshes, kHidesBeyond * gates.distance, progress.part(0.3, 0.7));
    all = withOthers(&surface, progress.part(0.7, 1.0));
  }
  if (!contradicts(all)) return std::nullopt;
  return all.contradiction(mayMiss);
}

ScanSet judgedSet(std::span<const View> views, std::span<const PreparedView> prepared, std::span<const Pose> given,
                  const AlignmentOptions& options, const Progress& progress) {
  return Judge(views, prepared, options).run(given, progress);
}

}  // namespace vantage
