#pragma once

#include <optional>
#include <variant>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// The next scan is taken from a position, as the object stands now.
struct ScanFrom {
  int position = 0;
  std::optional<PositionScore> predicted = {};  ///< what the plan promises of the position
};

/// A plan must be made before it is known.
struct PlanFirst {};

/// Nothing is scanned any more.
struct Ended {
  Termination termination = Termination::Finished;
};

/// What comes next.
using NextScan = std::variant<ScanFrom, PlanFirst, Ended>;

/// What comes after a state: the position that the operator chose, else the end that he wanted, else the plan's
/// position, else the strategy's. After a registration that failed, the best position with clearly more overlap; where
/// none has, a person is asked for the same position once more, then, or where too little overlapped, for half the
/// turn; a table that showed too little turns half as far. After four failures in a row the acquisition ends. Stands do
/// not count for each other: neither positions taken nor failures, nor towards the greatest number of views. Depends on
/// the state only, so that an interrupted run goes on as it would have.
[[nodiscard]] NextScan nextScan(const AcquisitionState& state);

/// The position of the next scan; nothing when there is none, or none yet.
[[nodiscard]] std::optional<int> nextPosition(const AcquisitionState& state);

/// Running as long as something comes next.
[[nodiscard]] Termination terminationOf(const NextScan& next);

}  // namespace vantage
