#include "acquisition/steps.h"

#include <algorithm>

#include "acquisition/import_scans.h"
#include "base/errors.h"
#include "geometry/measures.h"
#include "registration/pose_prior.h"
#include "registration/registration_target.h"

namespace vantage {
namespace {

// After so many moves nothing is known of where the table is.
constexpr std::int64_t kMostMoves = 10'000;

RegistrationResult firstRegistration(const Pose& T_object_scanner) {
  RegistrationResult result;
  result.T_object_scanner = T_object_scanner;
  result.verdict = Verdict::Good;
  result.finding.reason = VerdictReason::FirstView;
  result.inlierShare = 1.0;
  return result;
}

// What is known of the motion from one scan to a later one: the table moved for every scan in between, also for those
// that are no views.
std::optional<PosePrior> priorOf(const StepOptions& options, std::int64_t from, std::int64_t to) {
  if (!options.mechanics) return options.registration.prior;
  return turntablePrior(*options.mechanics, static_cast<int>(std::clamp<std::int64_t>(to - from, 1, kMostMoves)));
}

RegistrationResult registerWithModel(const AcquisitionState& state, const View& view, std::int64_t scan,
                                     const StepOptions& options, const Progress& progress) {
  if (state.views.empty()) return firstRegistration(view.T_object_scanner);
  const RegistrationTarget target(state.model->mesh, state.model->confidence);
  IcpOptions registration = options.registration;
  registration.prior = priorOf(options, state.records.back().scan, scan);
  return registerView(*view.mesh, *view.image->rays, view.T_object_scanner, target, registration, progress);
}

// Moves the views, of scans with these numbers, to where all of them and the mechanics agree best.
void refine(std::vector<View>& views, std::span<const std::int64_t> scans, const StepOptions& options,
            const Progress& progress) {
  if (views.size() < 2) return;
  MultiViewOptions refinement = options.refinement;
  for (std::size_t i = 1; i < views.size(); ++i) {
    const Pose T_from_to = views[i - 1].image->T_object_scanner.inverse() * views[i].image->T_object_scanner;
    if (const auto prior = priorOf(options, scans[i - 1], scans[i]))
      refinement.ties.push_back({i - 1, i, T_from_to, *prior});
  }
  const MultiViewResult refined = refineViews(views, refinement, progress);
  for (std::size_t i = 0; i < views.size(); ++i) views[i].T_object_scanner = refined.poses[i];
}

}  // namespace

StepOptions stepOptionsFor(const ScannerProfile& profile, const AcquisitionSettings& settings) {
  StepOptions options;
  options.triangulation.breakdownAngle = profile.breakdownAngle;
  options.zipper.breakdownAngle = profile.breakdownAngle;
  options.planner.tolerance = settings.tolerance;
  options.mechanics = profile.mechanics;
  return options;
}

StepOptions stepOptionsFor(const AcquisitionState& state) {
  if (state.profile) return stepOptionsFor(*state.profile, state.settings);
  const ImportOptions recorded;
  StepOptions options;
  options.triangulation = recorded.triangulation;
  options.zipper = recorded.zipper;
  options.consensus = recorded.consensus;
  return options;
}

Pose expectedPose(const AcquisitionState& state, const RangeImage& image) {
  if (state.views.empty()) return image.T_object_scanner;
  const View& last = state.views.back();
  return last.T_object_scanner * last.image->T_object_scanner.inverse() * image.T_object_scanner;
}

AcquisitionState addScan(const AcquisitionState& state, const NumberedScan& scan,
                         std::optional<PositionScore> predicted, const StepOptions& options, const Progress& progress) {
  const Progress registering = progress.part(0.0, 0.5, name(Phase::Register));
  registering.checkpoint(0.0);
  View view;
  view.image = scan.image;
  view.mesh = std::make_shared<const ViewMesh>(triangulate(*view.image, options.triangulation));
  view.T_object_scanner = expectedPose(state, *view.image);

  AcquisitionState next = state;
  if (view.mesh->mesh.empty() && state.views.empty())
    throw InvalidInput("the first scan, from position " + std::to_string(view.image->position) +
                       ", has no surface: is the object inside the viewing volume?");
  RegistrationResult registration = registerWithModel(state, view, scan.number, options, registering.part(0.0, 0.7));
  if (registration.verdict == Verdict::Failed) {
    next.rejected.push_back({scan.number, view.image, std::move(registration)});
    return next;
  }
  view.T_object_scanner = registration.T_object_scanner;
  next.views.push_back(view);
  std::vector<std::int64_t> scans;
  scans.reserve(next.records.size() + 1);
  for (const ViewRecord& earlier : next.records) scans.push_back(earlier.scan);
  scans.push_back(scan.number);
  refine(next.views, scans, options, registering.part(0.7, 1.0));

  const Progress integrating = progress.part(0.5, 1.0, name(Phase::Integrate));
  const Model before = state.model ? reposed(*state.model, next.views) : Model{};
  const auto added = static_cast<std::uint32_t>(next.views.size() - 1);
  const Integration integration = integrateView(before, next.views, added, options.zipper, integrating.part(0.0, 0.6));
  next.model = std::make_shared<const Model>(
      applyConsensus(integration.model, next.views, options.consensus, integrating.part(0.6, 1.0)));

  ViewRecord record;
  record.scan = scan.number;
  record.position = view.image->position;
  record.samples = view.image->sampleCount();
  record.triangles = view.mesh->mesh.triangles.size();
  record.predicted = std::move(predicted);
  record.registration = std::move(registration);
  record.newArea = std::max(0.0, area(integration.model.mesh) - area(before.mesh));
  record.overlapArea = std::max(0.0, area(view.mesh->mesh) - record.newArea);
  next.records.push_back(std::move(record));
  return next;
}

std::shared_ptr<const Model> integrateViews(const std::vector<View>& views, const StepOptions& options,
                                            const Progress& progress) {
  const Integration integration = zipper(views, options.zipper, progress.part(0.0, 0.7, name(Phase::Integrate)));
  return std::make_shared<const Model>(
      applyConsensus(integration.model, views, options.consensus, progress.part(0.7, 1.0, name(Phase::Integrate))));
}

AcquisitionState leaveOutView(const AcquisitionState& state, std::int64_t scan, const StepOptions& options,
                              const Progress& progress) {
  AcquisitionState next = state;
  const auto record =
      std::find_if(next.records.begin(), next.records.end(), [&](const auto& r) { return r.scan == scan; });
  if (record == next.records.end())
    throw InvalidInput("scan " + std::to_string(scan) + " cannot be left out: it is not a view of the model");
  if (next.views.size() == 1)
    throw InvalidInput("scan " + std::to_string(scan) + " cannot be left out: it is the only view of the model");
  const auto view = next.views.begin() + (record - next.records.begin());
  next.leftOut.push_back({*view, *record});
  std::sort(next.leftOut.begin(), next.leftOut.end(),
            [](const LeftOutView& a, const LeftOutView& b) { return a.record.scan < b.record.scan; });
  next.views.erase(view);
  next.records.erase(record);
  next.model = integrateViews(next.views, options, progress);
  return next;
}

AcquisitionState takeBackView(const AcquisitionState& state, std::int64_t scan, const StepOptions& options,
                              const Progress& progress) {
  AcquisitionState next = state;
  const auto out = std::find_if(next.leftOut.begin(), next.leftOut.end(),
                                [&](const LeftOutView& v) { return v.record.scan == scan; });
  if (out == next.leftOut.end())
    throw InvalidInput("scan " + std::to_string(scan) + " cannot be taken back: it was not left out");
  const auto after =
      std::find_if(next.records.begin(), next.records.end(), [&](const auto& r) { return r.scan > scan; });
  next.views.insert(next.views.begin() + (after - next.records.begin()), out->view);
  next.records.insert(after, out->record);
  next.leftOut.erase(out);
  next.model = integrateViews(next.views, options, progress);
  return next;
}

Plan planAfter(const AcquisitionState& state, const ScannerImages& images, const StepOptions& options,
               const Progress& progress) {
  const int current = state.views.empty() ? -1 : state.views.back().image->position;
  return planNextView({*state.profile, images, *state.model, state.views, current}, options.planner, progress);
}

}  // namespace vantage
