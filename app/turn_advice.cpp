#include "turn_advice.h"

#include <cmath>

namespace vantage {

std::optional<TurnAdvice> adviseTurn(const ScannerProfile& profile, std::optional<int> from, int to) {
  const Workspace& workspace = profile.workspace;
  const auto exists = [&](int position) { return position >= 0 && position < static_cast<int>(workspace.size()); };
  if (workspace.steps == 0 || !from || !exists(*from) || !exists(to)) return {};
  const auto azimuth = [&](int position) {
    const Vec3 scanner =
        workspace.poses[static_cast<std::size_t>(position)] * profile.rays->ray(profile.rays->size() / 2).origin;
    return std::atan2(scanner.y(), scanner.x());
  };
  return TurnAdvice{azimuth(*from), azimuth(to), turnBetween(workspace, *from, to)};
}

}  // namespace vantage
