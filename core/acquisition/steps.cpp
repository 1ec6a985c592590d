#include "acquisition/steps.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "acquisition/erased_regions.h"
#include "acquisition/hand_placing.h"
#include "acquisition/loop_closing.h"
#include "acquisition/other_turn.h"
#include "acquisition/prepared_scans.h"
#include "acquisition/scan_placing.h"
#include "acquisition/stand_composites.h"
#include "base/errors.h"
#include "geometry/measures.h"
#include "integration/zipper.h"
#include "registration/prepared_refinement.h"
#include "registration/registration_scale.h"

namespace vantage {
namespace {

// How firmly a view is held of which nobody knows where it is: surfaces that hold it are many times firmer.
constexpr Mechanics kLooseHold{radians(2.0), 5.0};

// Loose views stay about where they were registered: along what holds them too little noise alone would move them, the
// farther the more views there are.
void tieLooseViews(const AcquisitionState& state, std::vector<PoseTie>& ties) {
  const std::vector<const KeptScan*> scans = scansOf(state, ScanStatus::In);
  for (std::size_t i = 1; i < scans.size(); ++i) {
    if (!isLoose(*scans[i])) continue;
    const Pose T_from_to = scans[0]->view.T_object_scanner.inverse() * scans[i]->record.registration.T_object_scanner;
    const Pose T_object_table = tableOf(state, scans[i]->station().stand);
    ties.push_back({0, i, T_from_to, aboutTable(turntablePrior(kLooseHold), T_object_table)});
  }
}

// The pose of a doubtful view that all others together hold as firmly as a good one is certain.
void liftDoubt(KeptScan& scan, const ViewSurface& surface, double poseSigma, const StepOptions& options) {
  RegistrationResult& registration = scan.record.registration;
  if (!waitsForMore(registration) || turnedByGuess(*scan.view.image)) return;
  if (poseSigma > *resolved(options.registration, scaleOf(surface)).limits.maxPoseSigma) return;
  registration.verdict = Verdict::Good;
  registration.finding = {VerdictReason::HeldByAll, std::nullopt, {}};
  registration.poseSigma = poseSigma;
}

void checkStation(const AcquisitionState& state, const KeptScan& scan) {
  const int stand = scan.station().stand;
  if (stand < 0 || stand > state.stand())
    throw InvalidInput("scan " + std::to_string(scan.number) + " is of stand " + std::to_string(stand) +
                       ", the object has stood in stands 0 to " + std::to_string(state.stand()));
}

AcquisitionState withWaiting(const AcquisitionState& state, KeptScan scan) {
  AcquisitionState next = state;
  scan.status = ScanStatus::Waiting;
  scan.view.mesh = nullptr;
  next.scans.push_back(std::move(scan));
  return next;
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

// Looks again, with the views that came meanwhile, for the place of the scans that a person turned and that found none.
// @return whether one did
bool placeRejected(AcquisitionState& state, const StepOptions& options, const Progress& progress) {
  bool placed = false;
  for (KeptScan& scan : state.scans) {
    if (scan.status != ScanStatus::Rejected || !turnedByGuess(*scan.view.image)) continue;
    if (compositeOf(state, scan.station().stand) != compositeInWork(state)) continue;
    KeptScan again = scan;
    again.view.mesh = std::make_shared<const ViewMesh>(triangulate(*scan.view.image, options.triangulation, progress));
    if (again.view.mesh->mesh.empty() || !findPlaceAgain(state, again, options, progress) || isLoose(again)) continue;
    scan = std::move(again);
    placed = true;
  }
  return placed;
}

// What a view shows of the object [mm^2].
double objectArea(const View& view, const ErasedSpace& erased) {
  return area(withoutErased(view, erased).mesh->mesh);
}

// After views found another place: what one of them brought counts from the model before.
AcquisitionState withNewModel(AcquisitionState state, std::size_t added, const StepOptions& options,
                              const Progress& progress) {
  const double before = area(state.model->mesh);
  refineModelViews(state, options, progress.part(0.0, 0.2));
  state.model = integrateViews(viewsOf(state), state.stands, options, progress.part(0.2, 1.0));
  ScanRecord& record = state.scans[added].record;
  record.newArea = std::max(0.0, area(state.model->mesh) - before);
  record.overlapArea = std::max(0.0, objectArea(state.scans[added].view, erasedSpaceOf(state.stands)) - record.newArea);
  return state;
}

// With what a view that was added tells of scans that a person turned, and what those tell of further ones.
AcquisitionState withScansPlaced(AcquisitionState state, std::size_t added, const StepOptions& options,
                                 const Progress& progress) {
  if (isLoose(state.scans[added]) || !turnedByGuess(*state.scans[added].view.image)) return state;
  while (placeRejected(state, options, progress.part(0.0, 0.5)))
    state = withNewModel(std::move(state), added, options, progress.part(0.5, 1.0));
  return state;
}

}  // namespace

void refineModelViews(AcquisitionState& state, const StepOptions& options, const Progress& progress) {
  const std::vector<View> whole = viewsOf(state);
  if (whole.size() < 2) return;
  const std::vector<View> views = viewsToIntegrate(whole, erasedSpaceOf(state.stands));
  const std::vector<PreparedView> prepared =
      preparedViews(scansOf(state, ScanStatus::In), views, progress.part(0.0, 0.1, "refine"));
  MultiViewOptions refinement = options.refinement;
  refinement.ties = tiesOf(state, options);
  tieLooseViews(state, refinement.ties);
  const MultiViewResult refined = refinePrepared(views, prepared, refinement, progress.part(0.1, 0.8));
  std::size_t i = 0;
  for (KeptScan& scan : state.scans) {
    if (scan.status != ScanStatus::In) continue;
    scan.view.T_object_scanner = refined.poses[i];
    liftDoubt(scan, prepared[i].surface, refined.poseSigmas[i], options);
    ++i;
  }
  liftClosedLoops(state, prepared, refined, options, progress.part(0.8, 1.0));
}

AcquisitionState addScan(const AcquisitionState& state, const NumberedScan& scan,
                         std::optional<PositionScore> predicted, const StepOptions& options, const Progress& progress) {
  const Progress registering = progress.part(0.0, 0.5, name(Phase::Register));
  registering.checkpoint(0.0);
  KeptScan added = keepAsView(scan, {options.cut, options.thinning}, options.triangulation, raysOfLast(state.scans),
                              registering.part(0.0, 0.1));
  checkStation(state, added);
  const int composite = compositeOf(state, added.station().stand);
  if (composite != compositeOf(state, state.stand())) return withWaiting(state, std::move(added));
  AcquisitionState next = withComposite(state, composite);
  const std::shared_ptr<const Model> known = next.model;
  if (added.view.mesh->mesh.empty() && !known) refuseEmpty(added);
  if (known) prepareScans(next, added, registering.part(0.1, 0.2));
  const bool found = findPlace(next, added, options, registering.part(0.2, 0.7));
  added.record.predicted = std::move(predicted);
  next.scans.push_back(std::move(added));
  if (!found) return next;
  refineModelViews(next, options, registering.part(0.7, 0.9));
  const std::size_t last = next.scans.size() - 1;
  if (!isLoose(next.scans.back()) && settleLooseViews(next, options, registering.part(0.9, 1.0)))
    return withScansPlaced(withNewModel(std::move(next), last, options, progress.part(0.5, 0.9)), last, options,
                           progress.part(0.9, 1.0));

  const Progress integrating = progress.part(0.5, 1.0, name(Phase::Integrate));
  const ErasedSpace erased = erasedSpaceOf(next.stands);
  const std::vector<View> views = viewsToIntegrate(viewsOf(next), erased);
  integrating.checkpoint(0.0);
  const Model before = known ? reposed(*known, views) : Model{};
  integrating.checkpoint(0.0);
  Integration integration = integrateView(before, views, static_cast<std::uint32_t>(views.size() - 1), options.zipper,
                                          integrating.part(0.0, 0.6));
  integration.model = withoutErased(integration.model, views, erased);
  next.model = std::make_shared<const Model>(withoutErased(
      applyConsensus(integration.model, views, options.consensus, integrating.part(0.6, 0.9)), views, erased));
  if (!known && next.model->mesh.triangles.empty()) refuseEmpty(next.scans.back());
  integrating.checkpoint(0.9);
  ScanRecord& record = next.scans.back().record;
  record.newArea = std::max(0.0, area(integration.model.mesh) - area(before.mesh));
  record.overlapArea = std::max(0.0, objectArea(views.back(), erased) - record.newArea);
  return withScansPlaced(std::move(next), last, options, integrating.part(0.9, 1.0));
}

std::shared_ptr<const Model> integrateViews(const std::vector<View>& whole, const std::vector<Stand>& stands,
                                            const StepOptions& options, const Progress& progress) {
  const ErasedSpace erased = erasedSpaceOf(stands);
  const std::vector<View> views = viewsToIntegrate(whole, erased);
  const Integration integration = zipper(views, options.zipper, progress.part(0.0, 0.7, name(Phase::Integrate)));
  const Model model =
      applyConsensus(integration.model, views, options.consensus, progress.part(0.7, 1.0, name(Phase::Integrate)));
  return std::make_shared<const Model>(withoutErased(model, views, erased));
}

AcquisitionState withStatus(const AcquisitionState& state, std::int64_t scan, ScanStatus status,
                            const StepOptions& options, const Progress& progress) {
  AcquisitionState next = state;
  for (KeptScan& kept : next.scans)
    if (kept.number == scan) kept.status = status;
  next.model = integrateViews(viewsOf(next), next.stands, options, progress);
  if (next.model->mesh.triangles.empty())
    throw InvalidInput("without scan " + std::to_string(scan) + " nothing is left of the model but what was erased");
  return next;
}

AcquisitionState takeAsFrom(const AcquisitionState& state, std::int64_t scan, double tableDeg,
                            const StepOptions& options, const Progress& progress) {
  AcquisitionState next = state;
  const auto taken =
      std::find_if(next.scans.begin(), next.scans.end(), [&](const KeptScan& k) { return k.number == scan; });
  KeptScan placed = *taken;
  placed.view.mesh =
      std::make_shared<const ViewMesh>(triangulate(*placed.view.image, options.triangulation, progress.part(0.0, 0.1)));
  if (!placedAtTurn(state, placed, tableDeg, options, progress.part(0.1, 0.4)))
    throw InvalidInput("scan " + std::to_string(placed.number) + " does not fit at " +
                       std::to_string(std::lround(tableDeg)) +
                       " degrees of the table with the model as it is now: scan from there once more");
  *taken = std::move(placed);
  const auto added = static_cast<std::size_t>(taken - next.scans.begin());
  next = withNewModel(std::move(next), added, options, progress.part(0.4, 0.8));
  return withScansPlaced(std::move(next), added, options, progress.part(0.8, 1.0));
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
  PlanInput input{state.profile, state.model, viewsOf(state), {}, {}, tableOf(state, state.stand())};
  for (const KeptScan* scan : scansOf(state, ScanStatus::In))
    if (scan->station().stand == state.stand() && scan->station().position)
      input.taken.push_back(*positionTaken(state, *scan));
  if (const KeptScan* last = lastView(state, state.stand())) input.current = positionTaken(state, *last);
  for (const KeptScan* scan : scansOf(state, ScanStatus::In))
    if (const auto& predicted = scan->record.predicted; predicted && predicted->uncorrected)
      input.ledger.push_back({*predicted->uncorrected, scan->record.newArea});
  if (const ErasedSpace erased = erasedSpaceOf(state.stands); erased.isIn(state.stand())) {
    input.erased.space = erased;
    input.erased.stand = state.stand();
    input.erased.border = erasedBorderNow(state);
    input.erased.surface = std::make_shared<const Mesh>(erasedSurface(input.views, state.stand(), erased));
  }
  // Whoever made the last move makes the next one.
  if (!state.scans.empty()) input.mechanics = state.scans.back().view.image->poseUncertainty;
  return input;
}

Plan planAfter(const AcquisitionState& state, const ScannerImages& images, const StepOptions& options,
               const Progress& progress) {
  PlannerOptions planner = options.planner;
  if (reliesOnTable(state)) planner.tableAloneShare = 1.0;
  return planNextView(planInputOf(state), images, planner, progress);
}

}  // namespace vantage
