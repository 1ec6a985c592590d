#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>

#include "acquisition/acquisition_state.h"
#include "job_runner.h"
#include "planning/explanation.h"
#include "planning/position_sight.h"
#include "planning/scanner_picture.h"

namespace vantage {

/// What a position is to the acquisition, beside what the plan says of it.
enum class PositionRole : std::uint8_t {
  None,
  Proposed,         ///< the next scan is taken from here, as the plan proposes
  OperatorsChoice,  ///< the next scan is taken from here, as the operator wants
  AfterFailure,     ///< the next scan is taken from here, as the one that the plan proposed did not fit
  Further,          ///< the acquisition has ended; it would come next if it went on
  Failed,           ///< a scan from here did not fit
};
[[nodiscard]] PositionRole roleOf(const AcquisitionState& state, int position);

/// All there is to say about one position. The explanation is the plan's own record; sight and picture are computed
/// from the model with the scanner's rays.
struct PositionInsight {
  Explanation why;
  std::shared_ptr<const Plan> plan;
  std::shared_ptr<const PositionSight> sight;     ///< null until it is computed
  std::shared_ptr<const ScannerPicture> picture;  ///< null until it is computed
  PositionRole role = PositionRole::None;
  bool planHolds = true;  ///< what the plan proposes is proposed still: no scan has failed since
  int composite = 0;      ///< that the plan is for: 0, the object, or a stand that is not put together with it yet
};

/// Answers "why this view, why not that one" for a position of a state. The record is told at once, what has to be
/// computed follows; of questions that overtake each other only the last is answered.
class PositionInspector final : public QObject {
  Q_OBJECT

 public:
  explicit PositionInspector(JobRunner& jobs, QObject* parent = nullptr) : QObject(parent), jobs_(jobs) {}

  /// Nothing is told of a state without a plan, or a position that it does not have.
  void inspect(const std::shared_ptr<const AcquisitionState>& state, int position);
  void forget();

  [[nodiscard]] const std::optional<PositionInsight>& insight() const { return insight_; }

 signals:
  void changed();

 private:
  JobRunner& jobs_;
  std::optional<PositionInsight> insight_;
  std::shared_ptr<const Plan> scenePlan_;       // what the scene was made of
  std::shared_ptr<const PlanningScene> scene_;  // null until the first question about the plan is answered
  JobRunner::Id job_ = 0;
  int question_ = 0;
};

}  // namespace vantage
