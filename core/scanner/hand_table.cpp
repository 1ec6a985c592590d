#include "scanner/hand_table.h"

#include <utility>

namespace vantage {

HandTable::HandTable(std::shared_ptr<const ScannerProfile> profile, AskPerson ask, std::optional<Mechanics> uncertainty)
    : profile_(std::move(profile)), ask_(std::move(ask)), uncertainty_(uncertainty) {}

ReachedPose HandTable::moveTo(int position, const Progress& progress) {
  const Pose& pose = workspacePose(*this, profile_->workspace, position);
  // Whoever is asked may have begun to turn it.
  where_.reset();
  progress.checkpoint(0.0);
  ask_(position, progress);
  where_ = ReachedPose{position, pose, PoseSource::ByHand, uncertainty_};
  return *where_;
}

}  // namespace vantage
