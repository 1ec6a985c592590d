#include "scanner/simulated_table.h"

#include <utility>

#include "base/random.h"

namespace vantage {
namespace {

// The stream of random numbers of the first move; every move has one of its own.
constexpr std::uint64_t kMechanicsStream = 0x6d65636861ULL << 24;

}  // namespace

SimulatedTable::SimulatedTable(std::shared_ptr<const ScannerProfile> profile, const SimulationOptions& options,
                               int scansBefore)
    : profile_(std::move(profile)), options_(options), scans_(scansBefore) {}

Pose SimulatedTable::mechanicalError(int ordinal) const {
  Pose error = Pose::Identity();
  if (options_.ideal) return error;
  for (int move = 1; move <= ordinal; ++move) {
    Random random(options_.seed, kMechanicsStream + static_cast<std::uint64_t>(move));
    Pose step = Pose::Identity();
    // Drawn one by one: the order among the arguments of a call is the compiler's.
    const double y = profile_->mechanics.positionSigma * random.normal();
    const double x = profile_->mechanics.positionSigma * random.normal();
    step.translate(Vec3(x, y, 0.0));
    step.rotate(Eigen::AngleAxisd(profile_->mechanics.angleSigma * random.normal(), Vec3::UnitZ()));
    error = error * step;
  }
  return error;
}

ReachedPose SimulatedTable::moveTo(int position, const Progress& progress) {
  const Pose& commanded = workspacePose(*this, profile_->workspace, position);
  progress.checkpoint(0.0);
  truth_ = mechanicalError(scans_) * commanded;
  where_ = ReachedPose{position, commanded, PoseSource::Commanded, profile_->mechanics};
  return *where_;
}

}  // namespace vantage
