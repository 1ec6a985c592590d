#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "acquisition/next_scan.h"
#include "moments.h"
#include "planning/explanation.h"
#include "report/completeness.h"
#include "session/session.h"

namespace vantage {

using SharedState = std::shared_ptr<const AcquisitionState>;

/// Where a session is now: its state, the steps it came by, where the table stands; and from these what comes next. A
/// value; all that is shown of one moment is taken from one of them.
class Present {
 public:
  /// Before there is a session. @param firstView position of its first scan
  /// @param table where the table is taken to stand; nothing without positions
  [[nodiscard]] static Present before(int firstView, std::optional<int> table);
  [[nodiscard]] static Present of(const Session& session);

  /// Nothing before there is a session.
  [[nodiscard]] const SharedState& state() const { return state_; }
  [[nodiscard]] const std::vector<Moment>& moments() const { return moments_; }
  /// The moment that holds, of moments().
  [[nodiscard]] int cursor() const { return cursor_; }
  [[nodiscard]] bool somethingBefore() const { return cursor_ > 0; }
  [[nodiscard]] bool somethingUndone() const { return cursor_ + 1 < static_cast<int>(moments_.size()); }

  /// Where the table stands; nothing without positions.
  [[nodiscard]] std::optional<int> tablePosition() const { return table_; }
  [[nodiscard]] NextScan next() const;
  [[nodiscard]] std::optional<int> nextPosition() const;
  /// What would come next if the acquisition were opened again and allowed one more view.
  [[nodiscard]] std::optional<int> furtherPosition() const;
  /// The same, had the operator chosen no position.
  [[nodiscard]] std::optional<int> proposedPosition() const;
  /// How complete the object is; nothing without a model of it.
  [[nodiscard]] const std::optional<Completeness>& completeness() const { return completeness_; }
  /// What the plan that holds says of a position; nothing without a plan.
  [[nodiscard]] std::optional<Explanation> explained(int position) const;

 private:
  SharedState state_;
  std::vector<Moment> moments_;
  int cursor_ = 0;
  std::optional<int> table_;
  std::optional<Completeness> completeness_;
  int firstView_ = 0;
};

}  // namespace vantage
