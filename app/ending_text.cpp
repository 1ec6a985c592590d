#include "ending_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "planning/choice.h"
#include "why_card.h"
#include "wording.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Ending)
};

// The most that a position which may be scanned from would show.
QString stillShown(const AcquisitionState& state) {
  if (!state.plan || state.plan->outcome != PlanOutcome::Found) return {};
  const PositionScore& best = state.plan->scores[static_cast<std::size_t>(state.plan->position.value())];
  return Text::tr(" Position %1 would still show %2.").arg(best.position).arg(areaText(promise(best)));
}

}  // namespace

QString endingText(const AcquisitionState& state) {
  if (state.termination == Termination::Finished && !state.plan)
    return Text::tr("Ended: the views that were asked for are taken.");
  const QString text = terminationText(state.termination);
  const bool byChoice = state.termination == Termination::MaxViews || state.termination == Termination::EndedByOperator;
  return byChoice ? text + stillShown(state) : text;
}

QString failedScanText(const AcquisitionState& state) {
  if (state.scans.empty() || state.scans.back().status != ScanStatus::Rejected) return {};
  const KeptScan& scan = state.scans.back();
  const QString where =
      scan.station().position ? Text::tr(" from position %1").arg(*scan.station().position) : QString();
  return Text::tr("Scan %1%2 did not fit: %3. It is kept, but not part of the model.")
      .arg(QString::number(scan.number), where, findingText(scan.record.registration.finding));
}

}  // namespace vantage
