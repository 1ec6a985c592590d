#include "acquisition/scan_commands.h"

#include <algorithm>
#include <string>
#include <utility>

#include "acquisition/command_tools.h"
#include "acquisition/hand_placing.h"
#include "acquisition/import_scans.h"
#include "acquisition/other_turn.h"
#include "acquisition/stand_composites.h"
#include "acquisition/step_options.h"
#include "acquisition/steps.h"
#include "base/errors.h"
#include "scanner/triangulation.h"

namespace vantage {
namespace {

using Answer = std::optional<Refusal>;

void checkPosition(const AcquisitionState& state, const RangeImage& image) {
  const std::optional<int> position = image.station.position;
  const auto positions = static_cast<int>(state.profile->workspace.size());
  if (!position || *position < 0 || *position >= positions)
    throw InvalidInput((position ? "position " + std::to_string(*position) + " of the scan does not exist"
                                 : std::string("the scan is of no position")) +
                       ", the workspace has positions 0 to " + std::to_string(positions - 1));
}

// Whether a person took over from a table, or a table from a person: a plan counts on who made the last move.
bool changedHands(const AcquisitionState& before, const AcquisitionState& after) {
  if (!before.plan || before.scans.empty()) return false;
  return turnedByGuess(*before.scans.back().view.image) != turnedByGuess(*after.scans.back().view.image);
}

// Where the scans fit that an import refused, of those whose position was said.
void nameOtherTurns(AcquisitionState& state, const Progress& progress) {
  if (!state.profile || !state.model) return;
  const StepOptions options = stepOptionsFor(state);
  std::vector<KeptScan*> refused;
  for (KeptScan& scan : state.scans)
    if (scan.status == ScanStatus::Rejected && scan.station().position && scan.view.image->sampleCount() > 0)
      refused.push_back(&scan);
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(refused.size(), 1));
  for (std::size_t i = 0; i < refused.size(); ++i) {
    const double done = share * static_cast<double>(i);
    const Progress part = progress.part(done, done + share);
    KeptScan& scan = *refused[i];
    KeptScan again = scan;
    again.view.T_object_scanner = tableOf(state, scan.station().stand) * scan.view.image->T_table_scanner;
    again.view.mesh =
        std::make_shared<const ViewMesh>(triangulate(*scan.view.image, options.triangulation, part.part(0.0, 0.1)));
    if (again.view.mesh->mesh.empty()) continue;
    if (auto elsewhere = otherTurnOf(state, again, options, part.part(0.1, 1.0)))
      scan.record.registration.finding = std::move(*elsewhere);
  }
}

}  // namespace

Answer AddScan::mayDo(const AcquisitionState& state) const {
  if (findScan(state, scan) != nullptr) return Refusal{RefusalReason::ScanUsed, scan};
  return state.profile ? Answer() : Refusal{RefusalReason::NoProfile, {}};
}

AcquisitionState AddScan::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  PhaseTimer timer;
  const Progress watched = timer.watch(tools.progress());
  const auto image = tools.input().scan(scan);
  checkPosition(state, *image);
  AcquisitionState next = addScan(state, {scan, image}, predicted, stepOptionsFor(state), watched.part(0.0, 0.5));
  next.chosenPosition.reset();
  next.termination = Termination::Running;
  if (next.scans.back().status != ScanStatus::In)
    return changedHands(state, next) ? tools.replanned(std::move(next)) : CommandTools::judged(std::move(next));
  next = tools.planned(std::move(next), watched.part(0.5, 1.0));
  ScanRecord& record = next.scans.back().record;
  record.planAfter = next.plan;
  record.seconds = timer.finish();
  record.seconds.insert(tools.input().before.begin(), tools.input().before.end());
  return CommandTools::judged(std::move(next));
}

Answer ImportScans::mayDo(const AcquisitionState& state) const {
  if (!state.scans.empty()) return Refusal{RefusalReason::ScansBefore, {}};
  return scans.empty() ? Refusal{RefusalReason::NoScans, {}} : Answer();
}

AcquisitionState ImportScans::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  std::vector<NumberedScan> numbered;
  for (const std::int64_t scan : scans) numbered.push_back({scan, tools.input().scan(scan)});
  const Progress progress = tools.progress();
  AcquisitionState next = importScans(state, numbered, importOptionsFor(state), progress.part(0.0, 0.9));
  for (std::size_t i = 0; i < readings.size() && i < next.scans.size(); ++i) next.scans[i].record.reading = readings[i];
  nameOtherTurns(next, progress.part(0.9, 1.0, name(Phase::Register)));
  return next;
}

Answer LeaveOutView::mayDo(const AcquisitionState& state) const {
  const KeptScan* kept = findScan(state, scan);
  if (kept == nullptr || kept->status != ScanStatus::In) return Refusal{RefusalReason::NotAView, scan};
  return countScans(state, ScanStatus::In) == 1 ? Refusal{RefusalReason::OnlyView, scan} : Answer();
}

AcquisitionState LeaveOutView::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  return tools.replanned(withStatus(state, scan, ScanStatus::LeftOut, stepOptionsFor(state), tools.firstHalf()));
}

Answer TakeBackView::mayDo(const AcquisitionState& state) const {
  const KeptScan* kept = findScan(state, scan);
  if (kept == nullptr || kept->status != ScanStatus::LeftOut) return Refusal{RefusalReason::NotLeftOut, scan};
  const bool inWork = compositeOf(state, kept->station().stand) == compositeInWork(state);
  return inWork ? Answer() : Refusal{RefusalReason::OtherStand, scan};
}

AcquisitionState TakeBackView::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  return tools.replanned(withStatus(state, scan, ScanStatus::In, stepOptionsFor(state), tools.firstHalf()));
}

Answer TakeAsFrom::mayDo(const AcquisitionState& state) const {
  if (!state.profile) return Refusal{RefusalReason::NoProfile, {}};
  const KeptScan* kept = findScan(state, scan);
  if (kept == nullptr || !fitsTurn(state, *kept, tableDeg)) return Refusal{RefusalReason::FitsNoOtherTurn, scan};
  const bool inWork = compositeOf(state, kept->station().stand) == compositeInWork(state);
  return inWork ? Answer() : Refusal{RefusalReason::OtherStand, scan};
}

AcquisitionState TakeAsFrom::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  AcquisitionState next = takeAsFrom(state, scan, tableDeg, stepOptionsFor(state), tools.firstHalf());
  next.chosenPosition.reset();
  if (next.termination != Termination::Imported) next.termination = Termination::Running;
  return tools.replanned(std::move(next));
}

Answer TakeOver::mayDo(const AcquisitionState& /*state*/) const {
  return Refusal{RefusalReason::NotReplayable, {}};
}

AcquisitionState TakeOver::carriedOut(const AcquisitionState& state, const CommandTools& /*tools*/) const {
  return state;
}

}  // namespace vantage
