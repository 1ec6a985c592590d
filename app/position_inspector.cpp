#include "position_inspector.h"

#include <utility>

#include "acquisition/further_scan.h"
#include "acquisition/stand_composites.h"
#include "acquisition/steps.h"

namespace vantage {
namespace {

struct Computed {
  std::shared_ptr<const PlanningScene> scene;
  std::shared_ptr<const PositionSight> sight;
  std::shared_ptr<const ScannerPicture> picture;
};

Computed compute(const AcquisitionState& state, const Plan& plan, std::shared_ptr<const PlanningScene> scene,
                 int position, const Progress& progress) {
  if (!scene)
    scene = std::make_shared<const PlanningScene>(planInputOf(state), plan.voids, stepOptionsFor(state).planner,
                                                  progress.part(0.0, 0.4));
  Computed result;
  result.sight = std::make_shared<const PositionSight>(computePositionSight(*scene, position, progress.part(0.4, 0.6)));
  result.picture =
      std::make_shared<const ScannerPicture>(computeScannerPicture(*scene, position, progress.part(0.6, 1.0)));
  result.scene = std::move(scene);
  return result;
}

// Whether a scan from there did not fit, and none has found its place since.
bool failedFrom(const AcquisitionState& state, int position) {
  bool failed = false;
  for (const KeptScan& scan : state.scans) {
    if (scan.station().stand != state.stand()) continue;
    if (scan.status == ScanStatus::In) failed = false;
    if (scan.status == ScanStatus::Rejected) failed = failed || scan.station().position == position;
  }
  return failed;
}

}  // namespace

PositionRole roleOf(const AcquisitionState& state, int position) {
  const bool next = nextPosition(state) == position;
  if (next && state.chosenPosition) return PositionRole::OperatorsChoice;
  if (failedFrom(state, position)) return PositionRole::Failed;
  const auto further = furtherScan(state);
  if (!further || further->position != position) return PositionRole::None;
  if (!next) return PositionRole::Further;
  return state.plan && state.plan->position == position ? PositionRole::Proposed : PositionRole::AfterFailure;
}

void PositionInspector::inspect(const std::shared_ptr<const AcquisitionState>& state, int position) {
  const auto plan = state ? state->plan : nullptr;
  if (!plan || !state->profile || position < 0 || position >= static_cast<int>(plan->scores.size())) return forget();
  jobs_.cancel(job_);
  insight_ = PositionInsight{explain(*plan, position), plan, nullptr, nullptr, roleOf(*state, position)};
  const auto proposed = proposedScan(*state);
  insight_->composite = compositeInWork(*state);
  insight_->planHolds = !proposed || proposed->position == plan->position;
  emit changed();
  if (!plan->voids || !state->model) return;
  if (scenePlan_ != plan) scene_.reset();
  scenePlan_ = plan;
  job_ = jobs_.run<Computed>(
      {},
      [state, plan, scene = scene_, position](const Progress& progress) {
        return compute(*state, *plan, scene, position, progress);
      },
      [this, question = ++question_](JobResult<Computed> result) {
        if (question != question_ || !result.value || !insight_) return;
        scene_ = std::move(result.value->scene);
        insight_->sight = std::move(result.value->sight);
        insight_->picture = std::move(result.value->picture);
        emit changed();
      });
}

void PositionInspector::forget() {
  jobs_.cancel(job_);
  ++question_;
  if (!insight_) return;
  insight_.reset();
  emit changed();
}

}  // namespace vantage
