#include "acquisition/may_do.h"

#include "acquisition/next_scan.h"

namespace vantage {

std::optional<Refusal> mayDo(const AcquisitionState& state, const Command& command) {
  return std::visit([&](const auto& c) { return c.mayDo(state); }, command);
}

std::optional<Refusal> mayScan(const AcquisitionState& state) {
  if (!state.profile) return Refusal{RefusalReason::NoProfile, {}};
  const NextScan next = nextScan(state);
  switch (terminationOf(next)) {
    case Termination::Running:
      return {};
    case Termination::MaxViews:
      return Refusal{RefusalReason::LimitReached, state.settings.maxViews};
    case Termination::EndedByOperator:
    case Termination::Imported:
      return Refusal{RefusalReason::AlreadyEnded, {}};
    default:
      return Refusal{RefusalReason::NothingLeft, {}};
  }
}

}  // namespace vantage
