#include "position_inspector.h"

namespace vantage {
namespace {

double meanSpacing(const std::vector<View>& views) {
  double sum = 0.0;
  for (const View& view : views) sum += view.mesh->spacing;
  return sum / static_cast<double>(views.size());
}

struct Computed {
  std::shared_ptr<const PositionSight> sight;
  std::shared_ptr<const ScannerPicture> picture;
};

Computed compute(const AcquisitionState& state, const Plan& plan, int position, const Progress& progress) {
  const Pose& pose = state.profile->workspace.poses[static_cast<std::size_t>(position)];
  Computed result;
  result.sight = std::make_shared<const PositionSight>(lookFrom(pose, plan.voids->patches, *state.model, *state.profile,
                                                                meanSpacing(viewsOf(state)), progress.part(0.0, 0.5)));
  result.picture = std::make_shared<const ScannerPicture>(
      computeScannerPicture(*state.profile, position, *state.model, plan.voids.get(), progress.part(0.5, 1.0)));
  return result;
}

}  // namespace

void PositionInspector::inspect(const std::shared_ptr<const AcquisitionState>& state, int position) {
  const auto plan = state ? state->plan : nullptr;
  if (!plan || !state->profile || position < 0 || position >= static_cast<int>(plan->scores.size())) return forget();
  jobs_.cancel(job_);
  insight_ = PositionInsight{explain(*plan, position), plan, nullptr, nullptr};
  emit changed();
  if (!plan->voids || !state->model) return;
  job_ = jobs_.run<Computed>(
      {}, [state, plan, position](const Progress& progress) { return compute(*state, *plan, position, progress); },
      [this, question = ++question_](JobResult<Computed> result) {
        if (question != question_ || !result.value || !insight_) return;
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
