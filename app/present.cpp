#include "present.h"

#include <variant>

#include "acquisition/further_scan.h"
#include "acquisition/stand_composites.h"
#include "acquisition/table_place.h"
#include "ending_text.h"
#include "session/table_note.h"

namespace vantage {

Present Present::before(int firstView, std::optional<int> table) {
  Present present;
  present.firstView_ = firstView;
  present.table_ = table;
  return present;
}

Present Present::of(const Session& session) {
  Present present;
  const History& history = session.history();
  present.state_ = session.state();
  present.moments_ = momentsOf(history);
  present.cursor_ = static_cast<int>(history.cursor());
  present.table_ = vantage::tablePosition(session);
  const AcquisitionState object = withObject(*present.state_);
  if (object.model) present.completeness_ = completenessOf(object);
  // Only of the moment that holds is known what an end leaves.
  if (std::holds_alternative<Finish>(history.current().command) && present.state_->termination != Termination::Running)
    present.moments_[history.cursor()].text = endingText(*present.state_);
  return present;
}

NextScan Present::next() const {
  if (state_) return nextScan(*state_);
  return ScanFrom{firstView_};
}

std::optional<int> Present::nextPosition() const {
  const NextScan following = next();
  const auto* scan = std::get_if<ScanFrom>(&following);
  return scan != nullptr ? std::optional(scan->position) : std::nullopt;
}

std::optional<int> Present::furtherPosition() const {
  if (!state_) return nextPosition();
  const auto further = furtherScan(*state_);
  return further ? std::optional(further->position) : std::nullopt;
}

std::optional<int> Present::proposedPosition() const {
  if (!state_) return nextPosition();
  const auto proposed = proposedScan(*state_);
  return proposed ? std::optional(proposed->position) : std::nullopt;
}

std::optional<Explanation> Present::explained(int position) const {
  const auto plan = state_ ? state_->plan : nullptr;
  if (!plan || position < 0 || position >= static_cast<int>(plan->scores.size())) return {};
  return explain(*plan, position);
}

}  // namespace vantage
