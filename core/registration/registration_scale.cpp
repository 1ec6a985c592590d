#include "registration/registration_scale.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "registration/icp.h"
#include "registration/multi_view.h"

namespace vantage {
namespace {

constexpr double kGateSpacings = 0.5;
constexpr double kGateSigmas = 6.0;
constexpr double kCoarseShare = 1.0 / 12.0;
constexpr double kLeastCoarse = 4.0;  // [fine gates]
constexpr double kLooseShare = 1.0 / 40.0;
constexpr double kSureSpacings = 0.08;
constexpr double kSureSigmas = 0.5;
constexpr double kRefinementCoarse = 2.5;  // [fine gates]

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double coarseGate(const RegistrationScale& scale) {
  return std::max(kCoarseShare * scale.extent, kLeastCoarse * fineGate(scale));
}

}  // namespace

RegistrationScale scaleOf(const ViewSurface& surface) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : surface.view().mesh.vertices) box.extend(p);
  if (box.isEmpty()) return {};
  return {std::max(surface.view().spacing, 1e-6), surface.noise(), std::max(box.diagonal().norm(), 1e-6)};
}

RegistrationScale scaleOf(std::span<const RegistrationScale> views) {
  if (views.empty()) return {};
  std::vector<double> spacings;
  std::vector<double> noises;
  RegistrationScale scale{0.0, 0.0, 0.0};
  for (const RegistrationScale& view : views) {
    spacings.push_back(view.spacing);
    noises.push_back(view.noise);
    scale.extent = std::max(scale.extent, view.extent);
  }
  scale.spacing = median(std::move(spacings));
  scale.noise = median(std::move(noises));
  return scale;
}

double fineGate(const RegistrationScale& scale) {
  return kGateSpacings * scale.spacing + kGateSigmas * scale.noise;
}

double looseShift(const RegistrationScale& scale) {
  return kLooseShare * scale.extent;
}

IcpOptions resolved(const IcpOptions& options, const RegistrationScale& scale) {
  IcpOptions all = options;
  if (!all.finalGate) all.finalGate = std::min(fineGate(scale), all.coarseGate.value_or(fineGate(scale)));
  if (!all.coarseGate) all.coarseGate = std::max(coarseGate(scale), *all.finalGate);
  if (!all.hiddenDepth) all.hiddenDepth = coarseGate(scale);
  if (!all.limits.maxPoseSigma)
    all.limits.maxPoseSigma = std::max(kSureSpacings * scale.spacing, kSureSigmas * scale.noise);
  return all;
}

MultiViewOptions resolved(const MultiViewOptions& options, const RegistrationScale& scale) {
  MultiViewOptions all = options;
  if (!all.finalGate) all.finalGate = std::min(fineGate(scale), all.coarseGate.value_or(fineGate(scale)));
  if (!all.coarseGate) all.coarseGate = std::max(kRefinementCoarse * fineGate(scale), *all.finalGate);
  if (!all.hiddenDepth) all.hiddenDepth = coarseGate(scale);
  return all;
}

}  // namespace vantage
