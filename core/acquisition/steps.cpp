#include "acquisition/steps.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "geometry/measures.h"
#include "integration/zipper.h"
#include "registration/pose_prior.h"
#include "registration/position_search.h"
#include "registration/registration_scale.h"
#include "registration/registration_target.h"
#include "registration/scan_set.h"

namespace vantage {
namespace {

// After so many moves nothing is known of where the table is.
constexpr std::int64_t kMostMoves = 10'000;
// A registration finds its way from so far [rad].
constexpr double kReach = radians(3.0);
// Hands are not trusted beyond so many sigmas.
constexpr double kFarthest = 2.5;

RegistrationResult firstRegistration(const Pose& T_object_scanner) {
  RegistrationResult result;
  result.T_object_scanner = T_object_scanner;
  result.verdict = Verdict::Good;
  result.finding.reason = VerdictReason::FirstView;
  result.inlierShare = 1.0;
  return result;
}

// What is known of the motion from one scan to a later one: the table moved for every scan in between, also for those
// that are no views. Who turned it by hand begins anew every time.
std::optional<PosePrior> priorOf(const StepOptions& options, const KeptScan& from, const KeptScan& to) {
  const RangeImage& image = *to.view.image;
  const std::optional<Mechanics>& mechanics = image.poseUncertainty ? image.poseUncertainty : options.mechanics;
  if (!mechanics) return options.registration.prior;
  if (image.poseKnownBy == PoseSource::ByHand) return turntablePrior(*mechanics);
  const auto moves = std::clamp<std::int64_t>(to.number - from.number, 1, kMostMoves);
  return turntablePrior(*mechanics, static_cast<int>(moves));
}

// Whether a registration would not reach as far as the pose may be off.
bool isFarOff(const RangeImage& image) {
  return image.poseUncertainty && image.poseUncertainty->angleSigma > kReach;
}

// Where a scan would be if its table had turned by so much less or more than is said.
std::vector<Pose> turnedPoses(const AcquisitionState& state, const RangeImage& image, double upTo) {
  std::vector<Pose> poses;
  RangeImage turned = image;
  const int steps = static_cast<int>(std::ceil(upTo / kReach));
  for (int i = -steps; i <= steps; ++i) {
    turned.T_table_scanner = Eigen::AngleAxisd(kReach * i, Vec3::UnitZ()) * image.T_table_scanner;
    poses.push_back(expectedPose(state, turned));
  }
  return poses;
}

// The registration of a scan whose table a person turned, about as far as they were asked: first coarse, then fine.
RegistrationResult registerOnTurn(const AcquisitionState& state, const KeptScan& scan, const RegistrationTarget& target,
                                  const IcpOptions& options, const Progress& progress) {
  const View& view = scan.view;
  const ViewSurface surface(*view.mesh, *view.image->rays);
  IcpOptions free = options;
  free.prior.reset();
  const auto poses = turnedPoses(state, *view.image, kFarthest * view.image->poseUncertainty->angleSigma);
  const auto fits = poseThatFits(surface, poses, target, free, progress);
  if (!fits) return registerView(surface, view.T_object_scanner, target, options, progress);
  RegistrationResult found = fits->registration;
  if (fits->rivalDistance > 0.0 && found.verdict == Verdict::Good) {
    found.verdict = Verdict::Doubtful;
    found.finding = {VerdictReason::Rival, fits->rivalDistance, {}};
  }
  return found;
}

RegistrationResult registerWithModel(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options,
                                     const Progress& progress) {
  const View& view = scan.view;
  if (!state.model) return firstRegistration(view.T_object_scanner);
  const RegistrationTarget target(state.model->mesh, state.model->confidence);
  IcpOptions registration = options.registration;
  if (const KeptScan* last = lastView(state, scan.station().stand)) registration.prior = priorOf(options, *last, scan);
  if (isFarOff(*view.image)) return registerOnTurn(state, scan, target, registration, progress);
  return registerView(*view.mesh, *view.image->rays, view.T_object_scanner, target, registration, progress);
}

// What the mechanics know of the motions between views that follow each other in one stand. Between stands the object
// was moved by hand.
std::vector<PoseTie> tiesOf(const std::vector<const KeptScan*>& scans, const StepOptions& options) {
  std::vector<PoseTie> ties;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    if (scans[i - 1]->station().stand != scans[i]->station().stand) continue;
    if (scans[i]->record.registration.finding.reason == VerdictReason::TableSlipped) continue;
    const Pose T_from_to = scans[i - 1]->view.image->T_table_scanner.inverse() * scans[i]->view.image->T_table_scanner;
    if (const auto prior = priorOf(options, *scans[i - 1], *scans[i])) ties.push_back({i - 1, i, T_from_to, *prior});
  }
  return ties;
}

// What later scans may settle: where nothing spoke against the pose, and the mechanics alone for it.
bool waitsForMore(const RegistrationResult& registration) {
  const VerdictReason reason = registration.finding.reason;
  return registration.verdict == Verdict::Doubtful &&
         (reason == VerdictReason::HeldByMechanics || reason == VerdictReason::TableAlone);
}

// The pose of a doubtful view that all others together hold as firmly as a good one is certain.
void liftDoubt(KeptScan& scan, double poseSigma, const StepOptions& options) {
  RegistrationResult& registration = scan.record.registration;
  if (!waitsForMore(registration)) return;
  const ViewSurface surface(*scan.view.mesh, *scan.view.image->rays);
  if (poseSigma > *resolved(options.registration, scaleOf(surface)).limits.maxPoseSigma) return;
  registration.verdict = Verdict::Good;
  registration.finding = {VerdictReason::HeldByAll, std::nullopt, {}};
  registration.poseSigma = poseSigma;
}

// Moves the views to where all of them and the mechanics agree best.
void refine(AcquisitionState& state, const StepOptions& options, const Progress& progress) {
  const std::vector<View> views = viewsOf(state);
  if (views.size() < 2) return;
  MultiViewOptions refinement = options.refinement;
  refinement.ties = tiesOf(scansOf(state, ScanStatus::In), options);
  const MultiViewResult refined = refineViews(views, refinement, progress);
  std::size_t i = 0;
  for (KeptScan& scan : state.scans) {
    if (scan.status != ScanStatus::In) continue;
    scan.view.T_object_scanner = refined.poses[i];
    liftDoubt(scan, refined.poseSigmas[i++], options);
  }
}

void checkStation(const AcquisitionState& state, const KeptScan& scan) {
  const int stand = scan.station().stand;
  if (stand < 0 || stand > state.stand())
    throw InvalidInput("scan " + std::to_string(scan.number) + " is of stand " + std::to_string(stand) +
                       ", the object has stood in stands 0 to " + std::to_string(state.stand()));
}

// Where in the workspace a scan fits which does not fit its own position.
std::optional<FittingPose> otherPlace(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options,
                                      const Progress& progress) {
  if (!state.profile || !state.model || !scan.station().position) return std::nullopt;
  std::vector<Pose> candidates;
  RangeImage there = *scan.view.image;
  for (const Pose& T_table_scanner : state.profile->workspace.poses) {
    there.T_table_scanner = T_table_scanner;
    candidates.push_back(expectedPose(state, there));
  }
  IcpOptions registration = options.registration;
  registration.prior.reset();
  return poseThatFits(ViewSurface(*scan.view.mesh, *scan.view.image->rays), candidates,
                      RegistrationTarget(state.model->mesh, state.model->confidence), registration, progress);
}

// Whether a table moved by itself and said where to: a person may have meant another position.
bool movedByItself(const RangeImage& image) {
  return !image.takenWith.empty() &&
         (image.poseKnownBy == PoseSource::Commanded || image.poseKnownBy == PoseSource::Reported);
}

// How much farther than it said the table turned, when the scan was found there [deg], counter-clockwise from above.
double slipOf(const Pose& expected, const Pose& found) {
  const Eigen::Matrix3d turn = expected.linear() * found.linear().transpose();
  return degrees(std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1)));
}

// Whether the plan sent the scan where it shows nothing of the model.
bool plannedByTable(const AcquisitionState& state, const KeptScan& scan, const StepOptions& options) {
  return state.plan && state.plan->tableAlone && options.mechanics && state.plan->position == scan.station().position &&
         lastView(state, scan.station().stand) != nullptr;
}

// A scan that shows next to nothing of the model, as it was to be expected, and nothing against it, stays where the
// table has it.
void placeByTable(const KeptScan& scan, const StepOptions& options, RegistrationResult& found) {
  if (found.finding.reason != VerdictReason::FewPairs) return;
  if (found.conflictShare > options.registration.limits.maxConflicts) return;
  found.T_object_scanner = scan.view.T_object_scanner;
  found.verdict = Verdict::Doubtful;
  found.finding = {VerdictReason::TableAlone, static_cast<double>(found.pairs), {}};
}

void checkAgainstOthers(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                        const Progress& progress);

// A table that slipped, or was pushed, brought the scan elsewhere: it counts there, but nothing is good about it.
bool placeWhereSlipped(const AcquisitionState& state, KeptScan& scan, const FittingPose& fits,
                       const StepOptions& options, const Progress& progress) {
  if (!movedByItself(*scan.view.image) || fits.registration.verdict != Verdict::Good || fits.rivalDistance > 0.0)
    return false;
  KeptScan there = scan;
  there.record.registration = fits.registration;
  there.record.registration.verdict = Verdict::Doubtful;
  there.record.registration.finding = {
      VerdictReason::TableSlipped, slipOf(scan.view.T_object_scanner, fits.registration.T_object_scanner), {}};
  checkAgainstOthers(state, there, options, progress);
  if (there.record.registration.verdict == Verdict::Failed) return false;
  scan.record.registration = there.record.registration;
  return true;
}

// A scan that does not fit its own position may not have been meant to, or fit another.
void explainFailure(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                    const Progress& progress) {
  RegistrationResult& found = scan.record.registration;
  if (plannedByTable(state, scan, options)) return placeByTable(scan, options, found);
  const auto fits = otherPlace(state, scan, options, progress);
  if (!fits || placeWhereSlipped(state, scan, *fits, options, progress)) return;
  const int other = static_cast<int>(fits->candidate);
  if (other != *scan.station().position) found.finding = {VerdictReason::OtherPosition, static_cast<double>(other), {}};
}

// A scan that fits the model may still contradict what the views have looked through, or show emptiness where they saw
// surface.
void checkAgainstOthers(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                        const Progress& progress) {
  std::vector<View> views = viewsOf(state);
  views.push_back(scan.view);
  views.back().T_object_scanner = scan.record.registration.T_object_scanner;
  const bool isDoubtful = scan.record.registration.verdict == Verdict::Doubtful;
  const auto contradiction = contradictionOfLast(views, isDoubtful, options.registration, progress);
  if (!contradiction) return;
  scan.record.registration.verdict = Verdict::Failed;
  scan.record.registration.finding = {VerdictReason::ContradictsOthers, *contradiction, {}};
}

// Registers a scan and moves all views to where they agree best. @return whether it found its place
bool findPlace(AcquisitionState& state, KeptScan& scan, const StepOptions& options, const Progress& progress) {
  scan.view.T_object_scanner = expectedPose(state, *scan.view.image);
  scan.record.registration = registerWithModel(state, scan, options, progress.part(0.0, 0.6));
  const Progress checking = progress.part(0.6, 0.7);
  if (scan.record.registration.verdict == Verdict::Failed)
    explainFailure(state, scan, options, checking);
  else
    checkAgainstOthers(state, scan, options, checking);
  const bool found = scan.record.registration.verdict != Verdict::Failed;
  scan.status = found ? ScanStatus::In : ScanStatus::Rejected;
  if (found) scan.view.T_object_scanner = scan.record.registration.T_object_scanner;
  if (!found) scan.view.mesh = nullptr;
  return found;
}

// Nothing can be registered with, planned from or said of a model without surface.
[[noreturn]] void refuseEmpty(const KeptScan& first) {
  throw InvalidInput("the first scan, " +
                     (first.station().position ? "from position " + std::to_string(*first.station().position)
                                               : "number " + std::to_string(first.number)) +
                     ", has no surface (" + std::to_string(first.view.mesh->mesh.vertices.size()) +
                     " samples): is the object inside the viewing volume, large enough for the scanner's sampling, and "
                     "in the right unit?");
}

}  // namespace

Pose expectedPose(const AcquisitionState& state, const RangeImage& image) {
  const KeptScan* last = lastView(state, image.station.stand);
  if (last == nullptr)
    return *state.stands[static_cast<std::size_t>(image.station.stand)].T_object_table * image.T_table_scanner;
  return last->view.T_object_scanner * last->view.image->T_table_scanner.inverse() * image.T_table_scanner;
}

AcquisitionState addScan(const AcquisitionState& state, const NumberedScan& scan,
                         std::optional<PositionScore> predicted, const StepOptions& options, const Progress& progress) {
  const Progress registering = progress.part(0.0, 0.5, name(Phase::Register));
  registering.checkpoint(0.0);
  KeptScan added = keepAsView(scan, options.cut, options.triangulation);
  checkStation(state, added);
  AcquisitionState next = state;
  if (!state.stands[static_cast<std::size_t>(added.station().stand)].T_object_table) {
    added.status = ScanStatus::Waiting;
    added.view.mesh = nullptr;
    next.scans.push_back(std::move(added));
    return next;
  }
  if (added.view.mesh->mesh.empty() && !state.model) refuseEmpty(added);
  const bool found = findPlace(next, added, options, registering.part(0.0, 0.7));
  added.record.predicted = std::move(predicted);
  next.scans.push_back(std::move(added));
  if (!found) return next;
  refine(next, options, registering.part(0.7, 1.0));

  const Progress integrating = progress.part(0.5, 1.0, name(Phase::Integrate));
  const std::vector<View> views = viewsOf(next);
  const Model before = state.model ? reposed(*state.model, views) : Model{};
  const Integration integration = integrateView(before, views, static_cast<std::uint32_t>(views.size() - 1),
                                                options.zipper, integrating.part(0.0, 0.6));
  next.model = std::make_shared<const Model>(
      applyConsensus(integration.model, views, options.consensus, integrating.part(0.6, 1.0)));
  if (!state.model && next.model->mesh.triangles.empty()) refuseEmpty(next.scans.back());
  ScanRecord& record = next.scans.back().record;
  record.newArea = std::max(0.0, area(integration.model.mesh) - area(before.mesh));
  record.overlapArea = std::max(0.0, area(views.back().mesh->mesh) - record.newArea);
  return next;
}

std::shared_ptr<const Model> integrateViews(const std::vector<View>& views, const StepOptions& options,
                                            const Progress& progress) {
  const Integration integration = zipper(views, options.zipper, progress.part(0.0, 0.7, name(Phase::Integrate)));
  return std::make_shared<const Model>(
      applyConsensus(integration.model, views, options.consensus, progress.part(0.7, 1.0, name(Phase::Integrate))));
}

AcquisitionState withStatus(const AcquisitionState& state, std::int64_t scan, ScanStatus status,
                            const StepOptions& options, const Progress& progress) {
  AcquisitionState next = state;
  for (KeptScan& kept : next.scans)
    if (kept.number == scan) kept.status = status;
  next.model = integrateViews(viewsOf(next), options, progress);
  return next;
}

AcquisitionState placeStand(const AcquisitionState& state, int stand, const Pose& T_object_table,
                            const StepOptions& options, const Progress& progress) {
  AcquisitionState next = state;
  next.stands[static_cast<std::size_t>(stand)].T_object_table = T_object_table;
  const auto waits = [&](const KeptScan& scan) {
    return scan.status == ScanStatus::Waiting && scan.station().stand == stand;
  };
  const auto count = static_cast<double>(std::count_if(next.scans.begin(), next.scans.end(), waits));
  double done = 0.0;
  for (KeptScan& scan : next.scans) {
    if (!waits(scan)) continue;
    const Progress part = progress.part(done / count, (done + 1.0) / count);
    done += 1.0;
    scan.view.mesh = std::make_shared<const ViewMesh>(triangulate(*scan.view.image, options.triangulation));
    KeptScan placed = scan;
    const bool found = findPlace(next, placed, options, part.part(0.0, 0.3, name(Phase::Register)));
    const double before = next.model ? area(next.model->mesh) : 0.0;
    scan = std::move(placed);
    if (!found) continue;
    refine(next, options, part.part(0.3, 0.5, name(Phase::Register)));
    next.model = integrateViews(viewsOf(next), options, part.part(0.5, 1.0));
    scan.record.newArea = std::max(0.0, area(next.model->mesh) - before);
    scan.record.overlapArea = std::max(0.0, area(scan.view.mesh->mesh) - scan.record.newArea);
  }
  return next;
}

namespace {

// Whether a view is in the model that the table alone placed: errors of its moves would pile up beyond that.
bool reliesOnTable(const AcquisitionState& state) {
  return std::any_of(state.scans.begin(), state.scans.end(), [](const KeptScan& scan) {
    return scan.status == ScanStatus::In && scan.record.registration.finding.reason == VerdictReason::TableAlone;
  });
}

}  // namespace

PlanInput planInputOf(const AcquisitionState& state) {
  PlanInput input{state.profile, state.model, viewsOf(state), {}, {}, Pose::Identity()};
  if (const auto& T_object_table = state.stands.back().T_object_table) input.T_object_table = *T_object_table;
  for (const KeptScan* scan : scansOf(state, ScanStatus::In))
    if (scan->station().stand == state.stand() && scan->station().position)
      input.taken.push_back(*scan->station().position);
  if (const KeptScan* last = lastView(state, state.stand())) input.current = last->station().position;
  return input;
}

Plan planAfter(const AcquisitionState& state, const ScannerImages& images, const StepOptions& options,
               const Progress& progress) {
  if (!state.stands.back().T_object_table)
    throw InvalidInput("it is not known how the object stands, so no view can be planned");
  PlannerOptions planner = options.planner;
  if (reliesOnTable(state)) planner.tableAloneShare = 1.0;
  return planNextView(planInputOf(state), images, planner, progress);
}

}  // namespace vantage
