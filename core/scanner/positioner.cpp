#include "scanner/positioner.h"

#include "base/errors.h"

namespace vantage {

const Pose& workspacePose(const Positioner& positioner, const Workspace& workspace, int position) {
  if (position < 0 || position >= static_cast<int>(workspace.size()))
    throw DeviceError(positioner.identity() + ": position " + std::to_string(position) +
                      " is not one of the workspace's " + std::to_string(workspace.size()));
  return workspace.poses[static_cast<std::size_t>(position)];
}

}  // namespace vantage
