#include "acquisition/further_scan.h"

#include <algorithm>

namespace vantage {

std::optional<ScanFrom> furtherScan(const AcquisitionState& state) {
  AcquisitionState open = state;
  open.termination = Termination::Running;
  open.settings.maxViews = std::max(open.settings.maxViews, static_cast<int>(state.scans.size()) + 1);
  const NextScan next = nextScan(open);
  const auto* scan = std::get_if<ScanFrom>(&next);
  return scan != nullptr ? std::optional(*scan) : std::nullopt;
}

std::optional<ScanFrom> proposedScan(const AcquisitionState& state) {
  AcquisitionState unchosen = state;
  unchosen.chosenPosition.reset();
  return furtherScan(unchosen);
}

}  // namespace vantage
