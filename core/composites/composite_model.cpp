#include "composites/composite_model.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/errors.h"
#include "composites/alignment_limits.h"
#include "registration/icp.h"

namespace vantage {
namespace {

constexpr std::array<std::size_t, kPointLevels> kCounts{300, 1500, 8000};

void check(const Composite& composite) {
  if (composite.views.empty()) throw InvalidInput("a composite has no views, so there is nothing to align");
  for (const View& view : composite.views)
    if (!view.image || !view.mesh) throw InvalidInput("a view of a composite lacks its image or its mesh");
  if (!composite.model || composite.model->mesh.empty())
    throw InvalidInput("a composite has no surface, so there is nothing to align");
  const auto views = composite.views.size();
  if (composite.model->vertexView.size() != composite.model->mesh.vertices.size())
    throw InvalidInput("the model of a composite does not say which views its vertices are from");
  for (const std::uint32_t view : composite.model->vertexView)
    if (view >= views)
      throw InvalidInput("the model of a composite has a vertex of view " + std::to_string(view) + ", there are " +
                         std::to_string(views) + " views");
  for (const PoseTie& tie : composite.ties)
    if (tie.from >= views || tie.to >= views || tie.from == tie.to)
      throw InvalidInput("a tie of a composite leads from view " + std::to_string(tie.from) + " to view " +
                         std::to_string(tie.to) + ", expected two of " + std::to_string(views) + " views");
}

// Points of the links between the views that say how well these fit each other.
constexpr std::size_t kLinkPoints = 20'000;
constexpr std::size_t kLeastLinkPoints = 200;
constexpr double kLeastOverlap = 0.1;

double residualOf(const std::vector<View>& views, std::span<const PreparedView> prepared, const Progress& progress) {
  std::vector<Pose> poses;
  for (const View& view : views) poses.push_back(view.T_object_scanner);
  const RegistrationScale scale = scaleOf(prepared);
  const PairGates gates{fineGate(scale), *resolved(IcpOptions{}, scale).hiddenDepth, IcpOptions{}.finalAngle};
  std::vector<ViewLink> links =
      findLinks(prepared, poses, gates, kLeastOverlap, kLinkPoints, kLeastLinkPoints, progress.part(0.0, 0.8));
  findPairs(prepared, poses, gates, progress.part(0.8, 1.0), links);
  return deviation(links);
}

}  // namespace

CompositeModel::CompositeModel(Composite composite, const Progress& all) : composite_(std::move(composite)) {
  check(composite_);
  const Progress progress = all.part(0.0, 1.0, "prepare");
  surface_ = std::make_shared<const CompositeSurface>(composite_.model->mesh, progress.part(0.0, 0.1));
  std::array<std::vector<std::uint32_t>, kPointLevels> points;
  for (std::size_t level = 0; level < points.size(); ++level) {
    progress.checkpoint(0.1);
    points[level] = surface_->spread(kCounts[level]);
  }
  points_ = std::make_shared<const std::array<std::vector<std::uint32_t>, kPointLevels>>(std::move(points));
  if (this->points(PointLevel::Fine).empty())
    throw InvalidInput("a composite has no surface away from its border, so there is nothing to align");
  prepared_ =
      std::make_shared<const std::vector<PreparedView>>(prepareViews(composite_.views, progress.part(0.1, 0.3)));
  residual_ = residualOf(composite_.views, *prepared_, progress.part(0.3, 0.4));
  scale_ = scaleOf(*prepared_);
  measure();
  const AlignmentLimits limits = limitsOf(scale_, scale_);
  field_ = std::make_shared<const VoxelField>(surface_->points(), composite_.views, limits.voxel(), limits.margin(),
                                              progress.part(0.4, 0.8));
  caster_ =
      std::make_shared<const RayCaster>(composite_.model->mesh, RayCaster::Precision::Fast, progress.part(0.8, 1.0));
}

void CompositeModel::measure() {
  const auto fine = points(PointLevel::Fine);
  centroid_ = Vec3::Zero();
  for (const std::uint32_t i : fine) centroid_ += surface_->point(i);
  centroid_ /= static_cast<double>(fine.size());
  double squares = 0.0;
  double farthest = 0.0;
  for (const std::uint32_t i : fine) {
    const double square = (surface_->point(i) - centroid_).squaredNorm();
    squares += square;
    farthest = std::max(farthest, square);
  }
  radius_ = std::max(std::sqrt(squares / static_cast<double>(fine.size())), 1e-6);
  scale_.extent = std::max(2.0 * std::sqrt(farthest), 1e-6);
}

CompositeModel CompositeModel::withPoses(std::span<const Pose> poses) const {
  CompositeModel other = *this;
  std::vector<Pose> motions;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    motions.push_back(poses[i] * composite_.views[i].T_object_scanner.inverse());
    other.composite_.views[i].T_object_scanner = poses[i];
  }
  other.surface_ = std::make_shared<const CompositeSurface>(surface_->moved(motions, composite_.model->vertexView));
  other.measure();
  return other;
}

}  // namespace vantage
